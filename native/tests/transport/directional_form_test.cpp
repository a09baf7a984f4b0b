#include "transport/directional_form.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "random_scenes.h"

namespace gg {
namespace {

struct Face {
    Vec3 n;
    float area;
    Rgb reflectance;
};

std::vector<Face> random_faces(test::Random& random, int count) {
    std::vector<Face> faces;
    for (int i = 0; i < count; ++i) {
        faces.push_back({Vec3(random.direction()), static_cast<float>(random.uniform(0.01, 2)),
                         Rgb(random.uniform(), random.uniform(), random.uniform())});
    }
    return faces;
}

DirectionalForm random_form(test::Random& random) {
    DirectionalForm form;
    for (int i = 0; i < 5; ++i) {
        add_beam(form, Rgb(random.uniform(), random.uniform(), random.uniform()), Vec3(random.direction()));
    }
    return form;
}

ReflectionOperator operator_of(const std::vector<Face>& faces) {
    ReflectionOperator result;
    for (const Face& face : faces) {
        result.add_face(face.n, face.area, face.reflectance);
    }
    return result;
}

void expect_near(Rgb a, Rgb b, float tolerance) {
    EXPECT_LT(length(a - b), tolerance) << a.r << " " << b.r;
}

// What the second order leaves of the clamped cosine: 1/6 - 1/16 - 1/12 - 5/256 = 1/768 in the mean square, 3/32 on the
// horizon.
TEST(directional_form, error_of_one_beam_is_that_of_the_second_order_expansion) {
    constexpr int kSteps = 100000;
    const Vec3 d = normalize_or_zero({1, -2, 3});
    DirectionalForm form;
    add_beam(form, Rgb(1), d);
    test::Random random(5);
    double squares = 0;
    double clamped_squares = 0;
    double worst = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Vec3 n(random.direction());
        const float exact = std::max(0.0F, dot(n, d));
        const double error = static_cast<double>(evaluate(form, n).g - exact);
        const double clamped_error = static_cast<double>(evaluate_clamped(form, n).g - exact);
        squares += error * error;
        clamped_squares += clamped_error * clamped_error;
        worst = std::max(worst, std::abs(error));
    }
    EXPECT_NEAR(squares / kSteps, 1.0 / 768, 0.01 / 768);
    EXPECT_NEAR(std::sqrt(clamped_squares / kSteps), 0.033, 0.001);
    EXPECT_NEAR(worst, 3.0 / 32, 1e-4);
    // Seen from the front, on the horizon and from behind.
    EXPECT_NEAR(evaluate(form, d).r, 3.0F / 32 + 0.5F + 15.0F / 32, 1e-6F);
    EXPECT_NEAR(evaluate(form, normalize_or_zero(cross(d, {0, 0, 1}))).r, 3.0F / 32, 1e-6F);
    EXPECT_NEAR(evaluate(form, -d).r, 2.0F / 32, 1e-6F);
}

// Mean, first moment and second moment along d, over all normals, equal those of the clamped cosine c.
TEST(directional_form, moments_of_a_beam_are_exact) {
    const Vec3d d = glm::normalize(Vec3d(2, 1, -1));
    DirectionalForm form;
    add_beam(form, Rgb(1, 2, 0), Vec3(d));
    constexpr int kSteps = 400;
    double mean = 0;
    Vec3d first(0);
    double along = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double z = -1 + 2 * (i + 0.5) / kSteps;
            const double angle = 2 * static_cast<double>(kPi) * (j + 0.5) / kSteps;
            const double radius = std::sqrt(1 - z * z);
            const Vec3d n{radius * std::cos(angle), radius * std::sin(angle), z};
            const double value = static_cast<double>(evaluate(form, Vec3(n)).r) / (kSteps * kSteps);
            mean += value;
            first += value * n;
            along += value * glm::dot(n, d) * glm::dot(n, d);
        }
    }
    EXPECT_NEAR(mean, 1.0 / 4, 1e-5);               // half the integral of c over [0, 1]
    EXPECT_LT(glm::length(first - d / 6.0), 1e-5);  // of c^2
    EXPECT_NEAR(along, 1.0 / 8, 1e-5);              // of c^3
    EXPECT_NEAR(evaluate(form, Vec3(d)).g, 2 * evaluate(form, Vec3(d)).r, 1e-6F);
    EXPECT_EQ(evaluate(form, Vec3(d)).b, 0);
}

