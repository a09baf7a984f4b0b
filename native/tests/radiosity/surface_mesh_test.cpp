// Triangles that are divided to a size that is wanted: weights without cracks, and where they do not count.
#include "radiosity/surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "core/random.h"
#include "radiosity/quarter.h"
#include "support/surface_meshes.h"

namespace gg::test {
namespace {

constexpr int kRaster = 64;  // cells along each side of a triangle that are seen

// Coarse on the left, fine on the right of a floor from -2 to 2.
float graded_length(Vec3 a, Vec3 b) {
    return length(b - a) / (0.12F * std::exp(0.6F * (2 - 0.5F * (a.x + b.x))));
}

std::map<std::uint32_t, float> weights_at(const SurfaceMesh& mesh, const SurfaceSpot& spot) {
    const SurfacePlace place = mesh.place(spot);
    std::map<std::uint32_t, float> weights;
    for (int k = 0; k < 3; ++k) {
        if (place.weights[k] > 0) {
            weights[place.vertices[k]] += place.weights[k];
        }
    }
    return weights;
}

float largest_difference(const SurfaceMesh& mesh, const SurfaceSpot& a, const SurfaceSpot& b) {
    auto difference = weights_at(mesh, a);
    for (const auto& [vertex, weight] : weights_at(mesh, b)) {
        difference[vertex] -= weight;
    }
    float largest = 0;
    for (const auto& entry : difference) {
        largest = std::max(largest, std::abs(entry.second));
    }
    return largest;
}

// The corners of a part in its triangle.
std::array<Vec2, 3> places_of(const SurfacePart& part) {
    std::array<Vec2, 3> places{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)};
    for (int level = 0; level < part.depth; ++level) {
        places = quarter_of(places, static_cast<int>(part.quarters >> (2 * level) & 3U));
    }
    return places;
}

class DividedFloor : public testing::Test {
  protected:
    Prepared prepared_{lit_floor()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve();
    std::vector<SurfaceSpot> spots_ = raster(prepared_.scene, 0, kRaster);
};

TEST_F(DividedFloor, parts_are_about_as_long_as_wanted) {
    for (const auto& length_of : {even(0.3F), SurfaceMesh::LengthOf(graded_length)}) {
        const SurfaceMesh mesh(*solution_, {length_of});
        for (const SurfaceSpot& spot : spots_) {
            const SurfacePart part = mesh.part_at(spot);
            const auto c = world_triangle(prepared_.scene, 0, spot.triangle);
            std::array<Vec3, 3> corners;
            for (int k = 0; k < 3; ++k) {
                const Vec2 place = places_of(part)[k];
                corners[k] = c[0] + place.x * (c[1] - c[0]) + place.y * (c[2] - c[0]);
            }
            const float longest = std::max({length_of(corners[0], corners[1]), length_of(corners[1], corners[2]),
                                            length_of(corners[2], corners[0])});
            ASSERT_LE(longest, 1);
            ASSERT_GT(longest, 0.2F);  // half of more than 1, and less where the next ones are coarser
        }
    }
}

// Where a vertex lies is told by the spot at which it has all the weight.
TEST_F(DividedFloor, weights_interpolate_positions_exactly) {
    for (const auto& length_of : {even(0.3F), SurfaceMesh::LengthOf(graded_length)}) {
        const SurfaceMesh mesh = divided(*solution_, {length_of}, spots_);
        std::map<std::uint32_t, Vec3> positions;
        constexpr int kFinest = 128;
        for (std::uint32_t triangle = 0; triangle < 2; ++triangle) {
            for (int i = 0; i <= kFinest; ++i) {
                for (int j = 0; i + j <= kFinest; ++j) {
                    const SurfaceSpot spot{0, triangle, false, Vec2(i, j) / static_cast<float>(kFinest)};
                    for (const auto& [vertex, weight] : weights_at(mesh, spot)) {
                        if (weight > 0.99999F) {
                            const Vec3 position = position_of(prepared_.scene, spot);
                            const auto [known, is_new] = positions.insert({vertex, position});
                            ASSERT_TRUE(is_new || length(known->second - position) < 1e-5F);
                        }
                    }
                }
            }
        }
        EXPECT_EQ(positions.size(), mesh.vertex_count());
        EXPECT_GT(mesh.vertex_count(), 100U);
        const Sequence4 sequence(1);
        for (std::uint32_t i = 0; i < 20000; ++i) {
            const Vec3 w = square_to_triangle(sequence(i, 0), sequence(i, 1));
            const SurfaceSpot spot{0, i % 2, false, {w.y, w.z}};
            Vec3 position(0.0F);
            float sum = 0;
            for (const auto& [vertex, weight] : weights_at(mesh, spot)) {
                position += weight * positions.at(vertex);
                sum += weight;
            }
            ASSERT_NEAR(sum, 1, 1e-5F);
            ASSERT_LT(length(position - position_of(prepared_.scene, spot)), 2e-5F);
        }
    }
}

TEST_F(DividedFloor, two_triangles_agree_along_their_edge) {
    const SurfaceMesh mesh = divided(*solution_, {graded_length}, spots_);
    for (int i = 0; i <= 5000; ++i) {
        const float share = static_cast<float>(i) / 5000;  // from a to c of the quad
        ASSERT_LT(largest_difference(mesh, {0, 0, false, {0, share}}, {0, 1, false, {share, 0}}), 1e-4F) << share;
    }
}

// Both sides of every edge of every part, most of which have more parts beside them than they are long.
TEST_F(DividedFloor, parts_of_any_size_agree_along_their_edges) {
    const SurfaceMesh mesh = divided(*solution_, {graded_length}, spots_);
    std::size_t compared = 0, of_other_size = 0;
    const Sequence4 sequence(2);
    for (std::uint32_t i = 0; i < spots_.size(); ++i) {
        const SurfacePart part = mesh.part_at(spots_[i]);
        const auto places = places_of(part);
        const Vec2 middle = (places[0] + places[1] + places[2]) / 3.0F;
        for (int k = 0; k < 3; ++k) {
            const Vec2 on = glm::mix(places[k], places[(k + 1) % 3], sequence(i, k));
            const Vec2 inward = 3e-7F * (middle - on) / length(middle - on);
            const SurfaceSpot inside{0, part.triangle, false, on + inward},
                outside{0, part.triangle, false, on - inward};
            const Vec2 out = outside.barycentric;
            if (std::min({out.x, out.y, 1 - out.x - out.y}) < 0) {
                continue;  // another triangle
            }
            ASSERT_LT(largest_difference(mesh, inside, outside), 1e-4F) << on.x << " " << on.y;
            ++compared;
            of_other_size += mesh.part_at(outside).depth != part.depth ? 1 : 0;
        }
    }
    EXPECT_GT(compared, 10000U);
    EXPECT_GT(of_other_size, 500U);
}

TEST_F(DividedFloor, ids_do_not_depend_on_the_order_of_spots) {
    const SurfaceMesh mesh = divided(*solution_, {graded_length}, spots_);
    std::vector<SurfaceSpot> shuffled = spots_;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
    shuffled.insert(shuffled.end(), spots_.begin(), spots_.begin() + 1000);
    const SurfaceMesh other = divided(*solution_, {graded_length}, shuffled);
    EXPECT_EQ(mesh.vertex_count(), other.vertex_count());
    for (const SurfaceSpot& spot : spots_) {
        const SurfacePlace a = mesh.place(spot), b = other.place(spot);
        ASSERT_EQ(a.vertices, b.vertices);
        ASSERT_EQ(a.weights, b.weights);
    }
}

}  // namespace
}  // namespace gg::test
