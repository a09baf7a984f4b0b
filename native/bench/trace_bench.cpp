// Rays per second against half a million triangles: a lumpy ground with boxes' worth of clutter above it.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "core/control.h"
#include "core/random.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg {
namespace {

constexpr std::size_t kRays = 1U << 14;

// 500 x 500 quads of rolling ground, [-1, 1]^2.
Mesh make_ground() {
    constexpr std::uint32_t kSide = 500;
    Mesh mesh;
    for (std::uint32_t y = 0; y <= kSide; ++y) {
        for (std::uint32_t x = 0; x <= kSide; ++x) {
            const float u = 2 * static_cast<float>(x) / kSide - 1;
            const float v = 2 * static_cast<float>(y) / kSide - 1;
            mesh.positions.push_back({u, v, 0.1F * std::sin(20 * u) * std::cos(17 * v)});
        }
    }
    for (std::uint32_t y = 0; y < kSide; ++y) {
        for (std::uint32_t x = 0; x < kSide; ++x) {
            const std::uint32_t corner = y * (kSide + 1) + x;
            mesh.triangles.push_back({corner, corner + 1, corner + kSide + 2});
            mesh.triangles.push_back({corner, corner + kSide + 2, corner + kSide + 1});
        }
    }
    return mesh;
}

Scene make_scene() {
    Scene scene;
    scene.meshes = {make_ground()};
    Instance instance;
    scene.instances = {instance};
    return scene;
}

struct Setup {
    Scene scene = make_scene();
    Control control;
    RayTracer tracer{scene, control};
};

const Setup& setup() {
    static const Setup instance;
    return instance;
}

std::vector<Ray> primary_rays() {
    std::vector<Ray> rays;
    for (std::size_t block = 0; block < kRays / 16; ++block) {  // squares of 4 x 4 neighbours
        for (std::size_t index = 0; index < 16; ++index) {
            const auto x = static_cast<float>(4 * (block % 32) + index % 4) / 64 - 1;
            const auto y = static_cast<float>(4 * (block / 32) + index / 4) / 64 - 1;
            rays.push_back({{0, -2, 1}, {0.6F * x, 1, 0.4F * y - 0.5F}});
        }
    }
    return rays;
}

Vec3 random_point(std::uint64_t id) {
    const Sequence4 point(id);
    return {2 * point(0, 0) - 1, 2 * point(0, 1) - 1, 0.3F * point(0, 2)};
}

std::vector<Ray> incoherent_rays() {
    std::vector<Ray> rays;
    for (std::size_t index = 0; index < kRays; ++index) {
        const Vec3 origin = random_point(2 * index);
        rays.push_back({origin, random_point(2 * index + 1) - origin, 1e-4F, 0.9999F});
    }
    return rays;
}

// Sixteen samples of one area lamp from each of many points.
std::vector<Ray> shadow_rays() {
    std::vector<Ray> rays;
    for (std::size_t point = 0; point < kRays / 16; ++point) {
        const Vec3 origin = random_point(point);
        for (std::uint32_t sample = 0; sample < 16; ++sample) {
            const Sequence4 lamp(1);
            const Vec3 target(0.3F * lamp(sample, 0), 0.3F * lamp(sample, 1), 1.5F);
            rays.push_back({origin, target - origin, 1e-4F, 0.9999F});
        }
    }
    return rays;
}

void count_rays(benchmark::State& state) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(kRays));
}

void closest_packets(benchmark::State& state, const std::vector<Ray>& rays, Coherence coherence) {
    std::vector<Hit> hits(rays.size());
    for (auto _ : state) {
        setup().tracer.closest_hits(rays, hits, RayMask::kCamera, coherence);
        benchmark::DoNotOptimize(hits.data());
    }
    count_rays(state);
}

void closest_single(benchmark::State& state, const std::vector<Ray>& rays) {
    for (auto _ : state) {
        for (const Ray& ray : rays) {
            benchmark::DoNotOptimize(setup().tracer.closest_hit(ray, RayMask::kCamera));
        }
    }
    count_rays(state);
}

void occluded_packets(benchmark::State& state, const std::vector<Ray>& rays, Coherence coherence) {
    std::vector<std::uint8_t> results(rays.size());
    for (auto _ : state) {
        setup().tracer.occluded(rays, results, RayMask::kLight, coherence);
        benchmark::DoNotOptimize(results.data());
    }
    count_rays(state);
}

void occluded_single(benchmark::State& state, const std::vector<Ray>& rays) {
    for (auto _ : state) {
        for (const Ray& ray : rays) {
            benchmark::DoNotOptimize(setup().tracer.occluded(ray, RayMask::kLight));
        }
    }
    count_rays(state);
}

void build(benchmark::State& state) {
    const Setup& scene = setup();
    for (auto _ : state) {
        const RayTracer tracer(scene.scene, scene.control);
        benchmark::DoNotOptimize(tracer.bytes());
    }
}

BENCHMARK(build)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(closest_packets, primary, primary_rays(), Coherence::kCoherent);
BENCHMARK_CAPTURE(closest_packets, primary_not_told, primary_rays(), Coherence::kIncoherent);
BENCHMARK_CAPTURE(closest_single, primary, primary_rays());
BENCHMARK_CAPTURE(closest_packets, incoherent, incoherent_rays(), Coherence::kIncoherent);
BENCHMARK_CAPTURE(closest_single, incoherent, incoherent_rays());
BENCHMARK_CAPTURE(occluded_packets, shadow, shadow_rays(), Coherence::kCoherent);
BENCHMARK_CAPTURE(occluded_packets, shadow_not_told, shadow_rays(), Coherence::kIncoherent);
BENCHMARK_CAPTURE(occluded_single, shadow, shadow_rays());
BENCHMARK_CAPTURE(occluded_packets, incoherent, incoherent_rays(), Coherence::kIncoherent);
BENCHMARK_CAPTURE(occluded_single, incoherent, incoherent_rays());

}  // namespace
}  // namespace gg
