#include "radiosity/reference_white.h"

#include <algorithm>
#include <vector>

namespace gg {

namespace {

// Emitted power spread over all faces: too dark where most faces lie in the dark, but the first, coarse refinement
// needs no more.
ReferenceWhite first_guess(const Hierarchy& hierarchy) {
    const Node& root = hierarchy[kGeometryRoot];
    const float area = std::max(root.area, 1e-12F);
    float irradiance = luminance(root.emission);
    for (const NodeId id : hierarchy.infinite_and_lamps()) {
        const Node& sender = hierarchy[id];
        const float emission = luminance(sender.emission);
        if (sender.kind == NodeKind::kSky) {
            irradiance += emission * sender.area / (4 * kPi);
        } else {
            const Lamp& lamp = hierarchy.scene().lamps[sender.source];
            const float surface = lamp.shape == LampShape::kPoint    ? 4 * kPi
                                  : lamp.shape == LampShape::kSphere ? 4 * kPi * lamp.radius * lamp.radius
                                                                     : 4 * length(cross(lamp.half_x, lamp.half_y));
            irradiance += lamp.shape == LampShape::kDistant ? 0.25F * emission : emission * surface / area;
        }
    }
    return {irradiance, 0.25F * 2 * root.radius};
}

}  // namespace

ReferenceWhite reference_white(const Hierarchy& hierarchy, const Lighting& lighting) {
    struct Place {
        float irradiance;
        double flux;
        Vec3 position;
    };
    std::vector<Place> places;
    glm::dvec3 center(0.0);
    double total = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        const float irradiance = luminance(lighting.irradiance(id));
        if (is_surface(node) && node.child_count == 0 && irradiance > 0) {
            const double flux = lighting.area(id) * static_cast<double>(irradiance);
            places.push_back({irradiance, flux, node.center});
            center += flux * glm::dvec3(node.center);
            total += flux;
        }
    }
    if (!(total > 0)) {
        return first_guess(hierarchy);
    }
    const Vec3 middle(center / total);
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) { return a.irradiance < b.irradiance; });
    ReferenceWhite white;
    double below = 0, spread = 0;
    for (const Place& place : places) {
        spread += place.flux * static_cast<double>(length(place.position - middle));
        if (below < 0.5 * total) {
            white.irradiance = place.irradiance;
        }
        below += place.flux;
    }
    white.extent = static_cast<float>(spread / total);
    return white;
}

}  // namespace gg
