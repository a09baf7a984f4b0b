// From sites on surfaces to those of the grid: a floor whose triangles become too small for sites of their own.
#include "gather/site_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/gather_scenes.h"
#include "support/meshes.h"
#include "support/walks.h"

namespace gg::test {
namespace {

constexpr int kWalks = 20, kPoints = 500;
constexpr float kShortest = 5e-7F;  // m: about what floats can tell apart
constexpr float kRow = 1, kWidest = 1, kShrinks = 0.65F;

// 4 x 4 m in rows of triangles, each of which is narrower than the one to its left.
MeshDescription graded_floor() {
    std::vector<Vec3> positions;
    std::uint32_t columns = 0;
    for (float x = -2, width = kWidest; x < 2; x += width, width = std::max(kShrinks * width, 0.06F), ++columns) {
        for (int row = 0; row <= 4; ++row) {
            positions.emplace_back(x, -2 + kRow * static_cast<float>(row), 0);
        }
    }
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        for (std::uint32_t row = 0; row < 4; ++row) {
            const std::uint32_t a = 5 * column + row, b = a + 5;
            vertices.insert(vertices.end(), {a, b, b + 1, a, b + 1, a + 1});
        }
    }
    return make_mesh(positions, vertices);
}

// Nothing is in the way of any light there.
class SurfaceToGrid : public testing::Test {
  protected:
    static GridPicture make_picture() {
        ViewedScene scene = viewed_stage();
        scene.description.meshes[0] = graded_floor();
        PictureSettings settings;
        settings.cell = 6;
        return {scene.description, scene.camera, settings};
    }
    // The floor at x, y, as the camera sees it.
    [[nodiscard]] PlacedFragment at(Vec2 place) const {
        const Hit hit = picture_.prepared.tracer->closest_hit({{place, 0.5F}, {0, 0, -1}}, RayMask::kCamera);
        return picture_.place(fragment_at(picture_.prepared.scene, hit.instance, hit.triangle, {hit.u, hit.v}));
    }
    // Where a step crosses an edge of a triangle, or goes from some sites to others.
    [[nodiscard]] static bool crosses(const Step& step) {
        return step.from.at.hit.triangle != step.to.at.hit.triangle || !has_same_sites(step);
    }
    [[nodiscard]] Step narrow_to_edge(Vec2 from, Vec2 to) const {
        Step step{at(from), at(to)};
        while (length(to - from) > kShortest) {
            const Vec2 middle = 0.5F * (from + to);
            if (middle == from || middle == to) {
                break;
            }
            const PlacedFragment placed = at(middle);
            const bool first = crosses({step.from, placed});
            (first ? to : from) = middle;
            (first ? step.to : step.from) = placed;
        }
        return step;
    }
    // Of a walk; within the picture.
    static Vec2 point_of(int walk, int i) {
        const float along = static_cast<float>(i) / (kPoints - 1), across = (static_cast<float>(walk) + 0.37F) / kWalks;
        return {-1.2F + 2.6F * along, -0.9F + 2.1F * across + 0.3F * along};
    }

    GridPicture picture_ = make_picture();
};

TEST_F(SurfaceToGrid, has_places_of_either_kind_and_between) {
    int surface = 0, between = 0, grid = 0;
    for (int walk = 0; walk < kWalks; ++walk) {
        for (int i = 0; i < kPoints; ++i) {
            const float share = at(point_of(walk, i)).on_surface;
            surface += share > 0.999F ? 1 : 0;
            grid += share == 0 ? 1 : 0;
            between += share > 0.01F && share < 0.99F ? 1 : 0;
        }
    }
    EXPECT_GT(surface, 1000);
    EXPECT_GT(between, 1000);
    EXPECT_GT(grid, 1000);
}

TEST_F(SurfaceToGrid, weights_sum_to_one) {
    for (int walk = 0; walk < kWalks; ++walk) {
        for (int i = 0; i < kPoints; ++i) {
            const SitePlace place = picture_.places.of(at(point_of(walk, i)).at);
            float sum = 0;
            for (std::uint32_t k = 0; k < place.count; ++k) {
                ASSERT_GT(place.weights[k], 0);
                ASSERT_LT(place.vertices[k], picture_.places.vertex_count());
                sum += place.weights[k];
            }
            ASSERT_NEAR(sum, 1, 2e-4F);
            ASSERT_LE(place.count, SitePlace::kMost);
        }
    }
}

TEST_F(SurfaceToGrid, light_is_the_same_on_both_sides_of_every_edge) {
    Shader shader = picture_.shader();
    int edges = 0, fading = 0;
    for (int walk = 0; walk < kWalks; ++walk) {
        PlacedFragment before = at(point_of(walk, 0));
        for (int i = 1; i < kPoints; ++i) {
            const PlacedFragment now = at(point_of(walk, i));
            if (crosses({before, now})) {
                const Step edge = narrow_to_edge(point_of(walk, i - 1), point_of(walk, i));
                const auto light = light_at(shader, {edge.from, edge.to});
                ASSERT_NEAR(luminance(light[0]) / luminance(light[1]), 1, 1e-5F)
                    << edge.from.at.position.x << " " << edge.from.at.position.y << " " << edge.from.on_surface << " "
                    << edge.to.on_surface;
                ++edges;
                fading += edge.from.on_surface > 0.01F && edge.from.on_surface < 0.99F ? 1 : 0;
            }
            before = now;
        }
    }
    EXPECT_GT(edges, 1000);
    EXPECT_GT(fading, 200);
}

}  // namespace
}  // namespace gg::test
