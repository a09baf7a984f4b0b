#include "radiosity/source_guide.h"

#include <algorithm>
#include <cmath>

namespace gg {

namespace {

constexpr float kMuchOfSky = 0.25F;
constexpr float kHidden = 0.05F;    // visibility that is allowed for where a link's rays met none
constexpr float kHiddenSky = 0.5F;  // the same of the sky: links of whole walls do not know its windows

}  // namespace

Sources::Choice Sources::choose(std::size_t kind, float u) const {
    const auto first = sums.begin() + static_cast<std::ptrdiff_t>(begin[kind]);
    const auto last = sums.begin() + static_cast<std::ptrdiff_t>(begin[kind + 1]);
    const auto found = std::upper_bound(first, last - 1, u * *(last - 1));
    const auto i = static_cast<std::size_t>(found - sums.begin());
    return {nodes[i], chance(kind, i)};
}

SourceGuide::SourceGuide(const Hierarchy& hierarchy, std::span<const Link> links) : hierarchy_(&hierarchy) {
    begin_.assign(hierarchy.nodes().size() + 1, 0);
    const auto is_source = [&](const Link& link) { return !is_surface(hierarchy[link.sender]); };
    for (const Link& link : links) {
        begin_[link.receiver + 1] += is_source(link) ? 1 : 0;
    }
    for (std::size_t i = 1; i < begin_.size(); ++i) {
        begin_[i] += begin_[i - 1];
    }
    arrows_.resize(begin_.back());
    std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
    for (const Link& link : links) {
        if (is_source(link)) {
            arrows_[next[link.receiver]++] = {link.sender, link.visibility};
        }
    }
    find_emitters();
}

void SourceGuide::find_emitters() {
    constexpr std::size_t kMost = 256;     // every place looks at all of them
    constexpr double kLargest = 1.0 / 16;  // share of all area
    double area = 0, emitting = 0;
    for (NodeId id = 0; id < hierarchy_->nodes().size(); ++id) {
        const Node& node = (*hierarchy_)[id];
        if (is_surface(node) && node.child_count == 0) {
            area += node.area;
        }
        if (node.kind == NodeKind::kElement && node.depth == 0 && luminance(node.emission) > 0) {
            emitters_.push_back(id);
            emitting += node.area;
        }
    }
    if (emitters_.size() > kMost || emitting > kLargest * area) {
        emitters_.clear();
    }
}

// Luminance of the irradiance of a sphere of the source's size, at the nearest point of the place.
float SourceGuide::bound(const Node& source, const Neighbourhood& place) const {
    const float light = luminance(source.emission);
    if (source.kind == NodeKind::kSky) {
        constexpr float kTall = 2.5F;  // cells near the horizon are longer than their radius
        const float cosine = dot(place.normal, source.center) + std::min(kTall * source.radius, 1.0F);
        return light * source.area / kPi * std::clamp(cosine, 0.0F, 1.0F);
    }
    const bool is_lamp = source.kind == NodeKind::kLamp;
    const LampShape shape = is_lamp ? hierarchy_->scene().lamps[source.source].shape : LampShape::kRectangle;
    if (shape == LampShape::kDistant) {
        return light * std::max(0.0F, dot(place.normal, source.center));
    }
    const Vec3 towards = source.center - place.middle;
    if (!is_lamp && dot(source.normal, towards) > place.radius) {
        return 0;  // all behind it
    }
    const float distance = length(towards), near = std::max(distance - place.radius, 0.0F);
    const float reach = source.radius + place.radius;
    const float cosine = (dot(place.normal, towards) + reach) / (distance + reach);
    const float size = source.radius * source.radius;
    const float factor = shape == LampShape::kPoint
                             ? 1 / std::max(near * near, 0.01F * place.radius * place.radius + 1e-12F)
                             : size / std::max(near * near, size);
    return cosine > 0 ? light * factor * cosine : 0.0F;
}

void SourceGuide::list(const Neighbourhood& place, Sources& out) const {
    out.nodes.clear();
    out.sums.clear();
    float total = 0;
    const auto add = [&](NodeId source, float brings) {
        if (brings > 0) {
            total += brings;
            out.nodes.push_back(source);
            out.sums.push_back(total);
        }
    };
    const auto begin = [&](std::size_t kind) {
        out.begin[kind] = out.nodes.size();
        total = 0;
    };
    const auto each_arrow = [&](bool of_sky, const auto& body) {
        for (NodeId id = place.node; id != kNone; id = (*hierarchy_)[id].parent) {
            if (id + 1 >= begin_.size()) {
                continue;  // opened since
            }
            for (std::uint32_t i = begin_[id]; i < begin_[id + 1]; ++i) {
                const Node& source = (*hierarchy_)[arrows_[i].sender];
                if ((source.kind == NodeKind::kSky) == of_sky) {
                    body(arrows_[i], bound(source, place));
                }
            }
        }
    };
    begin(kLocalSources);
    each_arrow(false, [&](const Arrow& arrow, float most) { add(arrow.sender, (arrow.visibility + kHidden) * most); });
    for (const NodeId emitter : emitters_) {
        add(emitter, bound((*hierarchy_)[emitter], place));
    }
    begin(kSkySources);
    float sky = 0, seen = 0;
    each_arrow(true, [&](const Arrow& arrow, float most) {
        sky += most;
        seen += arrow.visibility * most;
    });
    if (seen < kMuchOfSky * sky) {
        each_arrow(true,
                   [&](const Arrow& arrow, float most) { add(arrow.sender, (arrow.visibility + kHiddenSky) * most); });
    }
    begin(Sources::kKinds);
}

}  // namespace gg
