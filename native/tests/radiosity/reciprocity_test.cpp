// What two nodes exchange per unit of radiosity is the same both ways: A_r F_rs = A_s F_sr.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/random.h"
#include "radiosity/link_estimate.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"

namespace gg::test {
namespace {

// Power that arrives at the link's receiver when every face of its sender has radiosity 1 W/m2 and nothing is in
// between, W. As Lighting gathers, but from the faces themselves.
double exchange(const Hierarchy& hierarchy, const Link& link) {
    const Node& to = hierarchy[link.receiver];
    const Node& from = hierarchy[link.sender];
    const auto for_each_face = [&](const Node& cluster, const auto& body) {
        hierarchy.for_each_triangle(cluster, [&](std::uint32_t instance, std::uint32_t triangle) {
            const Vec3 area = world_area_vector(hierarchy.scene(), instance, triangle);
            const Sides sides = hierarchy.scene().sides_of(instance, triangle);
            if (sides != Sides::kBack) {
                body(area);
            }
            if (sides != Sides::kFront) {
                body(-area);
            }
        });
    };
    double arriving = link.form_factor;
    if (is_cluster(from)) {
        DirectionalForm intensity;
        for_each_face(from, [&](Vec3 area) {
            add_face(intensity, Rgb(length(area) / kPi), normalize_or_zero(area));
        });
        arriving *= kPi * evaluate_clamped(intensity, normalize_or_zero(to.center - from.center)).r;
    }
    if (to.kind == NodeKind::kElement) {
        return arriving * to.area;
    }
    DirectionalForm light;
    add_cone(light, Rgb(static_cast<float>(arriving)), link.shape);
    double power = 0;
    for_each_face(to, [&](Vec3 area) { power += length(area) * evaluate_clamped(light, normalize_or_zero(area)).r; });
    return power;
}

struct Sums {
    double forth = 0, back = 0;
    std::vector<double> ratios;  // log of forth over back
};

template <typename Pick>
Sums exchange_of_pairs(const Prepared& prepared, const Solution& solution, const Pick& pick, std::size_t wanted) {
    const auto& nodes = solution.hierarchy.nodes();
    Sums sums;
    for (std::uint64_t i = 0; i < 2000000 && sums.ratios.size() < wanted; ++i) {
        const auto a = static_cast<NodeId>(hash64(i, 0) % nodes.size());
        const auto b = static_cast<NodeId>(hash64(i, 1) % nodes.size());
        if (!pick(nodes[a], nodes[b]) || !separated(nodes[a], nodes[b]) ||
            never_exchange(solution.hierarchy, nodes[a], nodes[b])) {
            continue;
        }
        const auto exchanged = [&](NodeId receiver, NodeId sender) {
            return exchange(solution.hierarchy, prepared.estimate(solution.hierarchy, receiver, sender, 4));
        };
        const double forth = exchanged(a, b), back = exchanged(b, a);
        if (forth > 0 && back > 0) {
            const double size = 1 / (nodes[a].area * nodes[b].area);  // so that large pairs do not rule alone
            sums.forth += std::sqrt(size) * forth;
            sums.back += std::sqrt(size) * back;
            sums.ratios.push_back(std::log(forth / back));
        }
    }
    return sums;
}

double spread(const Sums& sums) {
    double squares = 0;
    for (const double ratio : sums.ratios) {
        squares += ratio * ratio;
    }
    return std::sqrt(squares / static_cast<double>(sums.ratios.size()));
}

class Reciprocity : public testing::Test {
  protected:
    Prepared prepared_{mixed_scene()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve(0.05F);
};

bool element(const Node& node) { return node.kind == NodeKind::kElement; }

TEST_F(Reciprocity, of_elements_far_apart_is_exact) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_,
        [](const Node& a, const Node& b) {
            return element(a) && element(b) && length(a.center - b.center) > 5 * (a.radius + b.radius);
        },
        300);
    ASSERT_EQ(sums.ratios.size(), 300U);
    EXPECT_NEAR(sums.forth / sums.back, 1, 1e-3);
    printf("far %g %g\n", sums.forth / sums.back, spread(sums));
    EXPECT_LT(spread(sums), 0.02);
}

TEST_F(Reciprocity, of_elements_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return element(a) && element(b); }, 500);
    ASSERT_EQ(sums.ratios.size(), 500U);
    printf("elements %g %g\n", sums.forth / sums.back, spread(sums));
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.01);
}

TEST_F(Reciprocity, of_clusters_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return is_cluster(a) && is_cluster(b); }, 300);
    ASSERT_EQ(sums.ratios.size(), 300U);
    printf("clusters %g %g\n", sums.forth / sums.back, spread(sums));
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.03);
    EXPECT_LT(spread(sums), 0.3);
}

TEST_F(Reciprocity, of_clusters_and_elements_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return is_cluster(a) && element(b); }, 300);
    ASSERT_EQ(sums.ratios.size(), 300U);
    printf("mixed %g %g\n", sums.forth / sums.back, spread(sums));
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.05);
    EXPECT_LT(spread(sums), 0.5);
}

}  // namespace
}  // namespace gg::test
