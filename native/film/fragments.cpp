#include "film/fragments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "material/surface_color.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kSameNormal = 0.97F;  // cosine of the largest angle within a fragment
constexpr float kSamePlane = 2;       // largest distance from a fragment's plane, in pixels

// Twice the area of the triangle in texture coordinates.
float uv_area(const Mesh& mesh, std::uint32_t triangle) {
    const Vec2* uvs = &mesh.uvs[std::size_t{3} * triangle];
    const Vec2 a = uvs[1] - uvs[0];
    const Vec2 b = uvs[2] - uvs[0];
    return std::abs(a.x * b.y - a.y * b.x);
}

Vec2 uv_at(const Mesh& mesh, const Hit& hit) {
    const Vec2* uvs = &mesh.uvs[std::size_t{3} * hit.triangle];
    return (1 - hit.u - hit.v) * uvs[0] + hit.u * uvs[1] + hit.v * uvs[2];
}

struct Colors {
    Rgb albedo{0.0F}, emission{0.0F};
};

Colors colors_at(const View& view, const Ray& ray, const Hit& hit) {
    const Instance& instance = view.scene.instances[hit.instance];
    const Mesh& mesh = view.scene.meshes[instance.mesh];
    const std::uint32_t material = view.scene.material_of(hit.instance, hit.triangle);
    Vec2 uv(0);
    float uv_width = 0;
    if (view.colors.is_textured(material) && !mesh.uvs.empty()) {
        uv = uv_at(mesh, hit);
        // A sample's share of its pixel covers size^2 / cos of the surface; textures average over a square like it.
        const TriangleCorners& corners = mesh.triangles[hit.triangle];
        const Vec3 p0 = mesh.positions[corners[0]];
        const Vec3 normal =
            instance.normal_to_world * cross(mesh.positions[corners[1]] - p0, mesh.positions[corners[2]] - p0);
        const float size = view.camera.pixel_size(hit.distance);
        const float across = std::abs(dot(normal, ray.direction)) / length(ray.direction);  // twice the area as seen
        const float share = size * size / static_cast<float>(view.settings.samples);
        uv_width = std::sqrt(share * uv_area(mesh, hit.triangle) / std::max(across, 1e-30F));
    }
    return {view.colors.reflectance_at(material, uv, uv_width), view.colors.emission_at(material, uv, uv_width)};
}

std::uint64_t pixel_id(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{y} << 32 | x;
}

// One pixel after the other.
class PixelBuilder {
  public:
    // irradiance_at: null where fragments are wanted.
    PixelBuilder(const View& view, const IrradianceAt* irradiance_at, TileFragments& out)
        : view_(view), irradiance_at_(irradiance_at), out_(out) {}

    void add(std::span<const Ray> rays, std::span<const Hit> hits) {
        PixelFragments pixel;
        parts_.clear();
        std::uint32_t kept = 0;
        for (std::size_t sample = 0; sample < rays.size(); ++sample) {
            kept += add_sample(rays[sample], hits[sample], pixel) ? 1 : 0;
        }
        const float share = 1 / static_cast<float>(rays.size());
        pixel.emitted *= share;
        pixel.alpha *= share;
        pixel.kept = share * static_cast<float>(kept);
        for (Part& part : parts_) {
            part.fragment.albedo *= share;
            part.fragment.share = share * static_cast<float>(part.places.size());
            choose_place(part);
            out_.fragments.push_back(part.fragment);
        }
        pixel.end = static_cast<std::uint32_t>(out_.fragments.size());
        out_.pixels.push_back(pixel);
    }

  private:
    struct Place {
        Hit hit;
        SurfacePoint point;  // of the side that is seen
    };
    struct Part {
        Fragment fragment;
        float tolerance = 0;  // m from the plane of the first place
        std::vector<Place> places;
    };

    // False for a sample that is not finite.
    bool add_sample(const Ray& ray, const Hit& hit, PixelFragments& pixel) {
        if (hit.missed()) {
            if (!view_.settings.film_transparent) {
                pixel.emitted += view_.scene.world;
                pixel.alpha += 1;
            }
            return true;
        }
        Place place{hit, surface_point(view_.scene, hit)};
        const bool back = dot(place.point.geometric_normal, ray.direction) > 0;
        if (back) {
            place.point.geometric_normal = -place.point.geometric_normal;
            place.point.shading_normal = -place.point.shading_normal;
        }
        const Colors colors = colors_at(view_, ray, hit);
        if (!is_finite(colors.albedo) || !is_finite(colors.emission)) {
            return false;
        }
        if (irradiance_at_ != nullptr) {
            const Rgb reflected = colors.albedo * (*irradiance_at_)(hit, back) / kPi;
            if (!is_finite(reflected)) {
                return false;
            }
            pixel.emitted += reflected;
        }
        pixel.emitted += colors.emission;
        pixel.alpha += 1;
        if (irradiance_at_ != nullptr) {
            return true;
        }
        Part& part = part_of(place, back);
        part.fragment.albedo += colors.albedo;
        part.places.push_back(place);
        return true;
    }

