#include "radiosity/separators.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "radiosity/element_light.h"
#include "radiosity/open_elements.h"
#include "radiosity/oracle.h"

namespace gg {

namespace {

constexpr float kHeight = 0.125F;  // of rays along the surface above it, as a share of the element's radius
constexpr int kPairs = 9;

using Pair = std::array<int, 2>;

// Between the corners 0..2, between the middles 3..5 of the edges opposite, and from each corner to the one opposite.
constexpr std::array<Pair, kPairs> kAcross{{{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}, {0, 3}, {1, 4}, {2, 5}}};

// Looks at elements, one after the other.
class Separator {
  public:
    Separator(const SeenLight& seen, const RayTracer& tracer) : light_(seen, tracer), tracer_(tracer) {}

    // Whether points that something keeps apart have light that differs by more than the tolerance.
    bool divides(const Node& node, const RefineSettings& settings) {
        const auto points = ElementLight::points_of(node);
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
        const auto light = light_.at(points, node);
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
    ElementLight light_;
    const RayTracer& tracer_;
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
