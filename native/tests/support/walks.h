// Walks over what a picture shows, and steps of light on them.
#pragma once

#include <array>
#include <map>
#include <tuple>
#include <vector>

#include "oracles/site_irradiance.h"
#include "support/grid_picture.h"

namespace gg::test {

// Neighbouring points of one triangle.
struct Step {
    PlacedFragment from, to;
};

// Along `rows` lines from left to right over the picture, `points` on each.
[[nodiscard]] std::vector<Step> walk_steps(const GridPicture& picture, int rows, int points);

// The part of the step that crosses from some sites to others, or the part in which light jumps most, down to `length`,
// m.
enum class Narrow { kToSites, kToJump };
[[nodiscard]] Step narrow(const GridPicture& picture, Step step, Narrow to, float length);

[[nodiscard]] bool has_same_sites(const Step& step);

// Luminance, W/m2, by the oracle, and what its rays met.
struct WalkedLight {
    double light = 0;
    std::map<std::tuple<oracle::RayKind, std::uint32_t, std::uint32_t>, oracle::SiteRay> rays;  // of all sites together
};
[[nodiscard]] WalkedLight walked_light(const GridPicture& picture, const PlacedFragment& at);

// From one point to another: what rays bring that meet something else there, by kind, and how many these are.
struct RayChange {
    std::array<double, 3> light{};  // luminance, W/m2
    std::array<int, 3> count{};

    [[nodiscard]] double sum() const { return light[0] + light[1] + light[2]; }
};
[[nodiscard]] RayChange ray_change(const WalkedLight& from, const WalkedLight& to);

}  // namespace gg::test
