// Reflectance and emission of materials, at a point and averaged over a triangle.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/vec.h"
#include "image/texture.h"
#include "scene/scene.h"

namespace gg {

class Messages;

inline constexpr float kLargestReflectance = 0.99F;  // so that light dies out

// Material kNone, and any unknown one, is grey 0.8. Thread-safe once made.
class SurfaceColors {
  public:
    // A factor that is negative or not finite, or an image that does not exist, becomes a message; that factor counts
    // as 0, that image as white. Keeps the address of `textures` alone: they must outlive this.
    SurfaceColors(const Scene& scene, const TextureSet& textures, Messages& messages);

    // At the surface's texture coordinates uv, averaged over about a square of side `width` in uv (0: finest).
    [[nodiscard]] Rgb reflectance_at(std::uint32_t material, Vec2 uv, float width) const;  // 0..kLargestReflectance
    [[nodiscard]] Rgb emission_at(std::uint32_t material, Vec2 uv, float width) const;     // radiance, W/(m2 sr), >= 0

    // Averages over the triangle a, b, c in the surface's texture coordinates: 16 parts of it are sampled (fewer
    // where it covers few texels), each filtered over its share. Constant colours return at once.
    [[nodiscard]] Rgb mean_reflectance(std::uint32_t material, Vec2 a, Vec2 b, Vec2 c) const;
    [[nodiscard]] Rgb mean_emission(std::uint32_t material, Vec2 a, Vec2 b, Vec2 c) const;

    [[nodiscard]] bool is_textured(std::uint32_t material) const;  // reflectance or emission varies with uv
    [[nodiscard]] bool emits(std::uint32_t material) const;

  private:
    // factor * image at (map_u . uv, map_v . uv) + offset
    struct Input {
        Rgb factor{0.0F};
        std::uint32_t image = kNone;
        Vec2 map_u{1.0F, 0.0F}, map_v{0.0F, 1.0F}, offset{0.0F};
        float stretch = 1;  // of a length in uv by the map, root mean square over directions
        float limit = 0;
    };
    struct Surface {
        Input reflectance, emission;
    };

    [[nodiscard]] Input make_input(const ColorInput& color, float limit, const std::string& material, const char* use,
                                   Messages& messages) const;
    [[nodiscard]] const Surface& surface(std::uint32_t material) const {
        return material < surfaces_.size() ? surfaces_[material] : none_;
    }
    [[nodiscard]] Rgb color_at(const Input& input, Vec2 uv, float width) const;
    [[nodiscard]] Rgb mean_color(const Input& input, Vec2 a, Vec2 b, Vec2 c) const;

    const TextureSet* textures_;
    std::vector<Surface> surfaces_;
    Surface none_;
};

}  // namespace gg