TEST(directional_form, beam_and_basis_are_symmetric) {
    test::Random random(6);
    for (int i = 0; i < 100; ++i) {
        const Vec3 a(random.direction());
        const Vec3 b(random.direction());
        const auto dot_of = [](const auto& x, const auto& y) {
            float sum = 0;
            for (std::size_t k = 0; k < kFormSize; ++k) {
                sum += x[k] * y[k];
            }
            return sum;
        };
        DirectionalForm form;
        add_beam(form, Rgb(1), b);
        EXPECT_NEAR(dot_of(beam_coefficients(a), form_basis(b)), evaluate(form, a).r, 1e-6F);
        EXPECT_NEAR(dot_of(beam_coefficients(b), form_basis(a)), evaluate(form, a).r, 1e-6F);
    }
}

TEST(directional_form, forms_add_and_scale) {
    test::Random random(7);
    const DirectionalForm a = random_form(random);
    const DirectionalForm b = random_form(random);
    const Vec3 n(random.direction());
    expect_near(evaluate(a + b, n), evaluate(a, n) + evaluate(b, n), 1e-5F);
    expect_near(evaluate(a * 3.0F, n), 3.0F * evaluate(a, n), 1e-5F);
    expect_near(evaluate(3.0F * a, n), 3.0F * evaluate(a, n), 1e-5F);
    DirectionalForm tinted = a;
    tinted *= Rgb(0, 1, 2);
    expect_near(evaluate(tinted, n), Rgb(0, 1, 2) * evaluate(a, n), 1e-5F);
}

TEST(directional_form, clamped_value_is_never_negative) {
    DirectionalForm form;
    add_beam(form, Rgb(1), {0, 0, 1});
    // The expansion is lowest, -0.0396, at c = -8/15.
    const Vec3 n{std::sqrt(1 - 64.0F / 225), 0, -8.0F / 15};
    EXPECT_NEAR(evaluate(form, n).r, 3.0F / 32 - 2.0F / 15, 1e-6F);
    EXPECT_EQ(evaluate_clamped(form, n), Rgb(0));
    EXPECT_EQ(evaluate_clamped(form, {0, 0, 1}), evaluate(form, {0, 0, 1}));
}

TEST(reflection_operator, equals_the_sum_over_its_faces) {
    test::Random random(8);
    const auto faces = random_faces(random, 50);
    const DirectionalForm irradiance = random_form(random);
    DirectionalForm expected;
    Rgb power(0);
    for (const Face& face : faces) {
        const Rgb radiosity = face.reflectance * evaluate(irradiance, face.n);
        add_face(expected, radiosity * (face.area / kPi), face.n);
        power += face.area * radiosity;
    }
    const ReflectionOperator reflect = operator_of(faces);
    const DirectionalForm intensity = reflect.apply(irradiance);
    for (std::size_t i = 0; i < kFormSize; ++i) {
        expect_near(intensity.coefficients[i], expected.coefficients[i], 1e-5F * length(power));
    }
    expect_near(reflect.reflected_power(irradiance), power, 1e-5F * length(power));
}

TEST(reflection_operator, operators_of_disjoint_groups_add) {
    test::Random random(9);
    const auto one = random_faces(random, 7);
    const auto two = random_faces(random, 9);
    auto both = one;
    both.insert(both.end(), two.begin(), two.end());
    const DirectionalForm irradiance = random_form(random);
    ReflectionOperator sum = operator_of(one);
    sum += operator_of(two);
    const Vec3 w(random.direction());
    expect_near(evaluate(sum.apply(irradiance), w), evaluate(operator_of(both).apply(irradiance), w), 1e-4F);
}

// All that is reflected leaves: the intensity integrated over the sphere is the power.
TEST(reflection_operator, outgoing_intensity_carries_the_reflected_power) {
    test::Random random(10);
    const ReflectionOperator reflect = operator_of(random_faces(random, 20));
    const DirectionalForm irradiance = random_form(random);
    const DirectionalForm j = reflect.apply(irradiance);
    const Rgb mean = j.coefficients[0] + (j.coefficients[4] + j.coefficients[5] + j.coefficients[6]) / 3.0F;
    const Rgb power = reflect.reflected_power(irradiance);
    expect_near(4 * kPi * mean, power, 1e-5F * length(power));
}

}  // namespace
}  // namespace gg
