// More rays around a site where bright things are met too seldom.
#include "gather/closer_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "gather/classify.h"
#include "gather/surroundings.h"
#include "support/test_scenes.h"
#include "transport/sky_cell.h"

namespace gg::test {
namespace {

// A dark room, and around its middle 40 bright panels of 0.1 m, 2 m away, each of which is met by no ray or by one; or
// larger ones.
struct Panels {
    explicit Panels(float size = 0.1F) : prepared(describe(size)) {}

    static SceneDescription describe(float size) {
        SceneBuilder builder;
        const std::uint32_t dark = builder.material(Rgb(0), Rgb(0.01F)), bright = builder.material(Rgb(0), Rgb(100));
        builder.box({-3, -3, -3}, {3, 3, 3}, {dark, dark, dark, dark, dark, dark}, true);
        const Sequence4 sequence(3);
        for (std::uint32_t k = 0; k < 40; ++k) {
            const Vec3 to = cell_direction(sky_roots()[k % 2], sequence(k, 0), sequence(k, 1));
            const Vec3 side = size / 2 * normalize_or_zero(cross(to, Vec3(0.6F, 0, 0.8F))), up = cross(to, side);
            builder.quad(2.0F * to - side - up, 2.0F * to - side + up, 2.0F * to + side + up, 2.0F * to + side - up,
                         bright);
        }
        return builder.description;
    }
    Prepared prepared;
    std::shared_ptr<const Solution> solution = prepared.solve();
    NodeOrder order{hierarchy_of(*solution)};
    Surroundings surroundings{*solution, order, *prepared.tracer};

    // Undivided elements, and what they bring to the origin if they face it, W/m2.
    [[nodiscard]] std::vector<LeftSender> senders() const {
        const Hierarchy& hierarchy = hierarchy_of(*solution);
        std::vector<LeftSender> left;
        for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
            const Node& node = hierarchy[id];
            if (node.kind == NodeKind::kElement && node.depth == 0) {
                const float b = luminance(radiosity_of(*solution, id)), distance = length(node.center);
                left.push_back({id, b * node.area / (kPi * distance * distance)});
            }
        }
        return left;
    }
};

std::uint32_t cell_of(const Panels& scene, NodeId sender) {
    return table_index(finest_cell_at(normalize_or_zero(hierarchy_of(*scene.solution)[sender].center)));
}

// A sender that fills a tenth of one part of all directions: it is met by a tenth of the rays, each of which says that
// the whole part is as bright.
TEST(CloserLook, ray_variance_is_that_of_random_rays) {
    constexpr std::uint32_t kCells = 2048, kTrials = 200000;
    constexpr double kRadiosity = 3, kShare = 0.1, kPart = 4 * static_cast<double>(kPi) / kCells;
    constexpr double kFound = kPart * kRadiosity / static_cast<double>(kPi), kExact = kShare * kFound;
    double squares = 0;
    const Sequence4 sequence(5);
    for (std::uint32_t k = 0; k < kTrials; ++k) {
        const double off = (sequence(k, 0) < kShare ? kFound : 0) - kExact;
        squares += off * off / kTrials;
    }
    const double bound = ray_variance(static_cast<float>(kExact), static_cast<float>(kRadiosity), kCells);
    EXPECT_NEAR(squares / bound, 1 - kShare, 0.01);
}

TEST(CloserLook, cells_are_those_that_hold_most_and_no_more) {
    const Panels scene;
    const std::vector<LeftSender> left = scene.senders();
    std::array<double, kTableCells> variances{};
    double all = 0;
    for (const LeftSender& sender : left) {
        const double variance =
            ray_variance(sender.irradiance, luminance(radiosity_of(*scene.solution, sender.sender)), kSiteCells);
        variances[cell_of(scene, sender.sender)] += variance;
        all += variance;
    }
    std::size_t previous = 0;
    for (const double share : {1.1, 0.5, 0.1, 1e-3}) {
        const TableCellSet cells =
            worth_closer_look(*scene.solution, Vec3(0), left, static_cast<float>(std::sqrt(share * all)));
        double rest = 0, least = all;
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            rest += cells[c] ? 0 : variances[c];
            least = cells[c] ? std::min(least, variances[c]) : least;
        }
        EXPECT_LE(rest, (share + 1e-7) * all) << share;
        EXPECT_TRUE(cells.none() || rest + least > share * all) << share;
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            EXPECT_TRUE(cells[c] || variances[c] <= (1 + 1e-5) * least) << c;
            EXPECT_FALSE(cells[c] && variances[c] <= 0) << c;
        }
        EXPECT_GE(cells.count(), previous);
        previous = cells.count();
    }
    EXPECT_TRUE(worth_closer_look(*scene.solution, Vec3(0), left, 1e9F).none());
    EXPECT_GT(previous, 20U);
    EXPECT_TRUE(worth_closer_look(*scene.solution, Vec3(0), {}, 0).none());
}

