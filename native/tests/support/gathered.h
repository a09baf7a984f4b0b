// Gathers at single points of small scenes.
#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "gather/classify.h"
#include "gather/full_gather.h"
#include "gather/shade.h"
#include "support/test_scenes.h"
#include "trace/surface_point.h"

namespace gg::test {

[[nodiscard]] inline Receiver receiver_at(const Solution& solution, const Fragment& at) {
    return {offset_origin(at.position, at.normal, 1),
            at.normal,
            at.shading_normal,
            place_at(solution, at.hit.instance, at.hit.triangle, false, at.position),
            0.5F,
            1.0F};
}

// All that gathers at single points need.
struct Gathered {
    Prepared prepared;
    std::shared_ptr<const Solution> solution = prepared.solve();
    ClusterPoints points{*solution, prepared.control};
    NodeOrder order{hierarchy_of(*solution)};

    explicit Gathered(const SceneDescription& description) : prepared(description) {}

    FullGather full() { return {*solution, order, points, *prepared.tracer, 256}; }
    Classifier classifier(float threshold) { return {*solution, order, points, *prepared.tracer, {256, threshold, 0}}; }
    Shader shader() { return {*solution, order, points, *prepared.tracer}; }
};

// Irradiance at a point between sites, W/m2.
[[nodiscard]] inline Rgb light_at(Shader& shader, const Fragment& at, std::span<const WeightedSite> sites) {
    PlacedFragment placed{at, {}, static_cast<std::uint32_t>(sites.size())};
    std::copy(sites.begin(), sites.end(), placed.around.begin());
    PointLight light;
    PointCounts taken;
    shader.shade(std::span(&placed, 1), std::span(&light, 1), std::span(&taken, 1));
    return light.all;
}

}  // namespace gg::test
