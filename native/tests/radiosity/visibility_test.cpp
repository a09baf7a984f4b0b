// Visibilities of links against the share of thousands of random pairs that see each other.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "oracles/brute_visibility.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

// Weighted by the power that the links could bring.
struct Errors {
    double mean = 0;  // signed
    double rms = 0;
    std::size_t count = 0;
};

Errors errors_of(const Prepared& prepared, const Solution& solution, const std::vector<Link>& links) {
    Errors errors;
    double weights = 0;
    for (const Link& link : links) {
        const double truth =
            oracle::counted_visibility(solution.hierarchy, *prepared.tracer, link.receiver, link.sender, 1024, 1);
        if (truth < 0) {
            continue;
        }
        const double weight = solution.hierarchy[link.receiver].area * link.form_factor *
                              luminance(solution.lighting.radiosity(link.sender));
        const double error = link.visibility - truth;
        weights += weight;
        errors.mean += weight * error;
        errors.rms += weight * error * error;
        ++errors.count;
    }
    errors.mean /= weights;
    errors.rms = std::sqrt(errors.rms / weights);
    return errors;
}

class LinkVisibility : public testing::Test {
  protected:
    // Every n-th link from senders of that kind to elements.
    [[nodiscard]] std::vector<Link> some_links(NodeKind sender, std::size_t wanted) const {
        std::vector<Link> all, some;
        for (const Link& link : solution_->links.all) {
            if (solution_->hierarchy[link.receiver].kind == NodeKind::kElement &&
                solution_->hierarchy[link.sender].kind == sender && link.form_factor > 0) {
                all.push_back(link);
            }
        }
        for (std::size_t i = 0; i < wanted && i < all.size(); ++i) {
            some.push_back(all[all.size() > wanted ? i * all.size() / wanted : i]);
        }
        return some;
    }
    [[nodiscard]] std::vector<Link> estimated_again(std::vector<Link> links, int rays) const {
        for (Link& link : links) {
            link = prepared_.estimate(solution_->hierarchy, link.receiver, link.sender, rays);
        }
        return links;
    }

    Prepared prepared_{mixed_scene()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve(0.01F);
};

TEST_F(LinkVisibility, of_elements_is_unbiased) {
    const Errors errors = errors_of(prepared_, *solution_, some_links(NodeKind::kElement, 4000));
    EXPECT_GT(errors.count, 500U);
    EXPECT_NEAR(errors.mean, 0, 0.05);  // a few strong links rule: 0.03 from seed to seed
    EXPECT_LT(errors.rms, 0.2);
}

TEST_F(LinkVisibility, of_lamps_is_unbiased) {
    const Errors errors = errors_of(prepared_, *solution_, some_links(NodeKind::kLamp, 4000));
    EXPECT_GT(errors.count, 500U);
    EXPECT_NEAR(errors.mean, 0, 0.01);
    EXPECT_LT(errors.rms, 0.1);
}

TEST_F(LinkVisibility, converges_with_the_number_of_rays) {
    for (const NodeKind kind : {NodeKind::kElement, NodeKind::kLamp}) {
        const auto links = some_links(kind, 4000);
        const Errors few = errors_of(prepared_, *solution_, estimated_again(links, 4));
        const Errors many = errors_of(prepared_, *solution_, estimated_again(links, 64));
        EXPECT_NEAR(few.mean, 0, 0.08);
        EXPECT_NEAR(many.mean, 0, 0.02);
        EXPECT_LT(many.rms, 0.07);
        EXPECT_LT(many.rms, 0.6 * few.rms);
    }
}

}  // namespace
}  // namespace gg::test
