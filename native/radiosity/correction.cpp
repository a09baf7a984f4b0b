#include "radiosity/correction.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

constexpr float kDoubt = 3;  // variances of the noise that a squared difference must exceed

// Sums over the leaves of an element.
struct Difference {
    float area = 0;
    Rgb sum{0.0F};    // area times (what rays say, less what links bring)
    float noise = 0;  // squared area over rays: times the variance of one ray, that of the sum
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
        push(root, Rgb(0.0F), (all.spread + kUsualRays * usual) / (all.rays + kUsualRays));
    }

  private:
    const Difference& pull(NodeId id) {
        const Node& node = hierarchy_[id];
        Difference& all = differences_[id];
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            const Difference& part = pull(child);
            all.area += part.area;
            all.sum += part.sum;
            all.noise += part.noise;
            all.rays += part.rays;
            all.spread += part.spread;
        }
        return all;
    }

    void push(NodeId id, Rgb inherited, float variance) {
        const Node& node = hierarchy_[id];
        const Difference& all = differences_[id];
        const float unit = 1 / std::max(all.area, 1e-30F);
        const Rgb own = all.sum * unit - inherited;
        const float square = luminance(own) * luminance(own);
        const float trust =
            square > 0 ? std::max(0.0F, 1 - kDoubt * variance * all.noise * unit * unit / square) : 0.0F;
        const Rgb correction = inherited + trust * own;
        if (node.child_count == 0) {
            const Rgb by_links = lighting_.irradiance(id) - lighting_.correction(id);
            lighting_.set_correction(id, glm::max(correction, -by_links));
            return;
        }
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            push(child, correction, variance);
        }
    }

    const Hierarchy& hierarchy_;
    std::vector<Difference>& differences_;
    Lighting& lighting_;
};

}  // namespace

void correct_elements(const Hierarchy& hierarchy, std::span<const NodeId> elements,
                      std::span<const GatheredLight::Estimate> estimates, Lighting& lighting, const Control& control) {
    std::vector<Difference> differences(hierarchy.nodes().size());
    std::vector<float> spread(hierarchy.scene().instances.size()), rays(spread.size());
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const NodeId id = elements[i];
        const auto& [irradiance, variance, count] = estimates[i];
        const float area = hierarchy[id].area;
        const Rgb by_links = lighting.irradiance(id) - lighting.correction(id);
        const auto weight = static_cast<float>(count);
        differences[id] = {area, area * (irradiance - by_links), area * area / weight, weight, weight * variance};
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
