#include "gather/light_jumps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gg {

namespace {

constexpr float kJump = 0.2F;         // of the pixel's light
constexpr float kSameSurface = 0.9F;  // cosine between normals
constexpr float kOffPlane = 0.5F;     // sine of the angle to the surface under which the other one lies, at most

// Leaves of one plant that lie behind one another are not.
bool is_same_surface(const Fragment& a, const Fragment& b) {
    const Vec3 across = b.position - a.position;
    return a.hit.instance == b.hit.instance && a.back == b.back && dot(a.normal, b.normal) > kSameSurface &&
           std::abs(dot(across, a.normal)) <= kOffPlane * length(across);
}

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

std::vector<JumpingFragment> jumps_in(const PixelMap& map, std::size_t tile, std::span<const TileLight> light) {
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
            if (step > kJump * seen) {
                found.push_back({p, f - begin, step / std::max(seen, 1e-20F)});
            }
        }
    }
    return found;
}

}  // namespace gg
