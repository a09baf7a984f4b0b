#include "radiosity/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "radiosity/element_light.h"
#include "radiosity/open_elements.h"
#include "radiosity/oracle.h"

namespace gg {

namespace {

constexpr float kHeight = 0.125F;  // of rays above the surface, as a share of the element's radius
constexpr float kSmall = 0.3F;     // in details: smaller elements bend too little to matter, and are by far the most
constexpr float kBeyond = 0.25F;   // how far they reach over its edges, in the same unit

// Whether something stands beside the element, at the middle of an edge.
bool ends_at_a_surface(const Node& node, const ElementLight::Points& points, const RayTracer& tracer) {
    std::array<Ray, 3> rays;
    for (int k = 0; k < 3; ++k) {
        const Vec3 along = node.corner[(k + 2) % 3] - node.corner[(k + 1) % 3];
        Vec3 outwards = normalize_or_zero(cross(along, node.normal));
        outwards *= dot(outwards, points[3 + k] - points[k]) < 0 ? -1.0F : 1.0F;
        rays[k] = {points[3 + k] + kHeight * node.radius * node.normal, kBeyond * node.radius * outwards, 0, 1};
    }
    std::array<std::uint8_t, 3> blocked{};
    tracer.occluded(rays, blocked, RayMask::kLight, Coherence::kIncoherent);
    return std::any_of(blocked.begin(), blocked.end(), [](std::uint8_t b) { return b != 0; });
}

// How far the light in the middle of an edge is from the mean of its ends, at most.
bool bends(const ElementLight::Values& light, const Node& node, const RefineSettings& settings) {
    for (int k = 0; k < 3; ++k) {
        const float mean = 0.5F * (light[(k + 1) % 3] + light[(k + 2) % 3]);
        const float bend = std::abs(light[3 + k] - mean);
        if (seen_reflectance(node) * bend > allowed_difference(mean, settings)) {
            return true;
        }
    }
    return false;
}

}  // namespace

void split_at_creases(Hierarchy& hierarchy, Lighting& lighting, const RayTracer& tracer, const RefineSettings& settings,
                      const Control& control) {
    const SeenLight seen(hierarchy, lighting);
    const auto make_test = [&]() -> ElementTest {
        const auto light = std::make_shared<ElementLight>(seen, tracer);
        return [&, light](NodeId id) {
            const Node& node = hierarchy[id];
            const auto points = ElementLight::points_of(node);
            return size_in_details(node.radius, settings) >= kSmall && ends_at_a_surface(node, points, tracer) &&
                   bends(light->at(points, node), node, settings);
        };
    };
    open_elements(hierarchy, lighting, settings, make_test, control);
}

}  // namespace gg
