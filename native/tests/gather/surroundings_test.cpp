// What rays in fixed directions find, held against closed rooms and against many random rays.
#include "gather/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/random.h"
#include "gather/sky_leaves.h"
#include "support/law_scenes.h"
#include "trace/surface_point.h"
#include "transport/sky_cell.h"

namespace gg::test {
namespace {

// A furnace without furniture: 2 W/m2 from everywhere.
struct Around {
    Prepared prepared{furnace(0.5F, false)};
    std::shared_ptr<const Solution> solution = prepared.solve();
    NodeOrder order{hierarchy_of(*solution)};
    Surroundings surroundings{*solution, order, *prepared.tracer};
    Receiver floor{{1, 1, 0.001F}, {0, 0, 1}, {0, 0, 1}, kNone, 0.5F, 2};
};

TEST(NodeOrder, ranges_nest) {
    Around room;
    const Hierarchy& hierarchy = hierarchy_of(*room.solution);
    std::vector<int> taken(hierarchy.nodes().size());
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const RankRange range = room.order.range(id);
        EXPECT_EQ(++taken[room.order.rank(id)], 1);
        if (const NodeId parent = hierarchy[id].parent; parent != kNone) {
            const RankRange above = room.order.range(parent);
            EXPECT_TRUE(above.begin < range.begin && range.end <= above.end);
        }
    }
}

TEST(NodeOrder, holds_finds_the_range) {
    const std::array<RankRange, 2> ranges{RankRange{3, 5}, RankRange{9, 10}};
    for (std::uint32_t rank = 0; rank < 12; ++rank) {
        EXPECT_EQ(holds(ranges, rank), rank == 3 || rank == 4 || rank == 9) << rank;
    }
    EXPECT_FALSE(holds({}, 1));
}

TEST(Surroundings, a_furnace_shines_from_everywhere) {
    Around room;
    room.surroundings.look_from(std::span(&room.floor, 1));
    EXPECT_GT(room.surroundings.ray_count(), kSiteCells / 2 - 2 * kSiteSide);
    EXPECT_EQ(room.surroundings.met().size(), room.surroundings.ray_count());
    DirectionTable table;
    room.surroundings.add_to(table, {}, {});
    EXPECT_NEAR(light_of(table, TableCosines(room.floor.normal)).x, 2, 0.02F);
}

// All but the walls' part: a floor point has its ceiling's form factor.
TEST(Surroundings, what_is_apart_brings_nothing) {
    Around room;
    room.surroundings.look_from(std::span(&room.floor, 1));
    const Hierarchy& hierarchy = hierarchy_of(*room.solution);
    std::vector<RankRange> walls;
    float ceiling = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        const Node& node = hierarchy[id];
        if (node.kind == NodeKind::kElement && node.depth == 0 && node.instance < 5) {
            walls.push_back(room.order.range(id));
        }
    }
    std::sort(walls.begin(), walls.end());
    for (const Met& met : room.surroundings.met()) {
        ceiling += holds(walls, met.rank) ? 0.0F : 1.0F;
    }
    DirectionTable table;
    room.surroundings.add_to(table, walls, {});
    const float left = light_of(table, TableCosines(room.floor.normal)).x;
    // Parallel rectangles 4 x 3 m, 2.5 m apart, seen from a point 1 m from two walls: four corner factors.
    const auto corner = [](float a, float b) {
        const float x = a / 2.5F, y = b / 2.5F;
        const float p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
        return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * kPi);
    };
    const float factor = corner(1, 1) + corner(3, 1) + corner(1, 2) + corner(3, 2);
    EXPECT_GT(ceiling, 100);
    EXPECT_NEAR(left, 2 * factor, 0.04F);
}

