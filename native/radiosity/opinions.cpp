#include "radiosity/opinions.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"

namespace gg {

namespace {

constexpr float kDark = 1e-6F;  // W/m2: no light
constexpr float kEven = 0.1F;   // share of a triangle's mean that even its darkest parts may have by mistake

// Sums over the leaves of an element.
struct Sums {
    float area = 0;
    float by_links = 0;              // area times luminance
    Rgb by_rays{0.0F}, links{0.0F};  // area times irradiance
    // Squares, over the number of rays, of the area and of area times luminance by links.
    float noise_of_area = 0, noise_by_links = 0;
};

Sums sums_of(const Opinions& o, float area) {
    const float light = luminance(o.by_links);
    return {area,
            area * light,
            area * o.by_rays,
            area * o.by_links,
            area * area / o.rays,
            area * area * light * light / o.rays};
}

void add(Sums& all, const Sums& part) {
    all.area += part.area;
    all.by_links += part.by_links;
    all.by_rays += part.by_rays;
    all.links += part.links;
    all.noise_of_area += part.noise_of_area;
    all.noise_by_links += part.noise_by_links;
}

// `inherited` and what is returned: difference to what links say, as a share of it, since errors are the larger the
// more they say. `even` [W/m2] is counted to what links say anywhere.
struct Judgement {
    Rgb share{0.0F};
    float base = 0;  // [W]
};

Judgement judge(const Sums& all, Rgb inherited, float even, float expected, float ray) {
    const float base = std::max(all.by_links + even * all.area, kDark * all.area);
    if (!(base > 0)) {
        return {};  // no area
    }
    const float noise = all.noise_by_links + even * even * all.noise_of_area;
    const float trust = expected * expected / (expected * expected + ray * ray * noise / (base * base));
    return {inherited + trust * ((all.by_rays - all.links) / base - inherited), base};
}

void settle(Opinions& leaf, float area, const Judgement& judgement) {
    leaf.by_rays = glm::max(leaf.by_links + judgement.share * judgement.base / std::max(area, 1e-30F), Rgb(0.0F));
}

class Blender {
  public:
    Blender(const Hierarchy& hierarchy, std::span<Opinions> opinions, std::span<const std::uint32_t> opinion_of,
            const Trust& spread, std::vector<Sums>& sums)
        : hierarchy_(hierarchy), opinions_(opinions), opinion_of_(opinion_of), spread_(spread), sums_(sums) {}

    void blend(NodeId root) {
        const Sums& all = pull(root);
        push(root, Rgb(0.0F), kEven * all.by_links / std::max(all.area, 1e-30F));
    }

  private:
    const Sums& pull(NodeId id) {
        const Node& node = hierarchy_[id];
        Sums& all = sums_[id];
        if (node.child_count == 0) {
            all = sums_of(opinions_[opinion_of_[id]], node.area);
            return all;
        }
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            add(all, pull(child));
        }
        return all;
    }

    void push(NodeId id, Rgb inherited, float even) {
        const Node& node = hierarchy_[id];
        const Judgement judgement =
            judge(sums_[id], inherited, even, node.depth == 0 ? spread_.whole : spread_.part, spread_.ray);
        if (node.child_count == 0) {
            settle(opinions_[opinion_of_[id]], node.area, judgement);
            return;
        }
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            push(child, judgement.share, even);
        }
    }

    const Hierarchy& hierarchy_;
    std::span<Opinions> opinions_;
    std::span<const std::uint32_t> opinion_of_;  // per node
    Trust spread_;
    std::vector<Sums>& sums_;
};

}  // namespace

ElementOpinions::ElementOpinions(const Hierarchy& hierarchy, std::span<const NodeId> leaves) : hierarchy_(&hierarchy) {
    opinion_of_.assign(hierarchy.nodes().size(), kNone);
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        opinion_of_[leaves[i]] = static_cast<std::uint32_t>(i);
    }
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (hierarchy[id].kind == NodeKind::kElement && hierarchy[id].depth == 0) {
            roots_.push_back(id);
        }
    }
}

void ElementOpinions::blend(std::span<Opinions> opinions, const Trust& trust, const Control& control) const {
    std::vector<Sums> sums(hierarchy_->nodes().size());
    Blender blender(*hierarchy_, opinions, opinion_of_, trust, sums);
    parallel_for(roots_.size(), 64, control, [&](std::size_t i) { blender.blend(roots_[i]); });
}

}  // namespace gg
