#include "radiosity/lighting.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/control.h"
#include "core/parallel.h"
#include "radiosity/quarter.h"

namespace gg {

namespace {

constexpr std::size_t kBlock = 64;

// body(node, child) on the way from an element to its leaf at a point; returns the leaf and the place
// in it, as weights of its corners 1 and 2.
template <typename Body>
std::pair<NodeId, Vec2> descend(const std::vector<Node>& nodes, NodeId element, Vec3 point, const Body& body) {
    const auto& c = nodes[element].corner;
    const Vec3 e1 = c[1] - c[0], e2 = c[2] - c[0], d = point - c[0];
    const Vec3 normal = cross(e1, e2);
    const float scale = 1 / std::max(length_squared(normal), 1e-30F);
    Vec2 place = scale * Vec2(dot(cross(d, e2), normal), dot(cross(e1, d), normal));
    NodeId id = element;
    while (nodes[id].child_count > 0) {
        const int quarter = quarter_at(place);
        place = place_in_quarter(place, quarter);
        const NodeId child = nodes[id].first_child + quarter;
        body(nodes[id], nodes[child]);
        id = child;
    }
    return {id, place};
}

}  // namespace

Lighting::Lighting(const Hierarchy& hierarchy) : hierarchy_(hierarchy) {}

void Lighting::grow(const Control& control) {
    const auto& nodes = hierarchy_.nodes();
    const std::size_t old = radiosity_.size();
    radiosity_.resize(nodes.size());
    irradiance_.resize(nodes.size(), Rgb(0.0F));
    spread_.resize(nodes.size());
    area_.resize(nodes.size());
    slot_.resize(nodes.size(), kNone);
    leaf_slot_.resize(nodes.size(), kNone);
    known_.resize(nodes.size());
    for (std::size_t id = old; id < nodes.size(); ++id) {
        const Node& node = nodes[id];
        if (node.parent != kNone && is_surface(node)) {
            irradiance_[id] = irradiance_[node.parent];
        }
        radiosity_[id] = node.emission + node.reflectance * irradiance_[id];
        area_[id] = node.area;
        if (is_cluster(node)) {
            slot_[id] = static_cast<std::uint32_t>(received_.size());
            received_.emplace_back();
            intensity_.emplace_back();
        } else if (node.kind == NodeKind::kElement) {
            slot_[id] = static_cast<std::uint32_t>(corners_.size());
            corners_.push_back({irradiance_[id], irradiance_[id], irradiance_[id]});
            near_.emplace_back(0.0F);
        }
    }
    facing_.resize(received_.size());
    control.check_cancel();
}

// Of clusters that receive.
void Lighting::find_facing_areas(const Control& control) {
    std::vector<NodeId> missing;
    for (NodeId id = 0; id < hierarchy_.nodes().size(); ++id) {
        const bool receives =
            leaf_slot_[id] != kNone || (id + 1 < link_begin_.size() && link_begin_[id] < link_begin_[id + 1]);
        if (is_cluster(hierarchy_[id]) && receives && !(facing_[slot_[id]].area[0] > 0)) {
            missing.push_back(id);
        }
    }
    parallel_for(missing.size(), 1, control,
                 [&](std::size_t i) { facing_[slot_[missing[i]]] = facing_area(hierarchy_, hierarchy_[missing[i]]); });
}

// Few samples see too much of the bright middle of an element, and in a closed room that adds up over the reflections.
// Half of the difference to what an object's elements would send when even is taken back; not all, since what is bright
// may in truth see more.
void Lighting::balance_brightness() {
    const auto& nodes = hierarchy_.nodes();
    balance_.assign(hierarchy_.scene().instances.size(), 1.0F);
    std::vector<double> even(balance_.size()), uneven(balance_.size());
    for (const Link& link : links_) {
        const Node& from = nodes[link.sender];
        if (from.kind == NodeKind::kElement) {
            const double facing = nodes[link.receiver].kind == NodeKind::kElement ? 1 : 0.25;
            const double power = facing * nodes[link.receiver].area * link.form_factor * link.visibility *
                                 luminance(radiosity_[link.sender]);
            even[from.instance] += power;
            uneven[from.instance] += power * link.brightness;
        }
    }
    for (std::size_t i = 0; i < balance_.size(); ++i) {
        balance_[i] = uneven[i] > 0 ? static_cast<float>(std::sqrt(even[i] / uneven[i])) : 1.0F;
    }
}

void Lighting::set_links(Links& links, const Control& control) {
    links_ = links.all;
    hits_ = links.hits;
    balance_brightness();
    link_begin_.assign(hierarchy_.nodes().size() + 1, 0);
    for (const Link& link : links.all) {
        ++link_begin_[link.receiver + 1];
    }
    for (std::size_t i = 1; i < link_begin_.size(); ++i) {
        link_begin_[i] += link_begin_[i - 1];
    }
    link_order_.resize(links.all.size());
    std::vector<std::uint32_t> next(link_begin_.begin(), link_begin_.end() - 1);
    for (std::uint32_t i = 0; i < links.all.size(); ++i) {
        link_order_[next[links.all[i].receiver]++] = i;
    }
    parallel_for(links.all.size(), 1024, control, [&](std::size_t i) {
        const Link& link = links.all[i];
        for (std::uint32_t h = link.first_hit; h < link.first_hit + link.hit_count; ++h) {
            links.hits[h].leaf = leaf_at(link.sender, links.hits[h]);
        }
    });
}

void Lighting::make_leaf_clusters(const Control& control) {
    const auto& nodes = hierarchy_.nodes();
    std::vector<NodeId> missing;
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (!is_cluster(nodes[id]) || (id == kGeometryRoot && !hierarchy_.has_geometry())) {
            continue;
        }
        if (nodes[id].child_count == 0 && leaf_slot_[id] == kNone) {
            leaf_slot_[id] = static_cast<std::uint32_t>(leaves_.size() + missing.size());
            missing.push_back(id);
        } else if (nodes[id].child_count > 0 && leaf_slot_[id] != kNone) {
            leaves_[leaf_slot_[id]] = {};
            leaf_slot_[id] = kNone;
        }
    }
    const std::size_t first = leaves_.size();
    leaves_.resize(first + missing.size());
    parallel_for(missing.size(), 4, control, [&](std::size_t i) {
        leaves_[first + i] = make_leaf_cluster(hierarchy_, nodes[missing[i]]);
        area_[missing[i]] = leaves_[first + i].area;
    });
}

