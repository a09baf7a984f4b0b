// Slow truth for shading: every site of a point by itself, one sender after the other, one ray at a time, added up in
// double precision. Sites, sample points and fixed directions are those of the gather; lists, batches and what sites
// share are not.
#pragma once

#include <cstdint>
#include <vector>

#include "gather/shade.h"

namespace gg::oracle {

struct ShadedScene {
    const Solution& solution;
    const ClusterPoints& points;
    const RayTracer& tracer;
};

enum class RayKind : std::uint8_t { kSender, kSky, kNear };

// What one ray contributed to the light of a point.
struct SiteRay {
    RayKind kind = RayKind::kSender;
    std::uint32_t id = 0, index = 0;  // sender and number of its point; leaf; cell of the table or of its parts
    std::uint32_t met = kNone;        // kNone: nothing; near: a number of the triangle and its element; else 0
    double light = 0;  // luminance, W/m2: what it changes or, to senders and the sky, brings if it meets nothing
};

// Irradiance [W/m2] by the models of the point's sites, each times its weight. rays: of every site, as they are
// traced; may be null.
//
// Two things belong to the point and not to a site alone: how many samples a sender's visibility has, and what is
// expected of it where these say nothing. They are means, by weight, over the sites that resample it (the others add no
// samples), so that all sites judge by the same rays. Numbers of samples are floats as in the gather: whether one is
// whole makes a difference.
[[nodiscard]] Vec3d site_irradiance(const ShadedScene& scene, const PlacedFragment& placed,
                                    std::vector<SiteRay>* rays = nullptr);

}  // namespace gg::oracle
