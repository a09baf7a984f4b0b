// Light along walks over surfaces: it changes at once only where a ray meets something else.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/gather_scenes.h"
#include "support/walks.h"
#include "trace/surface_point.h"

namespace gg::test {
namespace {

constexpr float kShortest = 5e-7F;  // m: about what floats can tell apart
constexpr int kRows = 10, kPoints = 1000;
constexpr int kSamples = 64;
constexpr std::size_t kMostJumps = 100;  // that are looked at closely

// Cells as large as those of a picture of 350 pixels' height.
GridPicture picture_of(const ViewedScene& scene, bool surfaces = true) {
    PictureSettings settings;
    settings.surfaces = surfaces;
    settings.cell = 9;
    return {scene.description, scene.camera, settings};
}

// Of the steps those in which light changes by more than a share of the mean, which is returned.
double keep_largest(const GridPicture& picture, float share, std::vector<Step>& steps) {
    std::vector<PlacedFragment> ends;
    for (const Step& step : steps) {
        ends.push_back(step.from);
        ends.push_back(step.to);
    }
    Shader shader = picture.shader();
    const std::vector<Rgb> light = light_at(shader, ends);
    float mean = 0;
    for (const Rgb& at : light) {
        mean += luminance(at) / static_cast<float>(light.size());
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (std::abs(luminance(light[2 * i + 1] - light[2 * i])) > share * mean) {
            steps[kept++] = steps[i];
        }
    }
    steps.resize(kept);
    return static_cast<double>(mean);
}

// Of a lit floor with nothing in the way of anything: across faces of tetrahedra, and of triangles with sites.
TEST(Continuity, light_is_the_same_on_both_sides_of_where_sites_change) {
    for (const bool surfaces : {false, true}) {
        const GridPicture picture = picture_of(viewed_stage(), surfaces);
        Shader shader = picture.shader();
        int crossings = 0;
        for (const Step& step : walk_steps(picture, kRows, kPoints)) {
            if (!has_same_sites(step)) {
                const Step face = narrow(picture, step, Narrow::kToSites, kShortest);
                const auto light = light_at(shader, {face.from, face.to});
                EXPECT_NEAR(luminance(light[0]) / luminance(light[1]), 1, 1e-5F);
                ++crossings;
            }
        }
        EXPECT_GT(crossings, 200);
    }
}

// The same with all that stands in the way: but for rays that meet something else from there on.
TEST(Continuity, rays_explain_what_changes_where_sites_change) {
    for (const ViewedScene& scene :
         {viewed_lamp_room(), viewed_mixed_scene(), viewed_window_room(), viewed_jungle(1000)}) {
        const GridPicture picture = picture_of(scene);
        int crossings = 0;
        for (const Step& step : walk_steps(picture, kRows, kPoints)) {
            if (!has_same_sites(step)) {
                const Step face = narrow(picture, step, Narrow::kToSites, kShortest);
                const WalkedLight from = walked_light(picture, face.from), to = walked_light(picture, face.to);
                const double left = to.light - from.light - ray_change(from, to).sum();
                EXPECT_NEAR(left, 0, 1e-5 * (from.light + to.light));
                ++crossings;
            }
        }
        EXPECT_GT(crossings, 300);
    }
}

// Neighbours whose light differs by more than a hundredth of the mean, down to the place where it happens. Walks of
// about ten thousand points: all of them jump because one ray or another meets something else.
TEST(Continuity, rays_explain_every_jump_of_a_walk) {
    for (const ViewedScene& scene :
         {viewed_lamp_room(), viewed_mixed_scene(), viewed_window_room(), viewed_jungle(1000)}) {
        const GridPicture picture = picture_of(scene);
        std::vector<Step> steps = walk_steps(picture, kRows, kPoints);
        EXPECT_GT(steps.size(), 7000U);
        const double mean = keep_largest(picture, 0.01F, steps);
        EXPECT_GT(steps.size(), 100U);
        int one_ray = 0, jumps = 0;
        for (std::size_t i = 0; i < steps.size(); i += std::max<std::size_t>(1, steps.size() / kMostJumps)) {
            const Step jump = narrow(picture, steps[i], Narrow::kToJump, kShortest);
            const WalkedLight from = walked_light(picture, jump.from), to = walked_light(picture, jump.to);
            const RayChange change = ray_change(from, to);
            EXPECT_NEAR(to.light - from.light, change.sum(), 1e-4 * (mean + from.light + to.light));
            const int rays = change.count[0] + change.count[1] + change.count[2];
            jumps += rays > 0 ? 1 : 0;
            one_ray += rays == 1 ? 1 : 0;
        }
        EXPECT_GT(jumps, 30);
        EXPECT_GT(one_ray, 0.9 * jumps);
    }
}

// Light at one fragment by one site that holds one sender, whose form factor is resampled.
struct OneSender {
    Shader& shader;
    Fragment at;
    Site site;