Rgb Lighting::on_face(const Received& light, const Exposure& face, bool back, Vec3 normal) {
    const float exposure = back ? face.back : face.front;
    const float shelter = back ? face.back_shelter : face.front_shelter;
    return glm::max(exposure * evaluate(light.far, normal) + shelter * evaluate(light.near, normal), Rgb(0.0F));
}

Rgb Lighting::irradiance_of_face(NodeId cluster, const Exposure& exposure, bool back, Vec3 normal) const {
    return on_face(received_[slot_[cluster]], exposure, back, normal);
}

PlaceOnElement Lighting::at(NodeId element, Vec3 point) const {
    const auto& nodes = hierarchy_.nodes();
    PlaceOnElement result;
    const auto [id, place] = descend(nodes, element, point, [&](const Node& node, const Node& child) {
        if (node.patch != kNone && child.patch == kNone) {
            result.exposure = child.weight;
        }
    });
    const std::array<Rgb, 3>& corners = corners_[slot_[id]];
    const Rgb irradiance = (1 - place.x - place.y) * corners[0] + place.x * corners[1] + place.y * corners[2];
    result.radiosity = nodes[id].emission + nodes[id].reflectance * glm::max(irradiance, Rgb(0.0F));
    return result;
}

Rgb Lighting::mean_around(NodeId element, Vec3 point, int levels) const {
    NodeId part = element;
    int below = 0;
    const auto& nodes = hierarchy_.nodes();
    descend(nodes, element, point, [&](const Node& node, const Node& child) {
        if (below++ < levels) {
            part = static_cast<NodeId>(&child - nodes.data());
        }
        (void)node;
    });
    return below < levels ? at(element, point).radiosity : radiosity_[part];
}

NodeId Lighting::leaf_element_at(NodeId element, Vec3 point) const {
    return descend(hierarchy_.nodes(), element, point, [](const Node&, const Node&) {}).first;
}

