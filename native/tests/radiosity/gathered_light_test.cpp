// What faces of clusters and elements see by rays of their own.
#include "radiosity/gathered_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "radiosity/correction.h"
#include "support/law_scenes.h"
#include "support/meshes.h"
#include "transport/emitter_sampling.h"

namespace gg::test {
namespace {

// body(triangle, its outward irradiance) for the faces of the first instance that stayed in clusters; returns how many.
template <typename Body>
int for_each_cluster_face(const Prepared& prepared, const Solution& solution, const Body& body) {
    int count = 0;
    for (std::uint32_t triangle = 0; triangle < prepared.scene.meshes[0].triangles.size(); ++triangle) {
        if (solution.elements.of(0, triangle, false) == kNone) {
            body(triangle, luminance(solution.face_light.irradiance(0, triangle, false)));
            ++count;
        }
    }
    return count;
}

// A sphere of 48 rings above a black field so far away and so large that the sphere stays in clusters.
void add_small_sphere(SceneBuilder& builder) {
    builder.sphere({0, 0, 0}, 0.1F, 48, builder.material(Rgb(0.5F)), false);
    builder.quad({-20, -20, -60}, {20, -20, -60}, {20, 20, -60}, {-20, 20, -60}, builder.material(Rgb(0.0F)));
}

TEST(GatheredLight, convex_body_below_an_even_sky_has_pi_everywhere) {
    SceneBuilder builder;
    builder.description.world = Rgb(1.0F);
    add_small_sphere(builder);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    double mean = 0;
    const int count = for_each_cluster_face(prepared, *solution, [&](std::uint32_t triangle, float e) {
        const float up = normalize(world_area_vector(prepared.scene, 0, triangle)).z;
        if (up > 0.2F) {  // does not see the field
            EXPECT_NEAR(e, kPi, 1e-3F) << triangle;
        }
        mean += e;
    });
    EXPECT_GT(mean / count, 0.9F * kPi);
    EXPECT_GT(count, 100);
}

TEST(GatheredLight, sphere_below_a_sun_has_the_cosine) {
    SceneBuilder builder;
    builder.sun({0, 0, -1}, Rgb(10));
    add_small_sphere(builder);
    Prepared prepared(builder.description);
    const auto solution = prepared.solve();
    const int count = for_each_cluster_face(prepared, *solution, [&](std::uint32_t triangle, float e) {
        const float cosine = normalize(world_area_vector(prepared.scene, 0, triangle)).z;
        EXPECT_NEAR(e, 10 * std::max(0.0F, cosine), 2.5F) << triangle;  // groups are a tenth of the sphere wide
        if (cosine < -0.3F) {
            EXPECT_EQ(e, 0) << triangle;
        }
    });
    EXPECT_GT(count, 100);
}

// A quad of elements on which links bring 1 W/m2 evenly.
class Correction : public testing::Test {
  protected:
    Correction() {
        builder_.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, builder_.material(Rgb(0.5F)));
        builder_.sun({0, 0, -1}, Rgb(1));
        prepared_ = std::make_unique<Prepared>(builder_.description);
        solution_ = std::const_pointer_cast<Solution>(prepared_->solve());
        for (NodeId id = 0; id < solution_->hierarchy.nodes().size(); ++id) {
            const Node& node = solution_->hierarchy[id];
            if (node.kind == NodeKind::kElement && node.child_count == 0 && !node.back) {
                elements_.push_back(id);
                solution_->lighting.set_correction(id, Rgb(0.0F));
            }
        }
        solution_->lighting.iterate(prepared_->control);
    }

    // The mean correction when rays say `irradiance`.
    float corrected(float irradiance, float variance, std::uint32_t rays) {
        const std::vector<GatheredLight::Estimate> estimates(elements_.size(), {Rgb(irradiance), variance, rays});
        const std::vector<Rgb> none(elements_.size(), Rgb(0.0F));
        correct_elements(solution_->hierarchy, elements_, none, estimates, solution_->lighting, prepared_->control);
        float sum = 0;
        for (const NodeId id : elements_) {
            sum += luminance(solution_->lighting.correction(id)) / static_cast<float>(elements_.size());
        }
        return sum;
    }

    SceneBuilder builder_;
    std::unique_ptr<Prepared> prepared_;
    std::shared_ptr<Solution> solution_;
    std::vector<NodeId> elements_;
};

TEST_F(Correction, follows_many_rays) {
    ASSERT_FALSE(elements_.empty());
    ASSERT_NEAR(luminance(solution_->lighting.irradiance(elements_[0])), 1, 1e-3F);
    EXPECT_NEAR(corrected(1.3F, 0.5F, 1000000), 0.3F, 0.01F);
}

TEST_F(Correction, does_not_trust_few_rays) {
    EXPECT_LT(corrected(1.3F, 4, 2), 0.05F);
}

TEST_F(Correction, leaves_no_irradiance_below_zero) {
    corrected(-3, 0, 1000000);
    solution_->lighting.iterate(prepared_->control);
    for (const NodeId id : elements_) {
        EXPECT_GE(luminance(solution_->lighting.irradiance(id)), -1e-5F);
    }
}

TEST_F(Correction, stays_until_it_is_made_anew) {
    corrected(1.3F, 0, 1000000);
    solution_->lighting.iterate(prepared_->control);
    EXPECT_NEAR(luminance(solution_->lighting.irradiance(elements_[0])), 1.3F, 0.01F);
    EXPECT_NEAR(corrected(1.3F, 0, 1000000), 0.3F, 0.01F);
}

}  // namespace
}  // namespace gg::test
