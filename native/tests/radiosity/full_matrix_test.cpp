// The full matrix against known values of constant elements, then the solver against the full matrix.
#include <gtest/gtest.h>

#include "oracles/full_matrix_radiosity.h"
#include "support/solution_measures.h"
#include "support/test_scenes.h"

namespace gg::test {
namespace {

using oracle::form_factor_matrix;
using oracle::Patch;
using oracle::solve_radiosity;

// Faces -x, +x, -y, +y, -z, +z of a box as SceneBuilder::box makes them.
std::vector<Patch> box_patches(Vec3d lower, Vec3d upper, bool inward, double reflectance) {
    std::vector<Patch> faces;
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool at_upper : {false, true}) {
            Patch face;
            face.reflectance = reflectance;
            face.corner = lower;
            face.corner[axis] = at_upper ? upper[axis] : lower[axis];
            const int first = (axis + (at_upper != inward ? 1 : 2)) % 3;
            const int second = (axis + (at_upper != inward ? 2 : 1)) % 3;
            face.u[first] = upper[first] - lower[first];
            face.v[second] = upper[second] - lower[second];
            faces.push_back(face);
        }
    }
    return faces;
}

double mean(std::span<const double> values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

struct CubeValues {
    double reflectance, emitter, opposite, side;
};

class UnitCube : public testing::TestWithParam<CubeValues> {};

TEST_P(UnitCube, one_element_per_face) {
    auto faces = box_patches(Vec3d(0.0), Vec3d(1.0), true, GetParam().reflectance);
    faces[0].emission = 1;
    const auto radiosity = solve_radiosity(faces, form_factor_matrix(faces, {}, {0, 1}));
    EXPECT_NEAR(radiosity[0], GetParam().emitter, 1e-8);
    EXPECT_NEAR(radiosity[1], GetParam().opposite, 1e-8);
    for (int side = 2; side < 6; ++side) {
        EXPECT_NEAR(radiosity[side], GetParam().side, 1e-8);
    }
}

INSTANTIATE_TEST_SUITE_P(FullMatrix, UnitCube,
                         testing::Values(CubeValues{0.5, 1.090909098, 0.181745826, 0.181836269},
                                         CubeValues{0.8, 1.551724154, 0.689551071, 0.689681194},
                                         CubeValues{0.78, 1.478452359, 0.613298238, 0.613425987}));

struct PlateValues {
    double reflectance, emitter, other;
};

class FacingPlates : public testing::TestWithParam<PlateValues> {};

TEST_P(FacingPlates, one_element_each) {
    auto faces = box_patches(Vec3d(0.0), Vec3d(1.0), true, GetParam().reflectance);
    faces.resize(2);
    faces[0].emission = 1;
    const auto radiosity = solve_radiosity(faces, form_factor_matrix(faces, {}, {0, 1}));
    EXPECT_NEAR(radiosity[0], GetParam().emitter, 1e-8);
    EXPECT_NEAR(radiosity[1], GetParam().other, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(FullMatrix, FacingPlates,
                         testing::Values(PlateValues{0.5, 1.010083152, 0.100919880},
                                         PlateValues{0.8, 1.026225388, 0.164052305}));

TEST(FullMatrix, blocked_by_what_lies_between) {
    const Patch plate{{-1, -1, 1}, {2, 0, 0}, {0, 2, 0}};
    const auto occluders = oracle::triangles_of({&plate, 1});
    EXPECT_TRUE(oracle::is_blocked({0, 0, 0}, {0.3, 0.1, 2}, occluders));
    EXPECT_TRUE(oracle::is_blocked({0.3, 0.1, 2}, {0, 0, 0}, occluders));
    EXPECT_FALSE(oracle::is_blocked({0, 0, 0}, {0.3, 0.1, 0.9}, occluders));
    EXPECT_FALSE(oracle::is_blocked({0, 0, 0}, {4, 0.1, 2}, occluders));
    EXPECT_FALSE(oracle::is_blocked({0, 0, 1}, {0, 0, 2}, occluders));
}

std::uint32_t material_of(SceneBuilder& builder, const Patch& patch) {
    return builder.material(Rgb(static_cast<float>(patch.reflectance)), Rgb(static_cast<float>(patch.emission) / kPi));
}

void add_faces(SceneBuilder& builder, std::span<const Patch> faces) {
    for (const Patch& face : faces) {
        const Vec3 a(face.corner), u(face.u), v(face.v);
        builder.quad(a, a + u, a + u + v, a + v, material_of(builder, face));
    }
}

// Mean radiosity per face by the full matrix of a subdivided version.
std::vector<double> true_means(std::span<const Patch> faces, std::span<const oracle::OracleTriangle> occluders,
                               std::span<const int> counts, const oracle::FormFactorSettings& settings) {
    std::vector<Patch> patches;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const auto parts = subdivide(faces[face], counts[face]);
        patches.insert(patches.end(), parts.begin(), parts.end());
    }
    const auto radiosity = solve_radiosity(patches, form_factor_matrix(patches, occluders, settings));
    std::vector<double> means;
    std::size_t first = 0;
    for (const int count : counts) {
        means.push_back(mean(std::span(radiosity).subspan(first, static_cast<std::size_t>(count * count))));
        first += static_cast<std::size_t>(count * count);
    }
    return means;
}

TEST(FullMatrix, solver_agrees_in_a_cube_with_one_emitting_face) {
    auto faces = box_patches(Vec3d(0.0), Vec3d(1.0), true, 0.8);
    faces[0].emission = 1;
    const auto expected = true_means(faces, {}, std::vector<int>(6, 8), {3, 1});
    SceneBuilder builder;
    add_faces(builder, faces);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.005F);
    for (std::uint32_t face = 0; face < 6; ++face) {
        EXPECT_NEAR(luminance_of(means_of_instance(*solution, face).radiosity) / expected[face], 1, 0.06) << face;
    }
}

// A glowing ceiling above a box that keeps its light from parts of the floor.
TEST(FullMatrix, solver_agrees_around_an_occluder) {
    auto faces = box_patches(Vec3d(0.0), Vec3d(2, 2, 1.5), true, 0.5);
    faces[5].emission = 1;
    faces[0].reflectance = 0.8;
    faces[1].reflectance = 0.2;
    const auto box = box_patches(Vec3d(0.4, 0.5, 0.4), Vec3d(1.2, 1.3, 0.9), false, 0.6);
    faces.insert(faces.end(), box.begin(), box.end());
    std::vector<int> counts(6, 6);
    counts.resize(12, 3);
    const auto expected = true_means(faces, oracle::triangles_of(box), counts, {2, 2});
    SceneBuilder builder;
    add_faces(builder, std::span(faces).first(6));
    builder.solid({0.4F, 0.5F, 0.4F}, {1.2F, 1.3F, 0.9F}, material_of(builder, box[0]));
    Prepared prepared(builder.description);
    const auto solution = prepared.solve(0.005F);
    for (std::uint32_t face = 0; face < 6; ++face) {
        EXPECT_NEAR(luminance_of(means_of_instance(*solution, face).radiosity) / expected[face], 1, 0.035) << face;
    }
    for (int face = 0; face < 6; ++face) {
        const FaceMeans means = means_of(*solution, [&](const Node& node) {
            return node.instance == 6 && node.normal[face / 2] * (face % 2 == 1 ? 1.0F : -1.0F) > 0.9F;
        });
        // Errors are weighed by what they change in the room: the shadow below the box may be off by more.
        const double tolerance = face == 4 ? 0.25 : 0.13;
        EXPECT_NEAR(luminance_of(means.radiosity) / expected[6 + face], 1, tolerance) << "box " << face;
    }
}

}  // namespace
}  // namespace gg::test
