#include "material/surface_color.h"

#include <algorithm>
#include <cmath>

#include "core/messages.h"

namespace gg {

namespace {

constexpr Rgb kDefaultGrey{0.8F};

// Parts of each side of a triangle whose longest side in the image is so many texels. Small triangles of dense meshes
// need few.
int strata_for(float texels) {
    return texels <= 0.5F ? 1 : (texels <= 3 ? 2 : 4);
}

}  // namespace

SurfaceColors::SurfaceColors(const Scene& scene, const TextureSet& textures, Messages& messages)
    : textures_(&textures) {
    none_.reflectance.factor = kDefaultGrey;
    none_.reflectance.limit = kLargestReflectance;
    surfaces_.reserve(scene.materials.size());
    for (const MaterialDescription& material : scene.materials) {
        surfaces_.push_back(
            {make_input(material.reflectance, kLargestReflectance, material.name, "Reflectance", messages),
             make_input(material.emission, kInfinity, material.name, "Emission", messages)});
    }
}

SurfaceColors::Input SurfaceColors::make_input(const ColorInput& color, float limit, const std::string& material,
                                               const char* use, Messages& messages) const {
    Input input;
    input.limit = limit;
    if (!is_finite(color.factor) || glm::any(glm::lessThan(color.factor, Rgb(0)))) {
        messages.add(material, std::string(use) + " is negative or infinite: taken as 0");
        return input;
    }
    input.factor = color.factor;
    if (color.image == kNone || color.factor == Rgb(0)) {
        return input;
    }
    const float* m = color.uv_map;
    if (!std::all_of(m, m + 6, [](float value) { return std::isfinite(value); })) {
        messages.add(material, std::string(use) + " has a texture mapping that is not finite: image ignored");
    } else if (color.image >= textures_->size()) {
        messages.add(material, std::string(use) + " uses an image that does not exist: image ignored");
    } else {
        input.image = color.image;
        input.map_u = {m[0], m[1]};
        input.map_v = {m[3], m[4]};
        input.offset = {m[2], m[5]};
        input.stretch = std::sqrt(0.5F * (dot(input.map_u, input.map_u) + dot(input.map_v, input.map_v)));
    }
    return input;
}

Rgb SurfaceColors::color_at(const Input& input, Vec2 uv, float width) const {
    Rgb color = input.factor;
    if (input.image != kNone) {
        const Vec2 mapped = Vec2(dot(input.map_u, uv), dot(input.map_v, uv)) + input.offset;
        color *= textures_->lookup(input.image, mapped, width * input.stretch);
    }
    return glm::clamp(color, Rgb(0), Rgb(input.limit));
}

Rgb SurfaceColors::mean_color(const Input& input, Vec2 a, Vec2 b, Vec2 c) const {
    if (input.image == kNone) {
        return color_at(input, a, 0);
    }
    const Vec2 ab = b - a;
    const Vec2 ac = c - a;
    const Vec2 bc = c - b;
    const float longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
    const int strata = strata_for(longest * input.stretch * static_cast<float>(textures_->resolution(input.image)));
    const float step = 1 / static_cast<float>(strata);
    const float width = std::sqrt(0.5F * std::abs(ab.x * ac.y - ab.y * ac.x)) * step;
    // The triangle is cut into strata^2 equal ones, some upright, some turned; each is sampled at its centre.
    Rgb sum(0);
    for (int row = 0; row < strata; ++row) {
        for (int column = 0; column < strata - row; ++column) {
            const Vec2 corner = a + step * (static_cast<float>(column) * ab + static_cast<float>(row) * ac);
            sum += color_at(input, corner + step / 3 * (ab + ac), width);
            if (column + 1 < strata - row) {
                sum += color_at(input, corner + 2 * step / 3 * (ab + ac), width);
            }
        }
    }
    return sum * step * step;
}

Rgb SurfaceColors::reflectance_at(std::uint32_t material, Vec2 uv, float width) const {
    return color_at(surface(material).reflectance, uv, width);
}

Rgb SurfaceColors::emission_at(std::uint32_t material, Vec2 uv, float width) const {
    return color_at(surface(material).emission, uv, width);
}

Rgb SurfaceColors::mean_reflectance(std::uint32_t material, Vec2 a, Vec2 b, Vec2 c) const {
    return mean_color(surface(material).reflectance, a, b, c);
}

Rgb SurfaceColors::mean_emission(std::uint32_t material, Vec2 a, Vec2 b, Vec2 c) const {
    return mean_color(surface(material).emission, a, b, c);
}

bool SurfaceColors::is_textured(std::uint32_t material) const {
    return surface(material).reflectance.image != kNone || surface(material).emission.image != kNone;
}

bool SurfaceColors::emits(std::uint32_t material) const {
    return max_component(surface(material).emission.factor) > 0;
}

}  // namespace gg
