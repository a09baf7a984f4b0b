// What is all around a point or a site, found by rays in fixed directions: all light that senders apart do not bring.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "gather/direction_table.h"
#include "gather/node_order.h"
#include "gather/receiver.h"
#include "radiosity/solution.h"
#include "trace/ray_tracer.h"

namespace gg {

// One ray into each of these cells of the sky's quadtrees.
inline constexpr std::uint8_t kSiteLevel = 5;  // around a site
inline constexpr std::uint32_t kSiteSide = 1U << kSiteLevel, kSiteCells = 2 * kSiteSide * kSiteSide;

[[nodiscard]] constexpr std::uint32_t site_index(SkyCell cell) {
    return (cell.face * kSiteSide + cell.j) * kSiteSide + cell.i;
}
[[nodiscard]] constexpr SkyCell site_cell(std::uint32_t index) {
    return {kSiteLevel, static_cast<std::uint8_t>(index / (kSiteSide * kSiteSide)),
            static_cast<std::uint16_t>(index % kSiteSide), static_cast<std::uint16_t>(index / kSiteSide % kSiteSide)};
}

// In which the table's cell of that index is looked into for what is near, and four where that is looked at closely.
[[nodiscard]] Vec3 near_direction(std::uint32_t index);
inline constexpr std::uint32_t kCloseRays = 4;
[[nodiscard]] std::array<Vec3, kCloseRays> close_directions(std::uint32_t index);

// Distances [m] up to which surfaces are looked for at every point.
struct Reach {
    float full = 0, none = 0;  // what is closer than `full` is all near, what is farther than `none` all far

    [[nodiscard]] float nearness(float distance) const {
        return distance < full ? 1.0F : (distance < none ? (none - distance) / (none - full) : 0.0F);
    }
};

// A point that looks at what is near.
struct NearPoint {
    Vec3 position{0.0F}, normal{0.0F};
    TableCellSet cells;             // that it looks into once
    float reach = 0;                // m
    TableCellSet close_cells = {};  // into which it looks four times, besides
};

struct RayOrigin {
    std::uint32_t point = 0, cell = 0;  // as of Met
    bool close = false;
};

struct Met {
    std::uint32_t point = 0;  // of those that look at what is near
    std::uint32_t cell = 0;   // of the directions that were asked for
    std::uint32_t rank = 0;   // of the place that was hit
    float distance = 0;       // m
    Rgb radiance{0.0F};
    bool close = false;  // one of four rays into the cell
};

// What a cell's ray met.
enum class Seen : std::uint8_t { kNothing, kSky, kSurface };  // kNothing: no receiver faces the direction

// For one thread.
class Surroundings {
  public:
    Surroundings(const Solution& solution, const NodeOrder& order, const RayTracer& tracer);

    // Into each of kSiteCells, from one of the receivers that face it, in turn.
    void look_from(std::span<const Receiver> receivers);
    [[nodiscard]] std::span<const Met> met() const { return met_; }
    [[nodiscard]] std::span<const Seen> seen() const { return seen_; }
    [[nodiscard]] std::size_t ray_count() const { return rays_.size(); }
    [[nodiscard]] std::span<const Ray> rays() const { return rays_; }
    [[nodiscard]] std::span<const RayOrigin> origins() const { return origins_; }  // of the rays

    // After look_from(): four more rays into each of kSiteCells within those table cells.
    void look_closer(std::span<const Receiver> receivers, const TableCellSet& cells);

    // Adds what was met to the table: but for what lies in `apart` and, if reach is not 0, for what is near, unless
    // nothing else was met in a cell.
    void add_to(DirectionTable& table, std::span<const RankRange> apart, const Reach& reach) const;

    // Table cells in which something was nearer than that, m.
    [[nodiscard]] TableCellSet near_cells(float distance) const;

    // Into a fixed direction of each of their cells, or into four of close ones, as far as their reach; Met::cell: of
    // the table. Points that are neighbours send parallel rays together.
    void look_near(std::span<const NearPoint> points);

  private:
    // Rays from that one on; adds to what was met.
    void trace(std::size_t first);

    const Solution& solution_;
    const NodeOrder& order_;
    const RayTracer& tracer_;
    struct Direction {
        std::uint32_t cell = 0;
        Vec3 direction{0.0F};
        bool close = false;
    };
    // Of the site's cells, of their children, and of the table's cells, neighbours next to one another: their rays take
    // similar ways.
    std::vector<Direction> site_directions_, closer_directions_, near_directions_;
    std::vector<Ray> rays_;
    std::vector<RayOrigin> origins_;  // per ray
    std::vector<Hit> hits_;
    std::vector<Met> met_;
    std::vector<Seen> seen_;
};

}  // namespace gg
