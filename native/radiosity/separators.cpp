#include "radiosity/separators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/random.h"
#include "radiosity/open_elements.h"
#include "radiosity/oracle.h"
#include "radiosity/seen_light.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kInset = 0.05F;    // of points towards the centre
constexpr float kHeight = 0.125F;  // of rays along the surface above it, as a share of the element's radius
constexpr int kPoints = 6, kPairs = 9;
constexpr int kDirections = 8;
constexpr std::uint64_t kSeed = 0x73657061;

using Points = std::array<Vec3, kPoints>;
using Pair = std::array<int, 2>;

// Between the corners 0..2, between the middles 3..5 of the edges opposite, and from each corner to the one opposite.
constexpr std::array<Pair, kPairs> kAcross{{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

Points points_of(const Node& node) {
    const auto& corner = node.corner;
    const Vec3 centre = (corner[0] + corner[1] + corner[2]) / 3.0F;
    Points points;
    for (int k = 0; k < 3; ++k) {
        points[k] = glm::mix(corner[k], centre, kInset);
        points[3 + k] = glm::mix(0.5F * (corner[(k + 1) % 3] + corner[(k + 2) % 3]), centre, kInset);
    }
    return points;
}

// Looks at elements, one after the other.
class Separator {
  public:
    Separator(const SeenLight& seen, const RayTracer& tracer) : seen_(seen), tracer_(tracer) {}

    // Whether points that something keeps apart have light that differs by more than the tolerance.
    bool divides(const Node& node, const RefineSettings& settings) {
        const Points points = points_of(node);
        std::array<Ray, kPairs> along;
        for (int i = 0; i < kPairs; ++i) {
            const Vec3 from = points[kAcross[i][0]], to = points[kAcross[i][1]];
            along[i] = {from + kHeight * node.radius * node.normal, to - from, 0, 1};
        }
        std::array<std::uint8_t, kPairs> apart{};
        tracer_.occluded(along, apart, RayMask::kLight, Coherence::kIncoherent);
        if (std::none_of(apart.begin(), apart.end(), [](std::uint8_t a) { return a != 0; })) {
            return false;
        }
        const auto light = light_at(points, node);
        for (int i = 0; i < kPairs; ++i) {
            const float a = light[kAcross[i][0]], b = light[kAcross[i][1]];
            const float difference = 0.5F * std::abs(a - b);
            if (apart[i] && seen_reflectance(node) * difference > allowed_difference(0.5F * (a + b), settings)) {
                return true;
            }
        }
        return false;
    }

  private:
    // Luminance of the irradiance, W/m2. All points look into the same directions: what differs between them is then
    // more than noise.
    std::array<float, kPoints> light_at(const Points& points, const Node& node) {
        const Sequence4 sequence(hash64(node.stable_id, kSeed));
        const Frame frame(node.normal);
        for (int k = 0; k < kDirections; ++k) {
            const Vec3 direction = frame.to_world(square_to_cosine_hemisphere(sequence(k, 0), sequence(k, 1)));
            for (int p = 0; p < kPoints; ++p) {
                rays_[kPoints * k + p] = {offset_origin(points[p], node.normal, node.radius), direction, 0, kInfinity};
            }
        }
        tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
        std::array<float, kPoints> light{};
        for (int i = 0; i < kPoints * kDirections; ++i) {
            light[i % kPoints] += luminance(seen_.radiosity(rays_[i], hits_[i])) / kDirections;
        }
        return light;
    }

    const SeenLight& seen_;
    const RayTracer& tracer_;
    std::array<Ray, kPoints * kDirections> rays_;
    std::array<Hit, kPoints * kDirections> hits_;
};

}  // namespace

void split_at_separators(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer,
                         const RefineSettings& settings, const Control& control) {
    const SeenLight seen(hierarchy, lighting);
    const auto make_test = [&]() -> ElementTest {
        const auto separator = std::make_shared<Separator>(seen, tracer);
        return [&, separator](NodeId id) { return separator->divides(hierarchy[id], settings); };
    };
    open_elements(hierarchy, lighting, settings, make_test, control);
}

}  // namespace gg