void Lighting::set_faces_of(NodeId leaf_cluster, Rgb arriving, Rgb reflected, const DirectionalForm& intensity) {
    const LeafCluster& leaf = leaves_[leaf_slot_[leaf_cluster]];
    const auto inverse_area = static_cast<float>(1.0 / std::max(leaf.area, 1e-30));
    known_[leaf_cluster] = true;
    intensity_[slot_[leaf_cluster]] = leaf.emission + intensity;
    radiosity_[leaf_cluster] = (leaf.emitted_power + reflected) * inverse_area;
    irradiance_[leaf_cluster] = arriving * inverse_area;
    spread_[leaf_cluster] = 0;
}

double Lighting::total_reflected_power() const {
    double total = 0;
    const auto& nodes = hierarchy_.nodes();
    for (NodeId id = 0; id < nodes.size(); ++id) {
        if (is_surface(nodes[id]) && nodes[id].child_count == 0) {
            total += area_[id] * static_cast<double>(luminance(nodes[id].reflectance * irradiance_[id]));
        }
    }
    return total;
}

void Lighting::clear(const Control& control) {
    std::fill(irradiance_.begin(), irradiance_.end(), Rgb(0.0F));
    std::fill(corners_.begin(), corners_.end(), std::array<Rgb, 3>{});
    std::fill(near_.begin(), near_.end(), Rgb(0.0F));
    std::fill(received_.begin(), received_.end(), Received{});
    if (!hierarchy_.has_geometry()) {
        return;
    }
    make_leaf_clusters(control);
    for (auto id = static_cast<NodeId>(hierarchy_.nodes().size()); id-- > 0;) {
        pull(id);
    }
    reflected_power_ = 0;
}

void Lighting::set_irradiance(NodeId leaf_element, Rgb mean) {
    std::array<Rgb, 3>& corners = corners_[slot_[leaf_element]];
    const Rgb before = (corners[0] + corners[1] + corners[2]) / 3.0F;
    for (Rgb& corner : corners) {
        for (int c = 0; c < 3; ++c) {
            corner[c] = before[c] > 1e-6F ? std::max(corner[c], 0.0F) * (mean[c] / before[c]) : mean[c];
        }
    }
    irradiance_[leaf_element] = mean;
}

void Lighting::pull(const Control& control) {
    const auto generations = hierarchy_.generations();
    for (std::size_t g = generations.size() - 1; g-- > 0;) {
        parallel_for(generations[g + 1] - generations[g], kBlock, control,
                     [&](std::size_t i) { pull(static_cast<NodeId>(generations[g] + i)); });
    }
    reflected_power_ = total_reflected_power();
}

int Lighting::settle(int most, double converged, const Control& control) {
    constexpr int kPatience = 10;  // iterations until steps must shrink
    constexpr float kDimming = 0.9F;
    double before = kInfinity;
    for (int count = 1; count <= most; ++count) {
        const double step = iterate(control);
        if (step <= converged) {
            return count;
        }
        if (count > kPatience && !(step < before)) {
            gain_ *= kDimming;
        }
        before = step;
    }
    return most;
}

double Lighting::iterate(const Control& control) {
    if (!hierarchy_.has_geometry()) {
        return 0;
    }
    make_leaf_clusters(control);
    find_facing_areas(control);
    shining_ = received_;
    const auto generations = hierarchy_.generations();
    const auto count = hierarchy_.nodes().size();
    parallel_for(count, kBlock, control, [&](std::size_t id) {
        if (is_surface(hierarchy_[static_cast<NodeId>(id)])) {
            gather(static_cast<NodeId>(id));
        }
    });
    for (std::size_t g = 0; g + 1 < generations.size(); ++g) {
        parallel_for(generations[g + 1] - generations[g], kBlock, control,
                     [&](std::size_t i) { push(static_cast<NodeId>(generations[g] + i)); });
    }
    const double before = reflected_power_;
    pull(control);
    return std::abs(reflected_power_ - before) / std::max(reflected_power_, 1e-300);
}

std::size_t Lighting::bytes() const {
    return radiosity_.capacity() * (2 * sizeof(Rgb) + sizeof(float) + sizeof(double) + 2 * sizeof(std::uint32_t)) +
           received_.capacity() * (2 * sizeof(Received) + sizeof(DirectionalForm)) +
           leaves_.capacity() * sizeof(LeafCluster) + link_order_.capacity() * sizeof(std::uint32_t);
}

}  // namespace gg