    Part& part_of(const Place& place, bool back) {
        for (Part& part : parts_) {
            const Place& first = part.places.front();
            if (part.fragment.hit.instance == place.hit.instance && part.fragment.back == back &&
                dot(first.point.shading_normal, place.point.shading_normal) > kSameNormal &&
                std::abs(dot(place.point.position - first.point.position, first.point.geometric_normal)) <
                    part.tolerance) {
                return part;
            }
        }
        parts_.emplace_back();
        parts_.back().fragment.hit = place.hit;
        parts_.back().fragment.back = back;
        parts_.back().tolerance = kSamePlane * view_.camera.pixel_size(place.hit.distance);
        return parts_.back();
    }

    // The place next to the middle stands for all.
    static void choose_place(Part& part) {
        Vec3 middle(0.0F);
        for (const Place& place : part.places) {
            middle += place.point.position / static_cast<float>(part.places.size());
        }
        const Place* best = nullptr;
        float least = kInfinity;
        for (const Place& place : part.places) {
            const float distance = length_squared(place.point.position - middle);
            if (best == nullptr || distance < least) {
                least = distance;
                best = &place;
            }
        }
        part.fragment.hit = best->hit;
        part.fragment.position = best->point.position;
        part.fragment.normal = best->point.geometric_normal;
        part.fragment.shading_normal = best->point.shading_normal;
    }

    const View& view_;
    const IrradianceAt* irradiance_at_;
    TileFragments& out_;
    std::vector<Part> parts_;
};

TileFragments trace(const View& view, const Rectangle& tile, const IrradianceAt* irradiance_at) {
    TileFragments result;
    result.tile = tile;
    result.pixels.reserve(std::size_t{tile.width} * tile.height);
    const std::uint32_t samples = view.settings.samples;
    std::vector<Ray> rays(std::size_t{tile.width} * samples);
    std::vector<Hit> hits(rays.size());
    PixelBuilder builder(view, irradiance_at, result);
    for (std::uint32_t row = 0; row < tile.height; ++row) {
        std::size_t next = 0;
        for (std::uint32_t column = 0; column < tile.width; ++column) {
            // Counted in the full picture: a crop shows what the full picture shows.
            const std::uint32_t x = view.settings.crop.x + tile.x + column;
            const std::uint32_t y = view.settings.crop.y + tile.y + row;
            for (std::uint32_t sample = 0; sample < samples; ++sample) {
                const Vec2 offset = view.filter.offset(pixel_id(x, y), sample);
                rays[next++] =
                    view.camera.ray(static_cast<float>(x) + 0.5F + offset.x, static_cast<float>(y) + 0.5F + offset.y);
            }
        }
        view.tracer.closest_hits(rays, hits, RayMask::kCamera, Coherence::kCoherent);
        for (std::uint32_t column = 0; column < tile.width; ++column) {
            const std::size_t first = std::size_t{column} * samples;
            builder.add(std::span(rays).subspan(first, samples), std::span(hits).subspan(first, samples));
        }
    }
    return result;
}

}  // namespace

TileFragments trace_tile(const View& view, const Rectangle& tile) {
    return trace(view, tile, nullptr);
}

TileFragments trace_lit_tile(const View& view, const Rectangle& tile, const IrradianceAt& irradiance_at) {
    return trace(view, tile, &irradiance_at);
}

std::uint64_t resolve_tile(const View& view, const TileFragments& tile, std::span<const Rgb> irradiance,
                           std::span<Rgba> pixels) {
    float dropped = 0;  // pixels
    for (std::size_t p = 0; p < tile.pixels.size(); ++p) {
        const PixelFragments& pixel = tile.pixels[p];
        Rgb color = pixel.emitted;
        float kept = pixel.kept;
        for (std::uint32_t f = tile.begin_of(p); f < pixel.end; ++f) {
            const Rgb reflected = tile.fragments[f].albedo * irradiance[f] / kPi;
            if (is_finite(reflected)) {
                color += reflected;
            } else {
                kept -= tile.fragments[f].share;
            }
        }
        // What remains is less than a sample only by rounding.
        const bool any = kept * static_cast<float>(view.settings.samples) > 0.5F;
        pixels[p] = any ? Rgba{color * (view.settings.exposure / kept), std::min(pixel.alpha / kept, 1.0F)} : Rgba{};
        dropped += 1 - kept;
    }
    return static_cast<std::uint64_t>(std::lround(dropped * static_cast<float>(view.settings.samples)));
}

}  // namespace gg
