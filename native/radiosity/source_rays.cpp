#include "radiosity/source_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

#include "core/random.h"
#include "transport/emitter_sampling.h"

namespace gg {

namespace {

constexpr int kMostCandidates = 16;
constexpr float kAlmost = 0.9999F;  // of the way to a source
constexpr float kFar = 4;           // distance in sizes of a source from which one point of it tells as much as all

// Candidates for the point of a source to which the ray goes, one in each cell of the unit square: the closer the
// source, the more. One is chosen by what they bring, and stands for their mean [Talbot et al. 2005]: a single point
// next to the source would now and then bring a multiple of what all others do.
int candidates_on_a_side(float square_of_distance, float size) {
    constexpr float kNear = 1.5F;
    const float ratio = square_of_distance / (size * size);
    return ratio > kFar * kFar ? 1 : ratio > kNear * kNear ? 2 : 4;
}

Vec2 candidate(Vec3 sample, int c, int side) {
    return {(sample.x + static_cast<float>(c % side)) / static_cast<float>(side),
            (sample.y + static_cast<float>(c / side)) / static_cast<float>(side)};
}

// One of them by chances that are their weights.
std::size_t choose(std::span<const float> weights, float sum, float u) {
    float target = u * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < weights.size() && !(target < weights[chosen])) {
        target -= weights[chosen++];
    }
    return chosen;
}

Rgb irradiance_of(const LampSample& sample, Vec3 normal) {
    return std::max(0.0F, dot(normal, sample.direction)) * sample.normal_irradiance;
}

// The same as for any lamp, candidates side by side.
SourceRay ray_to_rectangle(const Lamp& lamp, const SphericalRectangle& rectangle, int side, const OffsetPoint& x,
                           Vec3 sample) {
    RectangleView<Wide> view;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        view.set(lane, rectangle.view());
    }
    const Vec3 normal{dot(x.normal, rectangle.axis_x()), dot(x.normal, rectangle.axis_y()),
                      dot(x.normal, rectangle.axis_z())};
    const int count = side * side;
    std::array<Vec2, kMostCandidates> places;
    std::array<float, kMostCandidates> cosines{};
    float sum = 0;
    for (int begin = 0; begin < count; begin += static_cast<int>(kLanes)) {
        WideVec2 uv;
        const int lanes = std::min(count - begin, static_cast<int>(kLanes));
        for (int lane = 0; lane < lanes; ++lane) {
            const Vec2 place = candidate(sample, begin + lane, side);
            uv.x[lane] = place.x;
            uv.y[lane] = place.y;
        }
        const WideVec2 at = view.point(uv.x, uv.y);
        const Wide cosine =
            (normal.x * at.x + normal.y * at.y + normal.z * view.z) / sqrt(at.x * at.x + at.y * at.y + view.z * view.z);
        for (int lane = 0; lane < lanes; ++lane) {
            places[begin + lane] = {at.x[lane], at.y[lane]};
            cosines[begin + lane] = std::max(0.0F, static_cast<float>(cosine[lane]));
            sum += cosines[begin + lane];
        }
    }
    const Vec2 chosen = places[choose(std::span(cosines).first(count), sum, sample.z)];
    const Vec3 to =
        chosen.x * rectangle.axis_x() + chosen.y * rectangle.axis_y() + rectangle.view().z * rectangle.axis_z();
    const Rgb all = rectangle.solid_angle() * lamp.radiance;
    return {{x.position, to, 0, kAlmost}, sum / static_cast<float>(count) * all};
}

SourceRay ray_to_lamp(const Lamp& lamp, float size, const OffsetPoint& x, Vec3 sample) {
    const bool distant = lamp.shape == LampShape::kDistant;
    const int side = distant ? 1 : candidates_on_a_side(length_squared(lamp.position - x.position), size);
    const LampSampler sampler(lamp, x.position, kFar);
    if (side > 1 && sampler.rectangle() != nullptr) {
        return ray_to_rectangle(lamp, *sampler.rectangle(), side, x, sample);
    }
    std::array<LampSample, kMostCandidates> candidates;
    std::array<float, kMostCandidates> weights{};
    Rgb mean(0.0F);
    for (int c = 0; c < side * side; ++c) {
        const Vec2 uv = candidate(sample, c, side);
        candidates[c] = sampler.sample(uv.x, uv.y);
        const Rgb irradiance = irradiance_of(candidates[c], x.normal) / static_cast<float>(side * side);
        weights[c] = luminance(irradiance);
        mean += irradiance;
    }
    const LampSample& chosen = candidates[choose(std::span(weights).first(side * side), luminance(mean), sample.z)];
    return {{x.position, chosen.direction, 0, kAlmost * chosen.distance}, mean};
}

SourceRay ray_to_sky(const Node& cell, Rgb world, const OffsetPoint& x, Vec3 sample) {
    const Vec3 direction = cell_direction(sky_cell_of(cell), sample.x, sample.y);
    const float cosine = std::max(0.0F, dot(direction, x.normal));
    return {{x.position, direction, 0, kInfinity}, cosine * cell.area * world};
}

SourceRay ray_to_element(const Node& element, const OffsetPoint& x, Vec3 sample) {
    const auto& corner = element.corner;
    if (!(dot(x.position - corner[0], element.normal) > 0)) {
        return {};
    }
    const int side = candidates_on_a_side(length_squared(element.center - x.position), element.radius);
    std::array<Vec3, kMostCandidates> towards;
    std::array<float, kMostCandidates> weights{};
    for (int c = 0; c < side * side; ++c) {
        const Vec2 uv = candidate(sample, c, side);
        const Vec3 w = square_to_triangle(uv.x, uv.y);
        towards[c] = w.x * corner[0] + w.y * corner[1] + w.z * corner[2] - x.position;
        const float square = std::max(length_squared(towards[c]), 1e-30F);
        weights[c] = std::max(0.0F, dot(towards[c], x.normal)) * std::max(0.0F, -dot(towards[c], element.normal)) /
                     (square * square);
    }
    const std::span<const float> all = std::span(weights).first(side * side);
    const float sum = std::accumulate(all.begin(), all.end(), 0.0F);
    const float factor = sum * element.area / (kPi * static_cast<float>(side * side));
    return {{x.position, towards[choose(all, sum, sample.z)], 0, kAlmost}, factor * element.emission};
}

}  // namespace

SourceRay ray_to_source(const Hierarchy& hierarchy, NodeId source, const OffsetPoint& x, Vec3 sample) {
    const Node& node = hierarchy[source];
    switch (node.kind) {
        case NodeKind::kLamp:
            return ray_to_lamp(hierarchy.scene().lamps[node.source], node.radius, x, sample);
        case NodeKind::kSky:
            return ray_to_sky(node, hierarchy.scene().world, x, sample);
        default:
            return ray_to_element(node, x, sample);
    }
}

}  // namespace gg
