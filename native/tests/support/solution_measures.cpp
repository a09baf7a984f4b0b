#include "support/solution_measures.h"

#include <algorithm>

namespace gg::test {

double luminance_of(Vec3d color) {
    return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

std::vector<NodeId> surface_leaves(const Solution& solution) {
    std::vector<NodeId> leaves;
    for (NodeId id = 0; id < solution.hierarchy.nodes().size(); ++id) {
        if (is_surface(solution.hierarchy[id]) && solution.hierarchy[id].child_count == 0) {
            leaves.push_back(id);
        }
    }
    return leaves;
}

FaceMeans means_of(const Solution& solution, const std::function<bool(const Node&)>& pick) {
    FaceMeans means;
    means.least = 1e300;
    for (const NodeId id : surface_leaves(solution)) {
        if (!pick(solution.hierarchy[id])) {
            continue;
        }
        const double area = solution.lighting.area(id);
        const double radiosity = luminance(solution.lighting.radiosity(id));
        means.radiosity += area * Vec3d(solution.lighting.radiosity(id));
        means.irradiance += area * Vec3d(solution.lighting.irradiance(id));
        means.area += area;
        means.least = std::min(means.least, radiosity);
        means.most = std::max(means.most, radiosity);
    }
    means.radiosity /= means.area;
    means.irradiance /= means.area;
    return means;
}

FaceMeans means_of_instance(const Solution& solution, std::uint32_t instance) {
    return means_of(solution, [&](const Node& node) {
        return node.instance == instance && (node.kind != NodeKind::kElement || !node.back);
    });
}

double arriving_power(const Solution& solution) {
    double power = 0;
    for (const NodeId id : surface_leaves(solution)) {
        power += solution.lighting.area(id) * luminance(solution.lighting.irradiance(id));
    }
    return power;
}

}  // namespace gg::test