// Where the panels are, and only there: five times the rays, and light that is less off.
TEST(CloserLook, finds_what_few_rays_miss) {
    Panels scene;
    const TableCellSet closer = worth_closer_look(*scene.solution, Vec3(0), scene.senders(), 0.01F);
    EXPECT_GT(closer.count(), 20U);
    EXPECT_LE(closer.count(), 60U);
    double before = 0, after = 0;
    constexpr std::uint32_t kPlaces = 1000;
    const Sequence4 sequence(11);
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
        const Vec3 at = 0.02F * (Vec3(sequence(k, 0), sequence(k, 1), sequence(k, 2)) - 0.5F);
        const Receiver receiver{at, {1, 0, 0}, {1, 0, 0}, kNone, 0.5F, 1};
        double exact = 0.01 * static_cast<double>(kPi);
        for (const LeftSender& sender : scene.senders()) {
            const Node& node = hierarchy_of(*scene.solution)[sender.sender];
            const Vec3 to = node.center - at;
            if (node.area < 0.1F && to.x > 0 && dot(to, node.normal) < 0) {
                const auto squared = static_cast<double>(dot(to, to));
                exact -= static_cast<double>(100 * node.area * to.x * dot(to, node.normal)) / (squared * squared);
            }
        }
        const auto square = [&](const DirectionTable& table) {
            const double off = luminance(light_of(table, TableCosines(receiver.normal))) / exact - 1;
            return off * off / kPlaces;
        };
        scene.surroundings.look_from(std::span(&receiver, 1));
        const std::size_t rays = scene.surroundings.ray_count();
        DirectionTable few, many;
        scene.surroundings.add_to(few, {}, {});
        scene.surroundings.look_closer(std::span(&receiver, 1), closer);
        EXPECT_GT(scene.surroundings.ray_count(), rays);
        EXPECT_LE(scene.surroundings.ray_count(), rays + closer.count() * 4 * kSiteCells / kTableCells);
        scene.surroundings.add_to(many, {}, {});
        before += square(few);
        after += square(many);
    }
    EXPECT_GT(std::sqrt(before), 0.2);
    EXPECT_LT(std::sqrt(after), 0.5 * std::sqrt(before));
}

// Panels that are each less than the tolerance, but all together more than rays should be off.
TEST(CloserLook, sites_look_closer) {
    Panels scene;
    const ClusterPoints points(*scene.solution, scene.prepared.control);
    const Vec3 at(-2.999F, 0.1F, 0.2F);  // on a wall
    const Receiver receiver{at, {1, 0, 0}, {1, 0, 0}, place_at(*scene.solution, 0, 0, false, at), 0.5F, 1};
    scene.surroundings.look_from(std::span(&receiver, 1));
    const auto closer = [&](float threshold) {
        Classifier classifier(*scene.solution, scene.order, points, *scene.prepared.tracer, {256, threshold, 0});
        static_cast<void>(classifier.classify(std::span(&receiver, 1)));
        return classifier.counts().near_rays - scene.surroundings.ray_count();
    };
    EXPECT_GT(closer(0.2F), 8 * 4 * kSiteCells / kTableCells);
    EXPECT_EQ(closer(100), 0U);
}

// Outside of close cells, one ray into every cell leaves no larger error than was allowed; that is so with few cells.
TEST(CloseCells, are_where_what_is_near_differs) {
    Panels scene(0.6F);
    const Receiver receiver{Vec3(0), {0, 0, 1}, {0, 0, 1}, kNone, 0.5F, 1};
    const Receiver turned{Vec3(0), {0, 0, -1}, {0, 0, -1}, kNone, 0.5F, 1};
    const std::array<Receiver, 2> both{receiver, turned};
    const Reach reach{7, 8};
    Surroundings& around = scene.surroundings;
    around.look_from(both);
    DirectionTable table;
    around.add_to(table, {}, reach);
    std::array<double, kTableCells> variances{};
    double all = 0;
    for (std::uint32_t c = 0; c < kTableCells; ++c) {
        constexpr std::uint32_t kRays = 400;
        const Sequence4 sequence(7);
        double sum = 0, squared = 0;
        for (std::uint32_t k = 0; k < kRays; ++k) {
            const Vec3 direction = cell_direction(table_cell(c), sequence(k, 0), sequence(k, 1));
            const Hit hit = scene.prepared.tracer->closest_hit({Vec3(0), direction, 0, kInfinity}, RayMask::kLight);
            const bool back = dot(world_area_vector(hierarchy_of(*scene.solution).scene(), hit.instance, hit.triangle),
                                  direction) > 0;
            const auto light = static_cast<double>(kTableSolidAngle / kPi *
                                                   luminance(lit_place(*scene.solution, hit, back).radiosity));
            sum += light / kRays;
            squared += light * light / kRays;
        }
        variances[c] = squared - sum * sum;
        all += variances[c];
    }
    std::size_t previous = 0;
    for (const double share : {0.5, 0.2, 0.05}) {
        const auto error = static_cast<float>(std::sqrt(share * all));
        const TableCellSet cells = worth_close_cells(around, {}, table, reach, error);
        double rest = 0;
        for (std::uint32_t c = 0; c < kTableCells; ++c) {
            rest += cells[c] ? 0 : variances[c];
        }
        EXPECT_LT(rest, 1.4 * share * all) << share;
        EXPECT_GT(rest, 0.5 * share * all) << share;
        EXPECT_GT(cells.count(), previous);
        EXPECT_EQ((cells & around.near_cells(reach.none)), cells);
        previous = cells.count();
    }
    EXPECT_TRUE(worth_close_cells(around, {}, table, reach, 1e9F).none());
    EXPECT_TRUE(worth_close_cells(around, {}, table, {1, 1.5F}, 1e-6F).none());  // nothing is that near
    // Senders by themselves: all rays say the same, that what the table has is too much.
    const std::array<RankRange, 1> everything{RankRange{0, kNone}};
    DirectionTable even;
    even.red.fill(1);
    EXPECT_TRUE(worth_close_cells(around, everything, even, reach, 1e-3F).none());
}

}  // namespace
}  // namespace gg::test
