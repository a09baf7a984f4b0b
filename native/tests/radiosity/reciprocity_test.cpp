// What two nodes exchange per unit of radiosity is the same both ways: A_r F_rs = A_s F_sr.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "radiosity/link_estimate.h"
#include "support/law_scenes.h"

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
        for_each_face(from, [&](Vec3 area) { add_face(intensity, Rgb(length(area) / kPi), normalize_or_zero(area)); });
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

// Every pair weighs by the root of its areas, so that large ones do not rule alone.
struct Sums {
    double forth = 0, back = 0;
    double squares = 0, squared_differences = 0;
    std::size_t pairs = 0;

    void add(double there, double here, double weight) {
        forth += weight * there;
        back += weight * here;
        const double mean = 0.5 * weight * (there + here), difference = weight * (there - here);
        squares += mean * mean;
        squared_differences += difference * difference;
        ++pairs;
    }
    // Root mean square of the difference as a share of that of the exchange.
    [[nodiscard]] double spread() const { return std::sqrt(squared_differences / squares); }
};

template <typename Pick>
Sums exchange_of_pairs(const Prepared& prepared, const Solution& solution, const Pick& pick, std::size_t wanted) {
    const auto& nodes = solution.hierarchy.nodes();
    Sums sums;
    for (std::uint64_t i = 0; i < 2000000 && sums.pairs < wanted; ++i) {
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
        sums.add(forth, back, 1 / std::sqrt(nodes[a].area * nodes[b].area));
    }
    return sums;
}

class Reciprocity : public testing::Test {
  protected:
    Prepared prepared_{mixed_scene()};
    std::shared_ptr<const Solution> solution_ = prepared_.solve(0.05F);
};

bool element(const Node& node) {
    return node.kind == NodeKind::kElement;
}

TEST_F(Reciprocity, of_elements_far_apart_holds_for_each) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_,
        [](const Node& a, const Node& b) {
            return element(a) && element(b) && length(a.center - b.center) > 5 * (a.radius + b.radius);
        },
        300);
    ASSERT_EQ(sums.pairs, 300U);
    EXPECT_NEAR(sums.forth / sums.back, 1, 1e-3);
    EXPECT_LT(sums.spread(), 0.1);
}

TEST_F(Reciprocity, of_elements_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return element(a) && element(b); }, 500);
    ASSERT_EQ(sums.pairs, 500U);
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.01);
}

TEST_F(Reciprocity, of_clusters_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return is_cluster(a) && is_cluster(b); }, 300);
    ASSERT_EQ(sums.pairs, 300U);
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.03);
    EXPECT_LT(sums.spread(), 0.3);
}

TEST_F(Reciprocity, of_clusters_and_elements_holds_on_average) {
    const Sums sums = exchange_of_pairs(
        prepared_, *solution_, [](const Node& a, const Node& b) { return is_cluster(a) && element(b); }, 300);
    ASSERT_EQ(sums.pairs, 300U);
    EXPECT_NEAR(sums.forth / sums.back, 1, 0.08);
    EXPECT_LT(sums.spread(), 0.5);
}

}  // namespace
}  // namespace gg::test
