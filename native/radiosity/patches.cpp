#include "radiosity/patches.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/parallel.h"
#include "core/random.h"
#include "radiosity/faces.h"
#include "radiosity/quarter.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

using Corners3 = std::array<Vec3, 3>;

constexpr float kLargeFace = 4;          // smallest face that is looked at, in details
constexpr float kFirstPatch = 4;         // largest patch that is not split unseen, in details
constexpr float kReach = 8;              // of a ray, in details
constexpr std::uint32_t kRays = 24;      // to see whether some part may be covered
constexpr std::uint32_t kMostRays = 40;  // to measure by how much
constexpr int kMostLevels = 10;
// A patch from which no more than the first share of its hemispheres is open is covered, from the second on it is
// exposed: a floor's edge between two walls must be.
constexpr float kCovered = 0.03F, kExposed = 0.3F;
constexpr float kSame = 0.1F;  // difference of exposure below which patches are one

float longest_edge(const Corners3& c) {
    return std::sqrt(std::max({length_squared(c[1] - c[0]), length_squared(c[2] - c[1]), length_squared(c[0] - c[2])}));
}

class PatchBuilder {
  public:
    PatchBuilder(const RayTracer& tracer, float detail, Vec3 normal)
        : tracer_(tracer), detail_(detail), frame_(normal), normal_(normal) {}

    // The tree's patches, root first, first_child counted from there.
    std::vector<Patch> build(const Corners3& corners, std::uint64_t seed) {
        patches_.assign(1, {});
        fill(0, corners, seed, 0);
        return std::move(patches_);
    }

  private:
    // How many of the rays [first, last) from each quarter of the patch get away; both multiples of four.
    std::array<int, kQuarters> open_rays(const Corners3& patch, const Sequence4& sequence, std::uint32_t first,
                                         std::uint32_t last) const {
        std::array<Ray, kMostRays> rays;
        std::array<std::uint8_t, kMostRays> blocked{};
        const float reach = kReach * detail_;
        for (std::uint32_t k = first; k < last; ++k) {
            const Corners3 c = quarter_of(patch, static_cast<int>(k % kQuarters));
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
            const Vec3 direction = square_to_cosine_hemisphere(sequence(k, 2), sequence(k, 3));
            rays[k - first] = {offset_origin(w.x * c[0] + w.y * c[1] + w.z * c[2], normal_, reach),
                               frame_.to_world(direction), 0, reach};
        }
        const std::size_t count = last - first;
        tracer_.occluded(std::span<const Ray>(rays.data(), count), std::span<std::uint8_t>(blocked.data(), count),
                         RayMask::kLight, Coherence::kIncoherent);
        std::array<int, kQuarters> open{};
        for (std::size_t k = 0; k < count; ++k) {
            open[k % kQuarters] += blocked[k] ? 0 : 1;
        }
        return open;
    }

    void fill(std::size_t patch, const Corners3& c, std::uint64_t seed, int level) {
        const float size = longest_edge(c);
        if (size <= kFirstPatch * detail_ || level == kMostLevels) {
            const Sequence4 sequence(seed);
            const std::array<int, kQuarters> open = open_rays(c, sequence, 0, kRays);
            const auto [least, most] = std::minmax_element(open.begin(), open.end());
            if (*least > 0) {  // no part of it is covered
                return;
            }
            if (size <= detail_ || level == kMostLevels || *most == 0) {
                const std::array<int, kQuarters> more = open_rays(c, sequence, kRays, kMostRays);
                const int all = std::accumulate(open.begin(), open.end(), std::accumulate(more.begin(), more.end(), 0));
                const float share = static_cast<float>(all) / kMostRays;
                patches_[patch].exposure = std::clamp((share - kCovered) / (kExposed - kCovered), 0.0F, 1.0F);
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
                if (has_side(sides, back)) {
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
