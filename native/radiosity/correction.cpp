#include "radiosity/correction.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

// Differences that are to be expected, as shares of what links bring: of a whole triangle, and of a part to the whole.
constexpr float kWhole = 0.15F, kPart = 0.01F;
constexpr float kDark = 1e-6F;  // W/m2: no light
constexpr float kEven = 0.1F;   // share of a triangle's mean that even its darkest parts may have by mistake

// Sums over the leaves of an element.
struct Difference {
    float area = 0;
    float by_links = 0;  // area times luminance
    Rgb sum{0.0F};       // area times (what rays say, less what links bring)
    // Squares, over the number of rays, of the area and of area times luminance by links.
    float noise_of_area = 0, noise_by_links = 0;
};

class Corrector {
  public:
    // `variance`: of one ray, relative to the square of what links bring; the same everywhere. Trust must not depend on
    // what it is to judge: where few rays miss what is bright, they agree.
    Corrector(const Hierarchy& hierarchy, std::vector<Difference>& differences, float variance, Lighting& lighting)
        : hierarchy_(hierarchy), differences_(differences), variance_(variance), lighting_(lighting) {}

    void correct(NodeId root) {
        const Difference& all = pull(root);
        push(root, Rgb(0.0F), kEven * all.by_links / std::max(all.area, 1e-30F));
    }

  private:
    const Difference& pull(NodeId id) {
        const Node& node = hierarchy_[id];
        Difference& all = differences_[id];
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            const Difference& part = pull(child);
            all.area += part.area;
            all.by_links += part.by_links;
            all.sum += part.sum;
            all.noise_of_area += part.noise_of_area;
            all.noise_by_links += part.noise_by_links;
        }
        return all;
    }

    // `inherited` and what is made of it: shares of what links bring, since errors are the larger the more they bring.
    // `even` [W/m2] is counted to what links bring anywhere.
    void push(NodeId id, Rgb inherited, float even) {
        const Node& node = hierarchy_[id];
        const Difference& all = differences_[id];
        const float base = std::max(all.by_links + even * all.area, kDark * all.area);
        if (!(base > 0)) {
            return;  // no area
        }
        const float expected = node.depth == 0 ? kWhole : kPart;
        const float noise = all.noise_by_links + even * even * all.noise_of_area;
        const float trust = expected * expected / (expected * expected + variance_ * noise / (base * base));
        const Rgb share = inherited + trust * (all.sum / base - inherited);
        if (node.child_count == 0) {
            const Rgb by_links = lighting_.irradiance(id) - lighting_.correction(id);
            lighting_.set_correction(id, glm::max(share * base / std::max(all.area, 1e-30F), -by_links));
            return;
        }
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            push(child, share, even);
        }
    }

    const Hierarchy& hierarchy_;
    std::vector<Difference>& differences_;
    float variance_;
    Lighting& lighting_;
};

}  // namespace

void correct_elements(const Hierarchy& hierarchy, std::span<const NodeId> elements, std::span<const Rgb> direct,
                      std::span<const GatheredLight::Estimate> estimates, Lighting& lighting, const Control& control) {
    std::vector<Difference> differences(hierarchy.nodes().size());
    double spread = 0, squares = 0;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        const NodeId id = elements[i];
        const auto& [irradiance, variance, rays] = estimates[i];
        const float area = hierarchy[id].area;
        const Rgb by_links = lighting.irradiance(id) - lighting.correction(id) - direct[i];
        const float power = area * luminance(by_links), count = static_cast<float>(rays);
        differences[id] = {area, power, area * (irradiance - by_links), area * area / count, power * power / count};
        spread += static_cast<double>(area) * variance;
        squares += static_cast<double>(power) * luminance(by_links);
    }
    const auto relative = static_cast<float>(spread / std::max(squares, 1e-30));
    std::vector<NodeId> roots;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind == NodeKind::kElement && hierarchy[id].depth == 0) {
            roots.push_back(id);
        }
    }
    Corrector corrector(hierarchy, differences, relative, lighting);
    parallel_for(roots.size(), 64, control, [&](std::size_t i) { corrector.correct(roots[i]); });
}

}  // namespace gg
