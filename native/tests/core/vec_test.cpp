#include "core/vec.h"

#include <gtest/gtest.h>

namespace gg {
namespace {

void expect_near(Vec3 a, Vec3 b, float tolerance) {
    EXPECT_LE(length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Vec, normal_matrix_keeps_normals_across_and_outside_under_shear_and_mirroring) {
    const Vec3 e1(1, 0.2F, 0), e2(0.1F, 1, 0.3F);
    const Vec3 outward(0.3F, -0.2F, 1);  // on the side of e1 x e2
    for (const float mirror : {1.0F, -1.0F}) {
        const Mat3 map({2 * mirror, 0, 0}, {0.7F, 1, 0}, {0.2F, 0, 0.5F});
        const Vec3 normal = normal_matrix(map) * cross(e1, e2);
        EXPECT_NEAR(dot(normal, map * e1), 0, 1e-6);
        EXPECT_NEAR(dot(normal, map * e2), 0, 1e-6);
        EXPECT_GT(dot(normal, map * outward), 0);
        EXPECT_NEAR(length(normal), length(cross(map * e1, map * e2)), 1e-6);
    }
}

TEST(Vec, frame_is_orthonormal_and_right_handed_for_every_normal) {
    for (const Vec3 direction : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 2, 3), Vec3(-1, 0.1F, -1e-4F), Vec3(0, 1, 0)}) {
        const Vec3 n = glm::normalize(direction);
        const Frame frame(n);
        EXPECT_NEAR(length(frame.tangent), 1, 1e-5);
        EXPECT_NEAR(dot(frame.tangent, n), 0, 1e-6);
        expect_near(cross(frame.tangent, frame.bitangent), n, 1e-5F);
        expect_near(frame.to_world({0, 0, 2}), 2.0F * n, 1e-6F);
    }
}

TEST(Vec, box_holds_what_it_was_extended_by) {
    Box box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(box.diameter(), 0);
    box.extend(Vec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    box.extend(Vec3(-1, 5, 3));
    EXPECT_TRUE(box.contains(Vec3(0, 3, 3)));
    EXPECT_FALSE(box.contains(Vec3(0, 3, 3.1F)));
    EXPECT_TRUE(box.contains(box));
    EXPECT_FALSE(box.overlaps(Box{Vec3(2, 2, 2), Vec3(3, 3, 3)}));
}

TEST(Vec, transformed_box_holds_the_transformed_points) {
    const Box box{Vec3(-1, 0, 2), Vec3(1, 3, 4)};
    const Affine map{Mat3({0, 2, 0}, {-1, 0, 0.5F}, {0, 0, -3}), Vec3(7, 8, 9)};
    const Box result = transformed(box, map);
    for (const Vec3 p : {Vec3(-1, 0, 2), Vec3(1, 3, 4), Vec3(0.5F, 1, 3)}) {
        EXPECT_TRUE(result.contains(map.point(p)));
    }
}

TEST(Vec, normalising_zero_stays_zero_and_luminance_of_white_is_one) {
    EXPECT_EQ(normalize_or_zero(Vec3(0)), Vec3(0));
    expect_near(normalize_or_zero(Vec3(0, 3, 4)), Vec3(0, 0.6F, 0.8F), 1e-6F);
    EXPECT_NEAR(luminance(Rgb(1)), 1, 1e-6);
}

}  // namespace
}  // namespace gg
