#include "gather/sender_light.h"

#include <algorithm>
#include <cmath>

#include "core/wide.h"
#include "radiosity/quarter.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

constexpr int kLevels = 1;  // of quarters of a linear element

// Of a triangle whose radiosity is linear, by parts in which it is even.
Rgb from_part(Vec3 x, Vec3 n, const std::array<Vec3, 3>& corners, const std::array<Rgb, 3>& radiosity, int levels) {
    if (levels == 0) {
        return point_to_triangle(x, n, corners[0], corners[1], corners[2]) *
               (radiosity[0] + radiosity[1] + radiosity[2]) / 3.0F;
    }
    Rgb sum(0.0F);
    for (int quarter = 0; quarter < kQuarters; ++quarter) {
        sum += from_part(x, n, quarter_of(corners, quarter), quarter_of(radiosity, quarter), levels - 1);
    }
    return sum;
}

// Some of a cluster's points as seen from x.
struct FacesFrom {
    WideVec3 to, normal, power;  // to: m
    Wide square;                 // of the distance, m2

    FacesFrom(const ClusterFaces& faces, std::size_t first, const WideVec3& x)
        : to(WideVec3(load(&faces.x[first]), load(&faces.y[first]), load(&faces.z[first])) - x),
          normal(load(&faces.normal_x[first]), load(&faces.normal_y[first]), load(&faces.normal_z[first])),
          power(load(&faces.red[first]), load(&faces.green[first]), load(&faces.blue[first])),
          square(max(dot(to, to), Wide(1e-30F))) {}
};

// The lane sums.
Vec3 sum_of(const WideVec3& v) {
    return {reduce(v.x), reduce(v.y), reduce(v.z)};
}

}  // namespace

Rgb unoccluded_irradiance(const Solution& solution, NodeId sender, Vec3 x, Vec3 n) {
    const Node& node = hierarchy_of(solution)[sender];
    if (node.kind == NodeKind::kLamp) {
        return lamp_irradiance(hierarchy_of(solution).scene().lamps[node.source], x, n);
    }
    if (!(dot(x - node.corner[0], node.normal) > 0)) {
        return Rgb(0.0F);
    }
    const float closeness = node.child_count > 0 ? 0.0F : closeness_of(node, length(node.center - x));
    if (!(closeness > 0)) {
        return point_to_triangle(x, n, node.corner[0], node.corner[1], node.corner[2]) * radiosity_of(solution, sender);
    }
    // Close by the course of its light over the element counts, the more the closer.
    auto corners = corner_radiosity(solution, sender);
    const Rgb mean = radiosity_of(solution, sender);
    for (Rgb& corner : corners) {
        corner = glm::mix(mean, corner, closeness);
    }
    return from_part(x, n, node.corner, corners, kLevels);
}

IrradianceVector irradiance_vector(const Solution& solution, NodeId sender, Vec3 x) {
    const Node& node = hierarchy_of(solution)[sender];
    if (node.kind == NodeKind::kLamp) {
        return lamp_irradiance_vector(hierarchy_of(solution).scene().lamps[node.source], x);
    }
    Vec3 vector(0.0F);
    if (dot(x - node.corner[0], node.normal) > 0) {
        // From afar a triangle is as good as a point.
        const Vec3 to = node.center - x;
        const float square = length_squared(to);
        vector = square > kPointDistance * kPointDistance * node.radius * node.radius
                     ? -dot(to, node.normal) * node.area / (kPi * square * square) * to
                     : vector_form_factor(x, std::span<const Vec3>(node.corner));
    }
    const float size = length(vector);
    return {size * radiosity_of(solution, sender), size > 0 ? vector / size : Vec3(0, 0, 1)};
}

IrradianceVector irradiance_vector(const Solution& solution, const ClusterPoints& cluster_points, NodeId sender,
                                   Vec3 x) {
    const Node& node = hierarchy_of(solution)[sender];
    if (!is_cluster(node)) {
        return irradiance_vector(solution, sender, x);
    }
    const ClusterFaces& faces = cluster_points.of(sender);
    const WideVec3 at(x);
    WideVec3 sums, vectors;
    for (std::size_t i = 0; i < kClusterPoints; i += kLanes) {
        const FacesFrom seen(faces, i, at);
        const Wide inverse = 1 / sqrt(seen.square);
        const Wide cosine = max(Wide(0), Wide(-dot(seen.normal, seen.to))) * inverse;
        const WideVec3 light = cosine / (seen.square + cluster_disk(node) / kPi) * seen.power;
        sums = sums + light;
        vectors = vectors + luminance(light) * inverse * seen.to;
    }
    const Rgb sum = sum_of(sums);
    const Vec3 vector = sum_of(vectors);
    const float size = length(vector), all = luminance(sum);
    return {all > 0 ? size / all * sum : Rgb(0.0F), size > 0 ? vector / size : Vec3(0, 0, 1)};
}

Rgb unoccluded_irradiance(const Solution& solution, const ClusterPoints& cluster_points, NodeId sender, Vec3 x,
                          Vec3 n) {
    const Node& node = hierarchy_of(solution)[sender];
    if (!is_cluster(node)) {
        return unoccluded_irradiance(solution, sender, x, n);
    }
    const ClusterFaces& faces = cluster_points.of(sender);
    const WideVec3 at(x), up(n);
    WideVec3 sums;
    for (std::size_t i = 0; i < kClusterPoints; i += kLanes) {
        const FacesFrom seen(faces, i, at);
        const Wide cosines = max(Wide(0), dot(up, seen.to)) * max(Wide(0), Wide(-dot(seen.normal, seen.to)));
        sums = sums + cosines / (seen.square * (seen.square + cluster_disk(node) / kPi)) * seen.power;
    }
    return sum_of(sums);
}

Rgb irradiance_from(const FacePoint& point, float share, Vec3 to, Vec3 n, float area) {
    const float square = length_squared(to);
    const float cosines = std::max(0.0F, dot(n, to)) * std::max(0.0F, -dot(point.normal, to));
    if (!(cosines > 0)) {
        return Rgb(0.0F);
    }
    return share * cosines / (square * (square + area / kPi)) * point.power;
}

}  // namespace gg