TEST(Surroundings, near_rays_end_at_their_reach) {
    Around room;
    NearPoint point{room.floor.position, room.floor.normal, {}, 0.9F};
    point.cells.set();
    room.surroundings.look_near(std::span(&point, 1));
    EXPECT_TRUE(room.surroundings.met().empty());
    point.reach = 10;
    room.surroundings.look_near(std::span(&point, 1));
    EXPECT_EQ(room.surroundings.met().size(), room.surroundings.ray_count());
    for (const Met& met : room.surroundings.met()) {
        EXPECT_GT(met.distance, 0.99F);
    }
    const std::array<NearPoint, 3> three{point, point, point};
    const std::size_t of_one = room.surroundings.ray_count();
    room.surroundings.look_near(three);
    EXPECT_EQ(room.surroundings.ray_count(), 3 * of_one);
    EXPECT_EQ(room.surroundings.met()[4].point, 1U);
    point.cells.reset();
    room.surroundings.look_near(std::span(&point, 1));
    EXPECT_EQ(room.surroundings.ray_count(), 0U);
}

TEST(Surroundings, close_cells_have_a_ray_into_each_quarter) {
    for (std::uint32_t cell = 0; cell < kTableCells; ++cell) {
        const auto parts = children(table_cell(cell));
        const auto directions = close_directions(cell);
        for (std::size_t k = 0; k < parts.size(); ++k) {
            EXPECT_TRUE(contains(parts[k], finest_cell_at(directions[k]))) << cell << " " << k;
        }
    }
    Around room;
    NearPoint point{room.floor.position, room.floor.normal, {}, 10};
    point.close_cells.set(3);
    point.cells.set(7);
    room.surroundings.look_near(std::span(&point, 1));
    std::array<int, 2> close{}, single{};
    for (const Met& met : room.surroundings.met()) {
        ++(met.close ? close : single)[met.cell == 3 ? 0 : 1];
    }
    EXPECT_EQ(room.surroundings.ray_count(), 5U);
    EXPECT_EQ(close, (std::array<int, 2>{4, 0}));
    EXPECT_EQ(single, (std::array<int, 2>{0, 1}));
}

TEST(Reach, falls_from_near_to_far) {
    const Reach reach{1, 2};
    EXPECT_EQ(reach.nearness(0.5F), 1);
    EXPECT_EQ(reach.nearness(1.5F), 0.5F);
    EXPECT_EQ(reach.nearness(2), 0);
    EXPECT_EQ(Reach{}.nearness(0), 0);
}

// Over a triangle: the same places as by position, and the means of its elements.
TEST(LitPlace, radiosity_over_an_element_has_its_mean) {
    Prepared prepared(lamp_room(0.5F));
    const auto solution = prepared.solve();
    const Scene& scene = hierarchy_of(*solution).scene();
    const Sequence4 sequence(3);
    for (std::uint32_t wall = 0; wall < 6; ++wall) {
        double here = 0, elements = 0;
        constexpr int kPoints = 20000;
        for (int k = 0; k < kPoints; ++k) {
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
            const Hit hit{wall, 0, w.y, w.z, 1};
            const LitPlace lit = lit_place(*solution, hit, false);
            const SurfacePoint point = surface_point(scene, hit);
            ASSERT_EQ(lit.place, place_at(*solution, wall, 0, false, point.position));
            here += static_cast<double>(luminance(lit.radiosity)) / kPoints;
            elements += static_cast<double>(luminance(radiosity_of(*solution, lit.place))) / kPoints;
        }
        EXPECT_NEAR(here / elements, 1, 0.01) << wall;
    }
}

// What a point has of the sky: settled cells, and leaves that it sees.
float sky_light(const RayTracer& tracer, const Receiver& at, const std::vector<SkyLeaf>& leaves,
                const DirectionTable& table) {
    float light = light_of(table, TableCosines(at.normal)).x;
    for (const SkyLeaf& leaf : leaves) {
        const float cosine = dot(leaf.direction, at.normal);
        if (cosine > 0 && !tracer.occluded({at.position, leaf.direction, 0, kInfinity}, RayMask::kLight)) {
            light += cosine * leaf.solid_angle;
        }
    }
    return light;
}

