#include "radiosity/patches.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/random.h"
#include "radiosity/faces.h"
#include "radiosity/quarter.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

using Corners3 = std::array<Vec3, 3>;

constexpr float kLargeFace = 4;   // smallest face that is looked at, in details
constexpr float kFirstPatch = 4;  // largest patch that is not split unseen, in details
constexpr float kReach = 8;       // of a ray, in details
constexpr std::uint32_t kRays = 32;
constexpr int kMostLevels = 10;
// A patch from which no more than the first share of its hemispheres is open is covered, from the second on it is
// exposed: a floor's edge between two walls must be.
constexpr float kCovered = 0.02F, kExposed = 0.2F;
constexpr float kSame = 0.1F;  // difference of exposure below which patches are one

float longest_edge(const Corners3& c) {
    return std::sqrt(std::max({length_squared(c[1] - c[0]), length_squared(c[2] - c[1]), length_squared(c[0] - c[2])}));
}

class PatchBuilder {
  public:
    PatchBuilder(const RayTracer& tracer, float detail, Vec3 normal) : tracer_(tracer), detail_(detail), frame_(normal), normal_(normal) {}

    // The tree's patches, root first, first_child counted from there.
    std::vector<Patch> build(const Corners3& corners, std::uint64_t seed) {
        patches_.assign(1, {});
        fill(0, corners, seed, 0);
        return std::move(patches_);
    }

  private:
    // Share of the hemispheres above a patch in which nothing is near.
    float open_share(const Corners3& c, std::uint64_t seed) const {
        const Sequence4 sequence(seed);
        std::array<Ray, kRays> rays;
        std::array<std::uint8_t, kRays> blocked{};
        const float reach = kReach * detail_;
        for (std::uint32_t k = 0; k < kRays; ++k) {
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
            const Vec2 disk = square_to_disk(sequence(k, 2), sequence(k, 3));
            const float z = std::sqrt(std::max(0.0F, 1 - dot(disk, disk)));
            rays[k] = {offset_origin(w.x * c[0] + w.y * c[1] + w.z * c[2], normal_, reach),
                       frame_.to_world({disk.x, disk.y, z}), 0, reach};
        }
        tracer_.occluded(rays, blocked, RayMask::kLight, Coherence::kIncoherent);
        return 1 - static_cast<float>(std::count(blocked.begin(), blocked.end(), 1)) / kRays;
    }

    void fill(std::size_t patch, const Corners3& c, std::uint64_t seed, int level) {
        const float size = longest_edge(c);
        if (size <= kFirstPatch * detail_ || level == kMostLevels) {
            const float open = open_share(c, seed);
            const float exposed = std::clamp((open - kCovered) / (kExposed - kCovered), 0.0F, 1.0F);
            if (open == 0 || open == 1 || size <= detail_ || level == kMostLevels) {
                patches_[patch].exposure = exposed;
                return;
            }
        }
        const std::size_t first = patches_.size();
        patches_.resize(first + kQuarters);
        float sum = 0, least = 1, most = 0;
        bool leaves = true;
        for (int quarter = 0; quarter < kQuarters; ++quarter) {
            fill(first + quarter, quarter_of(c, quarter), hash64(seed, quarter), level + 1);
            const float exposure = patches_[first + quarter].exposure;
            sum += exposure;
            least = std::min(least, exposure);
            most = std::max(most, exposure);
            leaves = leaves && patches_[first + quarter].first_child == kNone;
        }
        patches_[patch].exposure = sum / kQuarters;
        if (leaves && most - least <= kSame) {
            patches_.resize(first);
        } else {
            patches_[patch].first_child = static_cast<std::uint32_t>(first);
        }
    }

    const RayTracer& tracer_;
    float detail_;
    Frame frame_;
    Vec3 normal_;
    std::vector<Patch> patches_;
};

std::uint64_t key_of(std::uint32_t instance, std::uint32_t triangle, bool back) {
    return (static_cast<std::uint64_t>(instance) << 33) | (static_cast<std::uint64_t>(triangle) << 1) | (back ? 1 : 0);
}

struct Side {
    std::uint32_t instance, triangle;
    bool back;
};

std::vector<Side> large_faces(const Scene& scene, std::span<const std::uint32_t> instances, float least,
                              const Control& control) {
    std::vector<std::vector<Side>> found(instances.size());
    parallel_for(instances.size(), 1, control, [&](std::size_t i) {
        const std::uint32_t instance = instances[i];
        if (scene.instances[instance].bounds.diameter() < least) {
            return;
        }
        const auto count = static_cast<std::uint32_t>(scene.meshes[scene.instances[instance].mesh].triangles.size());
        for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
            if (longest_edge(world_triangle(scene, instance, triangle)) < least ||
                !(length(world_area_vector(scene, instance, triangle)) > 0)) {
                continue;
            }
            const Sides sides = scene.sides_of(instance, triangle);
            for (const bool back : {false, true}) {
                if (sides == Sides::kBoth || back == (sides == Sides::kBack)) {
                    found[i].push_back({instance, triangle, back});
                }
            }
        }
    });
    std::vector<Side> all;
    for (const auto& part : found) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

}  // namespace

std::uint32_t PatchForest::root(std::uint32_t instance, std::uint32_t triangle, bool back) const {
    const auto found = roots.find(key_of(instance, triangle, back));
    return found == roots.end() ? kNone : found->second;
}

PatchForest find_patches(const Scene& scene, std::span<const std::uint32_t> instances, float detail,
                         const RayTracer& tracer, const Control& control) {
    PatchForest forest;
    if (!(detail > 0)) {
        return forest;
    }
    forest.reach = kReach * detail;
    const std::vector<Side> sides = large_faces(scene, instances, kLargeFace * detail, control);
    std::vector<std::vector<Patch>> trees(sides.size());
    parallel_for(sides.size(), 1, control, [&](std::size_t i) {
        const auto [instance, triangle, back] = sides[i];
        const Vec3 front = normalize_or_zero(world_area_vector(scene, instance, triangle));
        PatchBuilder builder(tracer, detail, back ? -front : front);
        const std::uint64_t seed = hash64(scene.instances[instance].stable_id, 2 * triangle + (back ? 1 : 0));
        trees[i] = builder.build(world_triangle(scene, instance, triangle), seed);
    });
    for (std::size_t i = 0; i < sides.size(); ++i) {
        if (trees[i].size() == 1) {
            continue;
        }
        const auto base = static_cast<std::uint32_t>(forest.patches.size());
        forest.roots.emplace(key_of(sides[i].instance, sides[i].triangle, sides[i].back), base);
        for (Patch patch : trees[i]) {
            patch.first_child += patch.first_child == kNone ? 0 : base;
            forest.patches.push_back(patch);
        }
    }
    return forest;
}

}  // namespace gg
