#include "gather/light_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "gather/same_surface.h"

namespace gg {

namespace {

constexpr float kJump = 0.2F;         // of the pixel's light
constexpr float kJumpAtLamp = 0.05F;  // the same where a lamp begins, whose place is known
constexpr float kSteepest = 0.1F;     // cosine between a surface and the view, below which pixels see no more of it

// The largest difference between a fragment's light and that of its surface in another pixel, as the picture shows it.
float step_to(const Fragment& fragment, Rgb light, const TileFragments& other, const TileLight& other_light,
              std::uint32_t pixel) {
    float largest = 0;
    for (std::uint32_t g = other.begin_of(pixel); g < other.pixels[pixel].end; ++g) {
        if (is_same_surface(fragment, other.fragments[g])) {
            largest = std::max(largest, luminance(fragment.albedo * glm::abs(light - other_light[g])));
        }
    }
    return largest;
}

}  // namespace

float pixel_reach(const Fragment& fragment, const PixelCamera& camera) {
    const float cosine = std::abs(dot(fragment.normal, camera.direction_to(fragment.position)));
    return camera.pixel_size(fragment.hit.distance) / std::max(cosine, kSteepest);
}

Rgb step_at(const Lamp& lamp, const Fragment& fragment, float reach) {
    if (lamp.shape != LampShape::kRectangle && lamp.shape != LampShape::kEllipse) {
        return Rgb(0.0F);
    }
    const Vec3 from = fragment.position - lamp.position;
    const auto is_within = [&](Vec3 half) {
        const float size = length(half);
        return std::abs(dot(from, half)) < size * (size + reach);
    };
    const bool touches =
        std::abs(dot(from, lamp.direction)) < reach && is_within(lamp.half_x) && is_within(lamp.half_y);
    // The form factor of a half plane at its edge.
    return touches ? 0.5F * (1 - dot(fragment.normal, lamp.direction)) * kPi * lamp.radiance : Rgb(0.0F);
}

std::vector<JumpingFragment> jumps_in(const PixelMap& map, std::size_t tile, std::span<const TileLight> light,
                                      std::span<const Lamp> lamps, const PixelCamera& camera) {
    const TileFragments& own = map.tiles()[tile];
    std::vector<JumpingFragment> found;
    for (std::uint32_t p = 0; p < own.pixels.size(); ++p) {
        const std::uint32_t begin = own.begin_of(p), end = own.pixels[p].end;
        float seen = kPi * luminance(own.pixels[p].emitted);
        for (std::uint32_t f = begin; f < end; ++f) {
            seen += luminance(own.fragments[f].albedo * light[tile][f]);
        }
        for (std::uint32_t f = begin; f < end; ++f) {
            float step = 0;
            for (const auto& [dx, dy] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                if (const PixelMap::Pixel* beside = map.beside(tile, p, dx, dy)) {
                    step = std::max(step, step_to(own.fragments[f], light[tile][f], map.tiles()[beside->tile],
                                                  light[beside->tile], beside->index));
                }
            }
            const Fragment& fragment = own.fragments[f];
            const float reach = pixel_reach(fragment, camera);
            float at_lamps = 0;
            for (const Lamp& lamp : lamps) {
                at_lamps = std::max(at_lamps, luminance(fragment.albedo * step_at(lamp, fragment, reach)));
            }
            if (step > kJump * seen || at_lamps > kJumpAtLamp * seen) {
                const float whole = std::max(seen, 1e-20F);
                found.push_back({p, f - begin, std::max(step, at_lamps) / whole, at_lamps > kJumpAtLamp * seen});
            }
        }
    }
    return found;
}

}  // namespace gg
