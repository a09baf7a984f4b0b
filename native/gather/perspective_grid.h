// A grid over what the camera sees: even in the picture, finer close by. Cells split into five tetrahedra with matching
// faces, so four vertices with linear weights do for any point [Scheel et al. 2002, section 4.2].
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.h"
#include "film/camera.h"

namespace gg {

enum class DepthLaw : std::uint8_t {
    kLogarithmic,  // cells keep their shape
    kReciprocal,   // even steps of 1/z, as after perspective projection
    kLinear,       // for orthographic cameras
};

struct GridSettings {
    float cell = 20;                       // side of a cell, pixels
    float nearest = 0.1F, farthest = 100;  // m, depth of the first and last layer of vertices; 0 < nearest <= farthest
    DepthLaw law = DepthLaw::kLogarithmic;
};

// The four vertices around a point; weights are >= 0 and sum to 1.
struct GridPlace {
    std::array<std::uint32_t, 4> vertices{};
    std::array<float, 4> weights{};
};

class PerspectiveGrid {
  public:
    // width, height: of the full picture in pixels.
    PerspectiveGrid(const PixelCamera& camera, float width, float height, const GridSettings& settings);

    // Points outside of the grid belong to its outermost cells, at their nearest point.
    [[nodiscard]] GridPlace place(Vec3 point) const;
    // The world's point so many cells from a vertex along x, y and depth; at the grid's rim no farther than that.
    [[nodiscard]] Vec3 near_vertex(std::uint32_t vertex, Vec3 cells) const;
    // How many cells as wide as those in the middle between two points lie between them. What lies along the view
    // direction counts less: it is seen foreshortened.
    [[nodiscard]] float cells_between(Vec3 a, Vec3 b) const;
    // The cell that it lies in, counted through.
    [[nodiscard]] std::uint32_t cell_at(Vec3 point) const;
    [[nodiscard]] std::uint32_t vertex_count() const { return count_[0] * count_[1] * count_[2]; }

  private:
    struct InCell {
        std::array<std::uint32_t, 3> cell{};
        Vec3 inside{0.0F};  // 0..1
    };
    [[nodiscard]] InCell locate(Vec3 point) const;
    [[nodiscard]] float layer(float depth) const;     // 0..1
    [[nodiscard]] float depth_of(float layer) const;  // its inverse, m

    PixelCamera camera_;
    GridSettings settings_;
    std::array<std::uint32_t, 3> count_{};  // vertices along x, y, depth; each >= 2
};

// Within a unit cube: corner bits x | y << 1 | z << 2 and weights of the tetrahedron around p in [0, 1]^3. odd: cubes
// next to even ones are mirrored, so that faces match.
struct CubePlace {
    std::array<int, 4> corners{};
    std::array<float, 4> weights{};
};
[[nodiscard]] CubePlace place_in_cube(Vec3 p, bool odd);

}  // namespace gg
