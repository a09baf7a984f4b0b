#include "radiosity/exposure.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "core/random.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::size_t kSides = 8;         // of a group that look around, each for its neighbours, too
constexpr float kEnough = 6, kMost = 32;  // from a group of the size of a detail, and from a large one
constexpr float kDetail = 1.0F / 128;     // share of the scene's size
constexpr float kClose = 0.1F;            // what blocks all rays from a side so close covers it; as kRoom
constexpr float kRoom = 0.5F;             // how far a ray must get, as a share of the instance's size
// Whose hemisphere is open by no more than the first share gets next to no light from outside, by the second and more
// about as much as any [measured: armchair, sofa, dresser, books, bear, peace lily of the furnished room].
constexpr float kCovered = 0.13F, kExposed = 0.5F;
constexpr float kLeast = 1.0F / 64;  // of a covered face: no cluster is without any area
constexpr std::size_t kGroups = 64;  // whose rays are traced together

// Looks around on groups of faces of one instance, many at a time.
class Surveyor {
  public:
    Surveyor(const Scene& scene, std::uint32_t instance, const FaceGroups& groups, float scene_size,
             const RayTracer& tracer)
        : scene_(scene),
          instance_(instance),
          groups_(groups),
          tracer_(tracer),
          reach_(kRoom * scene.instances[instance].bounds.diameter()),
          detail_(std::max(kDetail * scene_size, 1e-30F)) {}

    // Appends the groups [begin, end), those of whose sides some are covered in two parts; sets the exposure of their
    // faces.
    void survey(std::size_t begin, std::size_t end, FaceGroups::Builder& out, std::vector<Exposure>& exposure) {
        for (std::size_t i = begin; i < end; ++i) {
            add_rays(groups_[i]);
        }
        hits_.resize(rays_.size());
        tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
        std::size_t first = 0;
        for (std::size_t i = begin; i < end; ++i) {
            const std::span<const FaceSide> sides = groups_[i];
            const auto [stride, count] = plan_for(sides);
            for (const bool covered : {false, true}) {
                std::uint32_t rays = 0, blocked = 0;
                chosen_.clear();
                for (std::size_t side = 0; side < sides.size(); ++side) {
                    const auto [far, close] = count_blocked(first + side / stride * count, count);
                    if ((close == count) == covered) {
                        chosen_.push_back(sides[side]);
                        rays += count;
                        blocked += far;
                    }
                }
                if (!chosen_.empty()) {
                    set(1 - static_cast<float>(blocked) / static_cast<float>(rays), exposure);
                    out.add(chosen_);
                }
            }
            first += (sides.size() + stride - 1) / stride * count;
        }
    }

  private:
    struct Blocked {
        std::uint32_t far = 0, close = 0;  // rays that the instance blocks, and does within a short distance
    };

    // Which sides of a group look around, and by how many rays each.
    struct Plan {
        std::size_t stride = 1;
        std::uint32_t rays = 1;
    };

    // Large faces become elements of their own, and must not be taken for covered by chance.
    Plan plan_for(std::span<const FaceSide> sides) const {
        float area = 0;
        for (const FaceSide& side : sides) {
            area += length(world_area_vector(scene_, instance_, side.triangle));
        }
        const std::size_t stride = (sides.size() + kSides - 1) / kSides;
        const auto count = static_cast<float>((sides.size() + stride - 1) / stride);
        const float wanted = std::clamp(kEnough * std::sqrt(area) / detail_, kEnough, kMost);
        return {stride, static_cast<std::uint32_t>(std::ceil(wanted / count))};
    }

    void add_rays(std::span<const FaceSide> sides) {
        const auto [stride, count] = plan_for(sides);
        const Sequence4 sequence(hash64(scene_.instances[instance_].stable_id, sides.front().triangle));
        std::uint32_t k = 0;
        for (std::size_t side = 0; side < sides.size(); side += stride) {
            const auto corner = world_triangle(scene_, instance_, sides[side].triangle);
            const Vec3 front = normalize_or_zero(world_area_vector(scene_, instance_, sides[side].triangle));
            const Vec3 normal = sides[side].back ? -front : front;
            const Frame frame(normal);
            for (const std::uint32_t end = k + count; k < end; ++k) {
                const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
                const Vec3 x = w.x * corner[0] + w.y * corner[1] + w.z * corner[2];
                const Vec3 direction = square_to_cosine_hemisphere(sequence(k, 2), sequence(k, 3));
                rays_.push_back({offset_origin(x, normal, reach_), frame.to_world(direction), 0, reach_});
            }
        }
    }

    Blocked count_blocked(std::size_t first, std::uint32_t count) const {
        Blocked blocked;
        for (std::size_t i = first; i < first + count; ++i) {
            if (hits_[i].instance == instance_) {
                ++blocked.far;
                blocked.close += hits_[i].distance < kClose / kRoom * reach_ ? 1 : 0;
            }
        }
        return blocked;
    }

    void set(float open, std::vector<Exposure>& exposure) const {
        const float exposed = std::clamp((open - kCovered) / (kExposed - kCovered), kLeast, 1.0F);
        const float sheltered = std::max(kLeast, exposed * (1 - open));
        for (const FaceSide& face : chosen_) {
            Exposure& result = exposure[face.triangle];
            (face.back ? result.back : result.front) = exposed;
            (face.back ? result.back_shelter : result.front_shelter) = sheltered;
        }
    }

    const Scene& scene_;
    std::uint32_t instance_;
    const FaceGroups& groups_;
    const RayTracer& tracer_;
    float reach_, detail_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<FaceSide> chosen_;
};

}  // namespace

std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, FaceGroups& groups, float scene_size,
                                    const RayTracer& tracer, const Control& control) {
    std::vector<Exposure> exposure(groups.of_front.size(), {0, 0, 0, 0});
    std::vector<FaceGroups::Builder> parts((groups.count() + kGroups - 1) / kGroups);
    parallel_blocks(groups.count(), kGroups, control, [&](std::size_t begin, std::size_t end) {
        Surveyor(scene, instance, groups, scene_size, tracer).survey(begin, end, parts[begin / kGroups], exposure);
    });
    groups = make_groups(parts, exposure.size());
    return exposure;
}

}  // namespace gg
