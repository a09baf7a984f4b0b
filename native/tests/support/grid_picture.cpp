#include "support/grid_picture.h"

#include <algorithm>

#include "core/parallel.h"
#include "gather/make_sites.h"
#include "trace/surface_point.h"

namespace gg::test {

namespace {

constexpr std::size_t kTogether = 32;  // points that are shaded at once, as in pictures

std::vector<TileFragments> trace_tiles(const View& view, const Control& control) {
    const Film film(view.settings.crop.width, view.settings.crop.height);
    std::vector<TileFragments> tiles(film.tile_count());
    parallel_for(tiles.size(), 1, control,
                 [&](std::size_t i) { tiles[i] = trace_tile(view, film.tile(static_cast<std::uint32_t>(i))); });
    return tiles;
}

PerspectiveGrid grid_of(const View& view, const std::vector<TileFragments>& tiles, const PictureSettings& settings) {
    GridSettings cells;
    cells.cell = settings.cell;
    return fit_grid(view, static_cast<float>(settings.width), static_cast<float>(settings.height), tiles, cells);
}

}  // namespace

CameraDescription camera_at(Vec3 eye, Vec3 target) {
    const Vec3 back = normalize_or_zero(eye - target), right = normalize_or_zero(cross(Vec3(0, 0, 1), back));
    CameraDescription camera;
    camera.to_world.linear = Mat3(right, cross(back, right), back);
    camera.to_world.translation = eye;
    const float window[4] = {-0.7F, 0.7F, -0.35F, 0.35F};
    std::copy(std::begin(window), std::end(window), camera.window);
    camera.clip_end = 1000;
    return camera;
}

Fragment fragment_at(const Scene& scene, std::uint32_t instance, std::uint32_t triangle, Vec2 weights) {
    Fragment at;
    at.hit = {instance, triangle, weights.x, weights.y, 1};
    const SurfacePoint point = surface_point(scene, at.hit);
    at.position = point.position;
    at.normal = point.geometric_normal;
    at.shading_normal = point.shading_normal;
    at.share = 1;
    at.albedo = Rgb(0.5F);
    return at;
}

GridPicture::GridPicture(const SceneDescription& description, const CameraDescription& camera,
                         const PictureSettings& settings)
    : prepared(description),
      solution(prepared.solve()),
      points(*solution, prepared.control),
      order(hierarchy_of(*solution)),
      view{prepared.scene,
           *prepared.tracer,
           *prepared.colors,
           PixelCamera(camera, settings.width, settings.height),
           PixelFilter(FilterType::kBlackmanHarris, 1.5F),
           {{0, 0, settings.width, settings.height}}},
      tiles(trace_tiles(view, prepared.control)),
      grid(grid_of(view, tiles, settings)),
      surfaces(fit_surfaces(*solution, grid, tiles, false, prepared.control)),
      places(grid, settings.surfaces ? &surfaces : nullptr),
      receivers(*solution, view, places, tiles, nullptr, prepared.control) {
    ClassifySettings classify;
    classify.samples = settings.samples;
    classify.threshold = settings.threshold;
    classify.mean_radiosity = receivers.mean_radiosity();
    sites = make_sites(*solution, order, points, *prepared.tracer, places, receivers, classify, {}, false,
                       prepared.control, prepared.statistics);
}

PlacedFragment GridPicture::place(const Fragment& at) const {
    const SitePlace among = places.of(at);
    PlacedFragment placed{at, {}, 0, among.on_surface};
    float sum = 0;
    for (std::uint32_t k = 0; k < among.count; ++k) {
        const std::uint32_t site = receivers.site_at(among.vertices[k]);
        if (site != kNone) {
            placed.around[placed.count++] = {&sites[site], among.weights[k]};
            sum += among.weights[k];
        }
    }
    for (std::uint32_t k = 0; k < placed.count; ++k) {
        placed.around[k].weight /= sum;
    }
    return placed;
}

std::vector<Fragment> GridPicture::some_fragments(std::size_t count) const {
    std::vector<Fragment> all, some;
    for (const TileFragments& tile : tiles) {
        all.insert(all.end(), tile.fragments.begin(), tile.fragments.end());
    }
    const std::size_t stride = std::max<std::size_t>(1, all.size() / count);
    for (std::size_t i = stride / 2; i < all.size(); i += stride) {
        some.push_back(all[i]);
    }
    return some;
}

std::vector<Rgb> light_at(Shader& shader, const std::vector<PlacedFragment>& points) {
    std::vector<PointLight> light(points.size());
    std::vector<PointCounts> taken(points.size());
    for (std::size_t begin = 0; begin < points.size(); begin += kTogether) {
        const std::size_t count = std::min(kTogether, points.size() - begin);
        shader.shade(std::span(points).subspan(begin, count), std::span(light).subspan(begin, count),
                     std::span(taken).subspan(begin, count));
    }
    std::vector<Rgb> all;
    for (const PointLight& of_point : light) {
        all.push_back(of_point.all);
    }
    return all;
}

}  // namespace gg::test