// A scene below an even sky of radiance 1.
struct UnderSky {
    Prepared prepared;
    std::shared_ptr<const Solution> solution = prepared.solve();
    NodeOrder order{hierarchy_of(*solution)};
    Surroundings around{*solution, order, *prepared.tracer};
    SkyLeaves sky{*prepared.tracer, Rgb(1)};

    explicit UnderSky(const SceneDescription& description) : prepared(description) {}

    void find(std::span<const Receiver> receivers, float size, std::vector<SkyLeaf>& leaves, DirectionTable& table) {
        around.look_from(receivers);
        sky.find(receivers, around, size, leaves, table);
    }
};

TEST(SkyLeaves, an_open_sky_is_settled) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({-50, -50, 0}, {50, -50, 0}, {50, 50, 0}, {-50, 50, 0}, grey);
    builder.description.world = Rgb(1);
    UnderSky scene(builder.description);
    const Receiver at{{1, 1, 0.001F}, {0, 0, 1}, {0, 0, 1}, kNone, 0.5F, kPi};
    std::vector<SkyLeaf> leaves;
    DirectionTable table;
    scene.find(std::span(&at, 1), 0.01F, leaves, table);
    EXPECT_TRUE(leaves.empty());
    EXPECT_NEAR(light_of(table, TableCosines(at.normal)).x, kPi, 0.01F * kPi);
}

// Through a window 1 x 0.8 m from 2 m away, for points on either side of the place that the leaves were found for.
TEST(SkyLeaves, light_through_a_window_agrees_with_random_rays) {
    SceneBuilder builder;
    const std::uint32_t grey = builder.material(Rgb(0.5F));
    builder.quad({-9, 2, -9}, {-0.5F, 2, -9}, {-0.5F, 2, 9}, {-9, 2, 9}, grey);
    builder.quad({0.5F, 2, -9}, {9, 2, -9}, {9, 2, 9}, {0.5F, 2, 9}, grey);
    builder.quad({-0.5F, 2, -9}, {0.5F, 2, -9}, {0.5F, 2, 0.6F}, {-0.5F, 2, 0.6F}, grey);
    builder.quad({-0.5F, 2, 1.4F}, {0.5F, 2, 1.4F}, {0.5F, 2, 9}, {-0.5F, 2, 9}, grey);
    builder.box({-9, -9, -9}, {9, 2, 9}, {grey, grey, grey, grey, grey, grey}, true);
    builder.description.instances.erase(builder.description.instances.begin() + 4 + 3);  // the side of the window
    builder.description.world = Rgb(1);
    UnderSky scene(builder.description);
    std::vector<Receiver> receivers;
    for (int k = 0; k < 25; ++k) {
        const Vec3 place(0.06F * static_cast<float>(k % 5 - 2), 0.06F * static_cast<float>(k / 5 - 2), 0);
        receivers.push_back({place, {0, 0, 1}, {0, 0, 1}, kNone, 0.5F, 0.1F});
    }
    std::vector<SkyLeaf> leaves;
    DirectionTable table;
    scene.find(receivers, 0.001F, leaves, table);
    EXPECT_GT(leaves.size(), 20U);
    float previous = 0;
    for (const std::size_t k : {0U, 12U, 24U}) {
        double exact = 0;
        constexpr std::uint32_t kRays = 400000;
        const Sequence4 sequence(7);
        for (std::uint32_t i = 0; i < kRays; ++i) {
            const Vec3 d = square_to_cosine_hemisphere(sequence(i, 0), sequence(i, 1));
            const bool seen =
                !scene.prepared.tracer->occluded({receivers[k].position, d, 0, kInfinity}, RayMask::kLight);
            exact += seen ? static_cast<double>(kPi) / kRays : 0;
        }
        const float found = sky_light(*scene.prepared.tracer, receivers[k], leaves, table);
        EXPECT_NEAR(found / exact, 1, k == 12 ? 0.03 : 0.09) << k;  // few receivers look from the corners
        EXPECT_GT(found, previous);
        previous = found;
    }
}

}  // namespace
}  // namespace gg::test
