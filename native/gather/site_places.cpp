#include "gather/site_places.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

constexpr float kFewest = 0.005F;          // share of what is seen that may be nearer or farther than the grid
constexpr float kBeyond = 1.05F;           // by which the grid reaches farther than that
constexpr std::size_t kEveryFragment = 7;  // that depths are taken from
constexpr float kSpacing = 1;              // longest side of a part of a surface, in cells
constexpr float kNothing = 1e-4F;          // weight of the grid that is only rounding

SurfaceSpot spot_of(const Fragment& at) {
    return {at.hit.instance, at.hit.triangle, at.back, {at.hit.u, at.hit.v}};
}

}  // namespace

PerspectiveGrid fit_grid(const View& view, float width, float height, std::span<const TileFragments> tiles,
                         GridSettings settings) {
    std::vector<float> depths;
    for (const TileFragments& tile : tiles) {
        for (std::size_t f = 0; f < tile.fragments.size(); f += kEveryFragment) {
            depths.push_back(view.camera.project(tile.fragments[f].position).z);
        }
    }
    if (!depths.empty()) {
        std::sort(depths.begin(), depths.end());
        const auto few = static_cast<std::size_t>(kFewest * static_cast<float>(depths.size()));
        settings.nearest = std::max(depths[few] / kBeyond, 1e-4F);
        settings.farthest = std::max(depths[depths.size() - 1 - few] * kBeyond, settings.nearest);
    }
    return {view.camera, width, height, settings};
}

SurfaceMesh fit_surfaces(const Solution& solution, const PerspectiveGrid& grid, std::span<const TileFragments> tiles,
                         bool as_published, const Control& control) {
    SurfaceMesh mesh(solution, {[&grid](Vec3 a, Vec3 b) { return grid.cells_between(a, b) / kSpacing; }, as_published});
    const auto unique = [](std::vector<SurfacePart>& parts) {
        std::sort(parts.begin(), parts.end());
        parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    };
    auto seen = parallel_collect<SurfacePart>(tiles.size(), 1, control,
                                              [&](std::size_t begin, std::size_t end, std::vector<SurfacePart>& out) {
                                                  for (std::size_t i = begin; i < end; ++i) {
                                                      for (const Fragment& at : tiles[i].fragments) {
                                                          out.push_back(mesh.part_at(spot_of(at)));
                                                      }
                                                  }
                                                  unique(out);
                                              });
    unique(seen);
    mesh.divide(seen);
    return mesh;
}

void SitePlace::add(std::uint32_t vertex, float weight) {
    if (weight > 0) {
        vertices[count] = vertex;
        weights[count++] = weight;
    }
}

SitePlace SitePlaces::of(const Fragment& at) const {
    SitePlace result;
    if (surfaces_ != nullptr) {
        const SurfacePlace place = surfaces_->place(spot_of(at));
        result.on_surface = std::min(place.sum(), 1.0F);
        for (int k = 0; k < 3; ++k) {
            result.add(grid_.vertex_count() + place.vertices[k], place.weights[k]);
        }
    }
    const float rest = 1 - result.on_surface;
    if (rest > kNothing) {
        const GridPlace place = grid_.place(at.position);
        for (int k = 0; k < 4; ++k) {
            result.add(place.vertices[k], rest * place.weights[k]);
        }
    } else {
        for (float& weight : result.weights) {
            weight /= result.on_surface;
        }
    }
    return result;
}

}  // namespace gg
