#include "radiosity/correction.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

// Differences that are to be expected, as shares of what links bring: of a whole triangle, and of a part to the whole.
constexpr float kWhole = 0.15F, kPart = 0.1F;
constexpr float kDark = 1e-6F;  // W/m2: no light
constexpr float kEven = 0.1F;   // share of a triangle's mean that even its darkest parts may have by mistake

// Sums over the leaves of an element.
struct Difference {
    float area = 0;
    float by_links = 0;  // area times luminance
    Rgb sum{0.0F};       // area times (what rays say, less what links bring)
    float noise = 0;     // squared area over rays: times the variance of one ray, that of the sum
    float rays = 0;
    float spread = 0;  // rays times the variance of one of them
};

class Corrector {
  public:
    Corrector(const Hierarchy& hierarchy, std::vector<Difference>& differences, Lighting& lighting)
        : hierarchy_(hierarchy), differences_(differences), lighting_(lighting) {}

    // `usual`: variance of a ray on the whole instance. A place's own few rays must not say how much to trust them:
    // where they miss what is bright, they agree.
    void correct(NodeId root, float usual) {
        constexpr float kUsualRays = 64;
        const Difference& all = pull(root);
        const Root whole{kEven * all.by_links / std::max(all.area, 1e-30F),
                         (all.spread + kUsualRays * usual) / (all.rays + kUsualRays)};
        push(root, Rgb(0.0F), whole);
    }

  private:
    struct Root {
        float even = 0;      // W/m2, luminance: is counted to what links bring anywhere
        float variance = 0;  // of a ray
    };

    const Difference& pull(NodeId id) {
        const Node& node = hierarchy_[id];
        Difference& all = differences_[id];
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            const Difference& part = pull(child);
            all.area += part.area;
            all.by_links += part.by_links;
            all.sum += part.sum;
            all.noise += part.noise;
            all.rays += part.rays;
            all.spread += part.spread;
        }
        return all;
    }

    // `inherited` and what is made of it: shares of what links bring, since errors are the larger the more they bring.
    // Trust must not depend on what it is to judge: noise is lopsided, and large errors look sure of themselves.
    void push(NodeId id, Rgb inherited, const Root& root) {
        const Node& node = hierarchy_[id];
        const Difference& all = differences_[id];
        const float base = std::max(all.by_links + root.even * all.area, kDark * all.area);
        if (!(base > 0)) {
            return;  // no area
        }
        const float expected = node.depth == 0 ? kWhole : kPart;
        const float trust = expected * expected / (expected * expected + root.variance * all.noise / (base * base));
        const Rgb share = inherited + trust * (all.sum / base - inherited);
        if (node.child_count == 0) {
            const Rgb by_links = lighting_.irradiance(id) - lighting_.correction(id);
            lighting_.set_correction(id, glm::max(share * base / std::max(all.area, 1e-30F), -by_links));
            return;
        }
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            push(child, share, root);
        }
    }

    const Hierarchy& hierarchy_;
    std::vector<Difference>& differences_;
    Lighting& lighting_;
};

}  // namespace

void correct_elements(const Hierarchy& hierarchy, std::span<const NodeId> elements, std::span<const Rgb> direct,
                      std::span<const GatheredLight::Estimate> estimates, Lighting& lighting, const Control& control) {
    std::vector<Difference> differences(hierarchy.nodes().size());
    std::vector<float> spread(hierarchy.scene().instances.size()), rays(spread.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const NodeId id = elements[i];
        const auto& [irradiance, variance, count] = estimates[i];
        const float area = hierarchy[id].area;
        const Rgb by_links = lighting.irradiance(id) - lighting.correction(id) - direct[i];
        const auto weight = static_cast<float>(count);
        differences[id] = {area,   area * luminance(by_links), area * (irradiance - by_links), area * area / weight,
                           weight, weight * variance};
        spread[hierarchy[id].instance] += weight * variance;
        rays[hierarchy[id].instance] += weight;
    }
    std::vector<NodeId> roots;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind == NodeKind::kElement && hierarchy[id].depth == 0) {
            roots.push_back(id);
        }
    }
    Corrector corrector(hierarchy, differences, lighting);
    parallel_for(roots.size(), 64, control, [&](std::size_t i) {
        const std::uint32_t instance = hierarchy[roots[i]].instance;
        corrector.correct(roots[i], spread[instance] / std::max(rays[instance], 1.0F));
    });
}

}  // namespace gg
