// Visibilities of links against the share of thousands of random pairs that see each other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/random.h"
#include "oracles/brute_visibility.h"
#include "radiosity/link_estimate.h"
#include "support/law_scenes.h"

namespace gg::test {
namespace {

struct Errors {
    double mean = 0;               // signed
    std::vector<double> absolute;  // ascending

    [[nodiscard]] double quantile(double share) const {
        return absolute[static_cast<std::size_t>(share * static_cast<double>(absolute.size() - 1))];
    }
};

Errors errors_of(const Prepared& prepared, const Solution& solution, const std::vector<Link>& links) {
    Errors errors;
    for (const Link& link : links) {
        const double truth = oracle::counted_visibility(solution.hierarchy, *prepared.tracer, link.receiver, link.sender,
                                                        4096, 1);
        if (truth >= 0) {
            errors.mean += link.visibility - truth;
            errors.absolute.push_back(std::abs(link.visibility - truth));
        }
    }
    errors.mean /= static_cast<double>(errors.absolute.size());
    std::sort(errors.absolute.begin(), errors.absolute.end());
    return errors;
}

// Every stride-th link that `pick` takes.
template <typename Pick>
std::vector<Link> some_links(const Solution& solution, std::size_t wanted, const Pick& pick) {
    std::vector<Link> all, some;
    std::copy_if(solution.links.all.begin(), solution.links.all.end(), std::back_inserter(all), pick);
    for (std::size_t i = 0; i < wanted && i < all.size(); ++i) {
        some.push_back(all[all.size() > wanted ? i * all.size() / wanted : i]);
    }
    return some;
}

class LinkVisibility : public testing::Test {
  protected:
    Prepared prepared_{mixed_scene()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve(0.02F);
};

TEST_F(LinkVisibility, of_all_links_is_unbiased) {
    const auto errors = errors_of(prepared_, *solution_, some_links(*solution_, 600, [](const Link& link) {
                                      return !link.near && link.form_factor > 0;
                                  }));
    ASSERT_GT(errors.absolute.size(), 400U);
    EXPECT_NEAR(errors.mean, 0, 0.02);
    EXPECT_LT(errors.quantile(0.5), 0.02);
    EXPECT_LT(errors.quantile(0.9), 0.2);
    printf("all %g %g %g %g\n", errors.mean, errors.quantile(.5), errors.quantile(.9), errors.quantile(1));
}

TEST_F(LinkVisibility, of_partly_blocked_links_is_unbiased) {
    const auto errors = errors_of(prepared_, *solution_, some_links(*solution_, 300, [](const Link& link) {
                                      return !link.near && link.visibility > 0 && link.visibility < 1;
                                  }));
    ASSERT_GT(errors.absolute.size(), 200U);
    EXPECT_NEAR(errors.mean, 0, 0.03);
    EXPECT_LT(errors.quantile(0.9), 0.3);
    printf("part %g %g %g %g\n", errors.mean, errors.quantile(.5), errors.quantile(.9), errors.quantile(1));
}

// With all the rays that there can be, for links of every kind.
TEST_F(LinkVisibility, converges_with_the_number_of_rays) {
    std::vector<Link> few, many;
    for (const Link& link : some_links(*solution_, 300, [](const Link& l) { return !l.near && l.form_factor > 0; })) {
        const auto estimate = [&](int rays) {
            return estimate_link(solution_->hierarchy, *prepared_.tracer, link.receiver, link.sender, rays, SampleSet::kLink,
                                 nullptr);
        };
        few.push_back(estimate(4));
        many.push_back(estimate(64));
    }
    const Errors coarse = errors_of(prepared_, *solution_, few);
    const Errors fine = errors_of(prepared_, *solution_, many);
    EXPECT_NEAR(coarse.mean, 0, 0.02);
    EXPECT_NEAR(fine.mean, 0, 0.01);
    EXPECT_LT(fine.quantile(0.9), 0.07);
    EXPECT_LT(fine.quantile(0.9), 0.7 * coarse.quantile(0.9));
    printf("few %g %g %g %g\n", coarse.mean, coarse.quantile(.5), coarse.quantile(.9), coarse.quantile(1));
    printf("many %g %g %g %g\n", fine.mean, fine.quantile(.5), fine.quantile(.9), fine.quantile(1));
}

}  // namespace
}  // namespace gg::test
