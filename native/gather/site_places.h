// Where sites stand, and which of them a point lies between: vertices of the surfaces themselves, where their triangles
// are larger than cells of the grid, else vertices of the grid [Scheel et al. 2002, section 4.5].
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "film/fragments.h"
#include "gather/perspective_grid.h"
#include "radiosity/surface_mesh.h"

namespace gg {

class Control;

// A grid around what is seen. settings: nearest and farthest are found.
[[nodiscard]] PerspectiveGrid fit_grid(const View& view, float width, float height,
                                       std::span<const TileFragments> tiles, GridSettings settings);

// Weights change continuously from point to point, are > 0 and sum to 1.
struct SitePlace {
    // Three of a surface and four of the grid, where one fades into the other.
    static constexpr std::uint32_t kMost = 7;
    std::array<std::uint32_t, kMost> vertices{};
    std::array<float, kMost> weights{};
    std::uint32_t count = 0;
    float on_surface = 0;  // sum of weights of the surface's vertices

    void add(std::uint32_t vertex, float weight);
};

// The triangles of what is seen as far as they are worth sites of their own. as_published: see SurfaceMesh.
[[nodiscard]] SurfaceMesh fit_surfaces(const Solution& solution, const PerspectiveGrid& grid,
                                       std::span<const TileFragments> tiles, bool as_published, const Control& control);

class SitePlaces {
  public:
    // surfaces: null where the grid does for all. Both must outlive this.
    SitePlaces(const PerspectiveGrid& grid, const SurfaceMesh* surfaces) : grid_(grid), surfaces_(surfaces) {}

    [[nodiscard]] SitePlace of(const Fragment& at) const;
    // The grid's come first.
    [[nodiscard]] std::uint32_t vertex_count() const {
        return grid_.vertex_count() + (surfaces_ != nullptr ? surfaces_->vertex_count() : 0);
    }
    [[nodiscard]] bool is_of_grid(std::uint32_t vertex) const { return vertex < grid_.vertex_count(); }
    [[nodiscard]] const PerspectiveGrid& grid() const { return grid_; }

  private:
    const PerspectiveGrid& grid_;
    const SurfaceMesh* surfaces_;
};

}  // namespace gg
