// How much of shading's time its rays take: neighbouring fragments of a picture are shaded as a render does, and the
// same rays are traced again by themselves, in the same packets.
//
// Counters: rays per second of both, and `of_rays`, the share of shading's time that the rays alone take, which is also
// its rate over theirs. Both are measured by turns, so that what else runs on the machine slows both.
#include <benchmark/benchmark.h>

#include <chrono>
#include <vector>

#include "support/gather_scenes.h"
#include "support/grid_picture.h"

namespace gg::test {
namespace {

constexpr std::size_t kTogether = 32;      // fragments, as in a render
constexpr std::size_t kEveryBlock = 8;     // that is shaded
constexpr std::uint32_t kLeaves = 40'000;  // of one of three clouds

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

struct Times {
    double shading = 0, visibility = 0, near = 0;  // s
    std::size_t visibility_rays = 0, near_rays = 0;

    [[nodiscard]] double rays() const { return visibility + near; }
};

// Blocks of neighbouring fragments with the sites around them.
std::vector<std::vector<PlacedFragment>> blocks_of(const GridPicture& picture) {
    std::vector<std::vector<PlacedFragment>> blocks;
    std::size_t block = 0;
    for (const TileFragments& tile : picture.tiles) {
        for (std::size_t begin = 0; begin < tile.fragments.size(); begin += kTogether) {
            if (block++ % kEveryBlock == 0) {
                blocks.emplace_back();
                for (std::size_t f = begin; f < std::min(begin + kTogether, tile.fragments.size()); ++f) {
                    blocks.back().push_back(picture.place(tile.fragments[f]));
                }
            }
        }
    }
    return blocks;
}

// Shades a block and traces its rays once more, in the way that suits them best.
void add(const GridPicture& picture, Shader& shader, std::span<const PlacedFragment> block, Times& times) {
    std::vector<PointLight> light(block.size());
    std::vector<PointCounts> taken(block.size());
    auto start = Clock::now();
    shader.shade(block, light, taken);
    times.shading += seconds_since(start);

    const auto visibility = shader.visibility_rays(), near = shader.near_rays();
    std::vector<std::uint8_t> blocked(visibility.size());
    std::vector<Hit> hits(near.size());
    double fastest = kInfinity;
    for (const Coherence coherence : {Coherence::kCoherent, Coherence::kIncoherent}) {
        start = Clock::now();
        picture.prepared.tracer->occluded(visibility, blocked, RayMask::kLight, coherence);
        fastest = std::min(fastest, seconds_since(start));
    }
    times.visibility += fastest;
    start = Clock::now();
    picture.prepared.tracer->closest_hits(near, hits, RayMask::kLight, Coherence::kIncoherent);
    times.near += seconds_since(start);
    times.visibility_rays += visibility.size();
    times.near_rays += near.size();
    benchmark::DoNotOptimize(light.data());
    benchmark::DoNotOptimize(blocked.data());
    benchmark::DoNotOptimize(hits.data());
}

void shading(benchmark::State& state, const ViewedScene& scene) {
    PictureSettings settings;
    settings.width = 240;
    settings.height = 120;
    settings.cell = 7;
    const GridPicture picture(scene.description, scene.camera, settings);
    const auto blocks = blocks_of(picture);
    Shader shader = picture.shader();
    Times times;
    for (auto _ : state) {
        const double before = times.shading;
        for (const auto& block : blocks) {
            add(picture, shader, block, times);
        }
        state.SetIterationTime(times.shading - before);
    }
    const auto visibility_rays = static_cast<double>(times.visibility_rays),
               near_rays = static_cast<double>(times.near_rays);
    state.counters["visibility_rays/s"] = visibility_rays / times.visibility;
    state.counters["near_rays/s"] = near_rays / times.near;
    state.counters["both/s"] = (visibility_rays + near_rays) / times.rays();
    state.counters["shaded/s"] = (visibility_rays + near_rays) / times.shading;
    state.counters["near_share"] = near_rays / (visibility_rays + near_rays);
    state.counters["of_rays"] = times.rays() / times.shading;
}

BENCHMARK_CAPTURE(shading, lamp_room, viewed_lamp_room())->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shading, window_room, viewed_window_room())->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shading, furnished_room, viewed_furnished_room())->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(shading, many_leaves, viewed_jungle(kLeaves))->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gg::test