    OneSender(Shader& with, const Fragment& where, NodeId sender) : shader(with), at(where) {
        at.share = 1;
        site.senders.push_back({sender, true, true, 1, 0.5F, Rgb(0.0F), Vec3(0, 0, 1)});
    }
    float light(float samples) {
        site.senders.front().samples = samples;
        return luminance(light_at(shader, {PlacedFragment{at, {WeightedSite{&site, 1}}, 1}}).front());
    }
    // Mean over parts of a pixel that lie in one place.
    float light_of_parts(float samples, std::uint32_t parts) {
        site.senders.front().samples = samples;
        std::vector<PlacedFragment> all;
        for (std::uint32_t part = 0; part < parts; ++part) {
            all.push_back({at, {WeightedSite{&site, 1}}, 1});
            all.back().part = part;
        }
        float sum = 0;
        for (const Rgb& light : light_at(shader, all)) {
            sum += luminance(light) / static_cast<float>(parts);
        }
        return sum;
    }
    float unoccluded() {
        Site all = site;
        all.senders.front().resample_visibility = false;
        all.senders.front().visibility = 1;
        return luminance(light_at(shader, {PlacedFragment{at, {WeightedSite{&all, 1}}, 1}}).front());
    }
};

std::vector<NodeId> nodes_of(const GridPicture& picture, NodeKind kind) {
    std::vector<NodeId> found;
    const auto& nodes = hierarchy_of(*picture.solution).nodes();
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (nodes[id].kind == kind) {
            found.push_back(id);
        }
    }
    return found;
}

// All samples bring about the same.
bool is_evenly_sampled(const GridPicture& picture, const Fragment& at, NodeId sender) {
    const Vec3 x = offset_origin(at.position, at.normal, 1);
    const SenderSampler sampler(*picture.solution, sender, x, at.shading_normal);
    float least = kInfinity, most = 0;
    for (std::uint32_t i = 0; i < kSamples; ++i) {
        least = std::min(least, sampler.point(i).weight);
        most = std::max(most, sampler.point(i).weight);
    }
    return most < 1.4F * least;
}

// Fragments that see a sender in part by that many samples, all of which bring about the same.
std::vector<Fragment> partly_lit(const GridPicture& picture, Shader& shader, NodeId sender, float samples) {
    std::vector<Fragment> found;
    for (const Fragment& at : picture.some_fragments(200)) {
        OneSender lamp(shader, at, sender);
        const float all = lamp.unoccluded(), seen = lamp.light(samples);
        if (seen > 0.05F * all && seen < 0.95F * all && is_evenly_sampled(picture, at, sender)) {
            found.push_back(at);
        }
    }
    EXPECT_GE(found.size(), 5U);
    return found;
}

// Of a lamp that is seen in part: the next sample gets its share of the mean.
TEST(Continuity, light_follows_the_number_of_samples) {
    const GridPicture picture = picture_of(viewed_lamp_room());
    Shader shader = picture.shader();
    const NodeId id = nodes_of(picture, NodeKind::kLamp).front();
    for (const Fragment& at : partly_lit(picture, shader, id, kSamples)) {
        OneSender lamp(shader, at, id);
        const float all = lamp.unoccluded();
        constexpr float kStep = 1.0F / 16;
        float before = lamp.light(1);
        for (float samples = 1 + kStep; samples < kSamples; samples += kStep) {
            const float now = lamp.light(samples);
            EXPECT_LT(std::abs(now - before), 1.5F * all * kStep / std::ceil(samples)) << samples;
            before = now;
        }
    }
}

// Four parts of a pixel with 8 samples each see together what one with 32 sees, and as exactly.
TEST(Continuity, parts_of_a_pixel_see_points_of_their_own) {
    const GridPicture picture = picture_of(viewed_lamp_room());
    Shader shader = picture.shader();
    const NodeId id = nodes_of(picture, NodeKind::kLamp).front();
    for (const Fragment& at : partly_lit(picture, shader, id, 32)) {
        OneSender lamp(shader, at, id);
        const float all = lamp.unoccluded();
        EXPECT_NEAR(lamp.light_of_parts(8, 4) / all, lamp.light(32) / all, 0.02F);
        EXPECT_NEAR(lamp.light_of_parts(1024, 2) / all, lamp.light(1024) / all, 1e-5F);  // there are no more
    }
}

// Above the horizon is part of an element, but not its first sample: the next one comes in without a jump, and until
// then the element is as visible as the site says.
TEST(Continuity, a_sender_whose_samples_are_below_the_horizon_is_not_dark) {
    const GridPicture picture = picture_of(viewed_lamp_room());
    Shader shader = picture.shader();
    constexpr float kFacing = 0.05F;  // less tells little
    int found = 0;
    for (const Fragment& at : picture.some_fragments(200)) {
        const Vec3 x = offset_origin(at.position, at.normal, 1);
        for (const NodeId id : nodes_of(picture, NodeKind::kElement)) {
            const SenderSampler sampler(*picture.solution, id, x, at.shading_normal);
            const SenderPoint first = sampler.point(0), second = sampler.point(1);
            OneSender element(shader, at, id);
            const float all = element.unoccluded();
            if (all > 0 && first.weight == 0 && second.weight > kFacing * sampler.facing_weight() &&
                dot(second.direction, at.normal) > 0) {
                ++found;
                EXPECT_NEAR(element.light(1) / all, 0.5F, 1e-4F);
                EXPECT_NEAR(element.light(1 + 1e-6F) / all, 0.5F, 0.1F);
                EXPECT_NEAR(std::abs(element.light(1.9F) / all - 0.5F), 0.5F, 0.01F);  // that sample's word
            }
        }
    }
    EXPECT_GT(found, 100);
}

}  // namespace
}  // namespace gg::test
