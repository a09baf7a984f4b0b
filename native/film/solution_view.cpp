#include "film/solution_view.h"

#include <atomic>
#include <vector>

#include "core/control.h"
#include "core/parallel.h"
#include "material/surface_color.h"

namespace gg {

namespace {

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

// Radiance that the ray brings from what it met.
Rgb surface_radiance(const View& view, const Ray& ray, const Hit& hit) {
    const Instance& instance = view.scene.instances[hit.instance];
    const Mesh& mesh = view.scene.meshes[instance.mesh];
    const TriangleCorners& corners = mesh.triangles[hit.triangle];
    const Vec3 p0 = mesh.positions[corners[0]];
    const Vec3 normal =
        instance.normal_to_world * cross(mesh.positions[corners[1]] - p0, mesh.positions[corners[2]] - p0);
    const float facing = dot(normal, ray.direction);
    const std::uint32_t material = view.scene.material_of(hit.instance, hit.triangle);

    Vec2 uv(0);
    float uv_width = 0;
    if (view.colors.is_textured(material) && !mesh.uvs.empty()) {
        uv = uv_at(mesh, hit);
        // A sample's share of its pixel covers size^2 / cos of the surface; textures average over a square like it.
        const float size = view.camera.pixel_size(hit.distance);
        const float across = std::abs(facing) / length(ray.direction);  // twice the triangle's area as seen
        const float share = size * size / static_cast<float>(view.settings.samples);
        uv_width = std::sqrt(share * uv_area(mesh, hit.triangle) / std::max(across, 1e-30F));
    }
    const Rgb irradiance = view.irradiance_at(hit, facing > 0);
    return view.colors.reflectance_at(material, uv, uv_width) * irradiance / kPi +
           view.colors.emission_at(material, uv, uv_width);
}

// Buffers for one row of a tile.
struct RowBuffers {
    std::vector<Ray> rays;
    std::vector<Hit> hits;
};

std::uint64_t pixel_id(std::uint32_t x, std::uint32_t y) {
    return std::uint64_t{y} << 32 | x;
}

void trace_row(const View& view, const Rectangle& row, RowBuffers& buffers) {
    const std::uint32_t samples = view.settings.samples;
    buffers.rays.resize(std::size_t{row.width} * samples);
    buffers.hits.resize(buffers.rays.size());
    std::size_t next = 0;
    for (std::uint32_t column = 0; column < row.width; ++column) {
        // Counted in the full picture: a crop shows what the full picture shows.
        const std::uint32_t x = view.settings.crop.x + row.x + column;
        const std::uint32_t y = view.settings.crop.y + row.y;
        for (std::uint32_t sample = 0; sample < samples; ++sample) {
            const Vec2 offset = view.filter.offset(pixel_id(x, y), sample);
            buffers.rays[next++] =
                view.camera.ray(static_cast<float>(x) + 0.5F + offset.x, static_cast<float>(y) + 0.5F + offset.y);
        }
    }
    view.tracer.closest_hits(buffers.rays, buffers.hits, RayMask::kCamera, Coherence::kCoherent);
}

// The mean of a pixel's samples; returns how many were dropped.
std::uint32_t resolve_pixel(const View& view, std::span<const Ray> rays, std::span<const Hit> hits, Rgba& pixel) {
    Rgb color(0);
    float alpha = 0;
    std::uint32_t kept = 0;
    for (std::size_t sample = 0; sample < rays.size(); ++sample) {
        const bool is_sky = hits[sample].missed();
        const bool is_clear = is_sky && view.settings.film_transparent;
        const Rgb radiance =
            is_clear ? Rgb(0) : (is_sky ? view.scene.world : surface_radiance(view, rays[sample], hits[sample]));
        if (is_finite(radiance)) {
            color += radiance;
            alpha += is_clear ? 0.0F : 1.0F;
            ++kept;
        }
    }
    if (kept > 0) {
        pixel = {color * (view.settings.exposure / static_cast<float>(kept)), alpha / static_cast<float>(kept)};
    }
    return static_cast<std::uint32_t>(rays.size()) - kept;
}

std::uint64_t render_tile(const View& view, const Rectangle& tile, std::span<Rgba> pixels) {
    const std::uint32_t samples = view.settings.samples;
    RowBuffers buffers;
    std::uint64_t dropped = 0;
    for (std::uint32_t row = 0; row < tile.height; ++row) {
        trace_row(view, {tile.x, tile.y + row, tile.width, 1}, buffers);
        for (std::uint32_t column = 0; column < tile.width; ++column) {
            const std::size_t first = std::size_t{column} * samples;
            dropped += resolve_pixel(view, std::span(buffers.rays).subspan(first, samples),
                                     std::span(buffers.hits).subspan(first, samples),
                                     pixels[std::size_t{row} * tile.width + column]);
        }
    }
    return dropped;
}

}  // namespace

ViewCounts render_view(const View& view, Film& film, Control& control) {
    std::atomic<std::uint64_t> dropped{0};
    std::atomic<std::uint32_t> finished{0};
    parallel_for(film.tile_count(), 1, control, [&](std::size_t index) {
        const Rectangle tile = film.tile(static_cast<std::uint32_t>(index));
        std::vector<Rgba> pixels(std::size_t{tile.width} * tile.height);
        dropped += render_tile(view, tile, pixels);
        film.finish_tile(static_cast<std::uint32_t>(index), pixels);
        control.set_stage_progress(static_cast<float>(++finished) / static_cast<float>(film.tile_count()));
    });
    const std::uint64_t pixels = std::uint64_t{view.settings.crop.width} * view.settings.crop.height;
    return {pixels * view.settings.samples, dropped};
}

}  // namespace gg
