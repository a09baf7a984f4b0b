// Unoccluded light of any sender at a point, in closed form.
#pragma once

#include "radiosity/hierarchy.h"

namespace gg {

// Irradiance per unit of the sender's radiosity at point x, as a vector: for a facing plane, from unit `direction`.
struct Arrival {
    float factor = 0;
    Vec3 direction{0.0F};
    float solid_angle = 0;  // over pi: the factor if all of it came from `direction`
};

[[nodiscard]] Arrival arrival(const Hierarchy& hierarchy, const Node& sender, Vec3 x);

// Form factor at point x of an element; unit 1/m2 for clusters, see Link.
[[nodiscard]] float form_factor_at(const Hierarchy& hierarchy, const Node& receiver, const Node& sender, Vec3 x);

[[nodiscard]] inline bool in_front(Vec3 point, const Node& element) {
    return dot(point - element.corner[0], element.normal) > 0;
}

}  // namespace gg
