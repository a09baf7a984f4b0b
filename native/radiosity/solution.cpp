#include "radiosity/solution.h"

#include "radiosity/solution_data.h"

namespace gg {

const Hierarchy& hierarchy_of(const Solution& solution) {
    return solution.hierarchy;
}

NodeId place_at(const Solution& solution, std::uint32_t instance, std::uint32_t triangle, bool back, Vec3 point) {
    const NodeId element = solution.elements.of(instance, triangle, back);
    if (element != kNone) {
        return solution.lighting.leaf_element_at(element, point);
    }
    return has_side(solution.hierarchy.scene().sides_of(instance, triangle), back)
               ? solution.clusters.of(instance, triangle)
               : kNone;
}

std::span<const Link> links_to(const Solution& solution, NodeId receiver) {
    return std::span(solution.links.all)
        .subspan(solution.link_begin[receiver], solution.link_begin[receiver + 1] - solution.link_begin[receiver]);
}

Rgb radiosity_of(const Solution& solution, NodeId node) {
    return solution.lighting.radiosity(node);
}

Rgb radiosity_at(const Solution& solution, NodeId element, Vec3 point) {
    const bool divided = solution.hierarchy[element].child_count > 0;
    return radiosity_of(solution, divided ? solution.lighting.leaf_element_at(element, point) : element);
}

float spread_of(const Solution& solution, NodeId node) {
    return solution.lighting.spread(node);
}

std::array<Rgb, 3> corner_radiosity(const Solution& solution, NodeId leaf_element) {
    const Node& node = solution.hierarchy[leaf_element];
    const InstanceVertices& vertices = solution.vertices[node.instance];
    const std::vector<Rgb>& values = node.back ? vertices.back : vertices.front;
    const Rgb mean = solution.lighting.radiosity(leaf_element);
    if (values.empty()) {
        return {mean, mean, mean};
    }
    std::array<Rgb, 3> corners;
    for (int k = 0; k < 3; ++k) {
        corners[k] = values[solution.element_vertices[leaf_element].vertices[k]];
    }
    const Rgb reflected = mean - node.emission;
    const Rgb middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
    for (Rgb& corner : corners) {
        corner = node.emission + reflected * corner / glm::max(middle, Rgb(1e-12F));
    }
    return corners;
}

Rgb face_radiosity(const Solution& solution, std::uint32_t instance, std::uint32_t triangle, bool back) {
    const SceneFaces& faces = solution.hierarchy.faces();
    const FaceColors& colors = faces.colors[faces.instance_colors[instance]];
    const Rgb emitted = colors.emission.empty() ? Rgb(0.0F) : kPi * colors.emission[triangle];
    return emitted + colors.reflectance[triangle] * solution.face_light.irradiance(instance, triangle, back);
}

}  // namespace gg
