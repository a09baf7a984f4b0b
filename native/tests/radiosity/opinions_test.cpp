// What rays and links say of light, made one.
#include "radiosity/opinions.h"

#include <gtest/gtest.h>

#include "support/test_scenes.h"

namespace gg::test {
namespace {

// A quad whose two triangles are divided into four elements each.
class OpinionsTest : public testing::Test {
  protected:
    OpinionsTest() {
        builder_.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, builder_.material(Rgb(0.5F)));
        prepared_ = std::make_unique<Prepared>(builder_.description);
        hierarchy_ = std::make_unique<Hierarchy>(prepared_->scene, *prepared_->colors, prepared_->faces());
        while (open_all()) {
        }
        for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
            const Node& node = (*hierarchy_)[id];
            if (node.kind == NodeKind::kElement && node.child_count == 0) {
                leaves_.push_back(id);
                opinions_.push_back({Rgb(1.0F), Rgb(1.0F), 8});
            }
        }
    }

    // Everything down to quarters of triangles; false when there is nothing more to open.
    bool open_all() {
        std::vector<NodeId> leaves;
        for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
            const Node& node = (*hierarchy_)[id];
            if (is_surface(node) && node.child_count == 0 && (is_cluster(node) || node.depth == 0)) {
                leaves.push_back(id);
            }
        }
        hierarchy_->open(leaves, prepared_->control);
        return !leaves.empty();
    }

    void blend(const Trust& trust) {
        ElementOpinions(*hierarchy_, leaves_).blend(opinions_, trust, prepared_->control);
    }

    [[nodiscard]] double power() const {
        double sum = 0;
        for (std::size_t i = 0; i < opinions_.size(); ++i) {
            sum += (*hierarchy_)[leaves_[i]].area * luminance(opinions_[i].by_rays);
        }
        return sum;
    }

    [[nodiscard]] double area() const {
        double sum = 0;
        for (const NodeId leaf : leaves_) {
            sum += (*hierarchy_)[leaf].area;
        }
        return sum;
    }

    SceneBuilder builder_;
    std::unique_ptr<Prepared> prepared_;
    std::unique_ptr<Hierarchy> hierarchy_;
    std::vector<NodeId> leaves_;
    std::vector<Opinions> opinions_;  // per leaf
};

TEST_F(OpinionsTest, many_rays_are_believed) {
    ASSERT_GE(opinions_.size(), 8U);
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        opinions_[i].by_rays = Rgb(0.2F * static_cast<float>(i));
        opinions_[i].rays = 1e8F;
    }
    const std::vector<Opinions> before = opinions_;
    blend({1, 0.5F, 1});
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        EXPECT_NEAR(luminance(opinions_[i].by_rays), luminance(before[i].by_rays), 1e-3F) << i;
    }
}

TEST_F(OpinionsTest, few_rays_of_parts_are_believed_as_a_whole) {
    // Every other leaf says 0.5, its neighbours 1.5 of what links say: together they say 1.
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        opinions_[i].by_rays = Rgb(i % 2 ? 1.5F : 0.5F);
    }
    blend({1, 0.01F, 1});
    for (const Opinions& o : opinions_) {
        EXPECT_NEAR(luminance(o.by_rays), 1, 0.01F);
    }
    EXPECT_NEAR(power(), area(), 1e-3 * area());
}

TEST_F(OpinionsTest, trust_grows_with_the_number_of_rays) {
    double before = 1;
    for (const float rays : {1.0F, 10.0F, 100.0F, 10000.0F}) {
        for (Opinions& o : opinions_) {
            o.by_rays = Rgb(3.0F);
            o.rays = rays;
        }
        blend({0.3F, 0.01F, 1});
        EXPECT_GT(power() / area(), before) << rays;
        before = power() / area();
    }
    EXPECT_NEAR(before, 3, 0.1);
}

TEST_F(OpinionsTest, links_give_the_course) {
    // Links say that light falls off from 2 to 0.4; rays only know that there is half as much.
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        opinions_[i].by_links = Rgb(2 - 0.2F * static_cast<float>(i % 8));
        opinions_[i].by_rays = 0.5F * opinions_[i].by_links;
        opinions_[i].rays = 1000;
    }
    blend({1, 0.01F, 1});
    for (const Opinions& o : opinions_) {
        EXPECT_NEAR(luminance(o.by_rays) / luminance(o.by_links), 0.5F, 0.1F);
    }
}

TEST_F(OpinionsTest, nothing_is_below_zero) {
    for (std::size_t i = 0; i < opinions_.size(); ++i) {
        opinions_[i].by_links = Rgb(i == 0 ? 10.0F : 0.0F);
        opinions_[i].by_rays = Rgb(0.0F);
    }
    blend({1, 0.5F, 1});
    for (const Opinions& o : opinions_) {
        EXPECT_GE(luminance(o.by_rays), 0);
    }
}

}  // namespace
}  // namespace gg::test
