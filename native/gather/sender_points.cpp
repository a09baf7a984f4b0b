#include "gather/sender_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "core/random.h"
#include "transport/emitter_sampling.h"

namespace gg {

namespace {

constexpr std::uint64_t kPlaceSeed = 0x706c6163, kChoiceSeed = 0x63686f69;

// Additive recurrence of the golden ratio: distinct, and even for any prefix.
float golden(std::uint32_t index, std::uint64_t seed) {
    constexpr std::uint32_t kStep = 2654435769U;
    return static_cast<float>((static_cast<std::uint32_t>(seed) + index * kStep) >> 8) * 0x1p-24F;
}

struct Side {
    std::uint32_t instance = 0, triangle = 0;
    bool back = false;
    Rgb radiance{0.0F};
};

// The faces of a leaf cluster by what they send.
class LeafSampler {
  public:
    LeafSampler(const Solution& solution, NodeId cluster) : hierarchy_(hierarchy_of(solution)) {
        const Scene& scene = hierarchy_.scene();
        hierarchy_.for_each_triangle(hierarchy_[cluster], [&](std::uint32_t instance, std::uint32_t triangle) {
            const float area = length(world_area_vector(scene, instance, triangle));
            for (const bool back : {false, true}) {
                if (has_side(scene.sides_of(instance, triangle), back)) {
                    const Rgb radiance = face_radiosity(solution, instance, triangle, back) / kPi;
                    total_ += static_cast<double>(area) * luminance(radiance);
                    sides_.push_back({instance, triangle, back, radiance});
                    sums_.push_back(total_);
                }
            }
        });
    }

    [[nodiscard]] double total() const { return total_; }

    [[nodiscard]] FacePoint point(std::uint32_t index, std::uint64_t seed) const {
        const Sequence4 places(hash64(seed, kPlaceSeed));
        const double target = total_ * static_cast<double>(golden(index, hash64(seed, kChoiceSeed)));
        const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, target);
        const Side& side = sides_[static_cast<std::size_t>(found - sums_.begin())];
        const Scene& scene = hierarchy_.scene();
        const auto c = world_triangle(scene, side.instance, side.triangle);
        const Vec3 w = square_to_triangle(places(index, 0), places(index, 1));
        const Vec3 front = normalize_or_zero(world_area_vector(scene, side.instance, side.triangle));
        const float share = static_cast<float>(total_ / kClusterPoints) / std::max(luminance(side.radiance), 1e-30F);
        return {w.x * c[0] + w.y * c[1] + w.z * c[2], side.back ? -front : front, share * side.radiance};
    }

  private:
    const Hierarchy& hierarchy_;
    std::vector<Side> sides_;
    std::vector<double> sums_;
    double total_ = 0;
};

}  // namespace

void ClusterFaces::set(std::uint32_t i, const FacePoint& point) {
    x[i] = point.position.x;
    y[i] = point.position.y;
    z[i] = point.position.z;
    normal_x[i] = point.normal.x;
    normal_y[i] = point.normal.y;
    normal_z[i] = point.normal.z;
    red[i] = point.power.x;
    green[i] = point.power.y;
    blue[i] = point.power.z;
}

float ClusterFaces::power() const {
    float sum = 0;
    for (std::uint32_t i = 0; i < kClusterPoints; ++i) {
        sum += power(i);
    }
    return sum;
}

ClusterPoints::ClusterPoints(const Solution& solution, const Control& control) {
    const Hierarchy& hierarchy = hierarchy_of(solution);
    if (!hierarchy.has_geometry()) {
        return;
    }
    index_.assign(hierarchy.nodes().size(), kNone);
    std::vector<NodeId> leaves, inner;
    std::uint32_t count = 0;
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (is_cluster(hierarchy[id])) {
            (hierarchy[id].child_count == 0 ? leaves : inner).push_back(id);
            index_[id] = count++;
        }
    }
    faces_.resize(count);
    parallel_for(leaves.size(), 1, control, [&](std::size_t i) {
        const LeafSampler sampler(solution, leaves[i]);
        for (std::uint32_t k = 0; k < kClusterPoints && sampler.total() > 0; ++k) {
            faces_[index_[leaves[i]]].set(k, sampler.point(k, hierarchy[leaves[i]].stable_id));
        }
    });
    // Children come after their parents.
    for (auto id = inner.rbegin(); id != inner.rend(); ++id) {
        const Node& node = hierarchy[*id];
        std::vector<NodeId> children;
        std::vector<float> sums;
        float total = 0;
        for (NodeId child = node.first_child; child < node.first_child + node.child_count; ++child) {
            const float light = is_cluster(hierarchy[child])
                                    ? of(child).power()
                                    : hierarchy[child].area * luminance(radiosity_of(solution, child)) / kPi;
            total += light;
            children.push_back(child);
            sums.push_back(total);
        }
        std::vector<std::uint32_t> taken(children.size());
        for (std::uint32_t k = 0; k < kClusterPoints && total > 0; ++k) {
            const float target = total * golden(k, hash64(node.stable_id, kChoiceSeed));
            const auto found =
                static_cast<std::size_t>(std::upper_bound(sums.begin(), sums.end() - 1, target) - sums.begin());
            const Node& child = hierarchy[children[found]];
            const std::uint32_t index = taken[found]++;
            FacePoint point;
            if (is_cluster(child)) {
                point = of(children[found])[index % kClusterPoints];
            } else {
                const Sequence4 places(hash64(child.stable_id, kPlaceSeed));
                const Vec3 w = square_to_triangle(places(index, 0), places(index, 1));
                point = {w.x * child.corner[0] + w.y * child.corner[1] + w.z * child.corner[2], child.normal,
                         radiosity_of(solution, children[found])};
            }
            point.power *= total / kClusterPoints / std::max(luminance(point.power), 1e-30F);
            faces_[index_[*id]].set(k, point);
        }
    }
}

SenderSampler::SenderSampler(const Solution& solution, NodeId sender, Vec3 x, Vec3 n)
    : solution_(solution),
      sender_(sender),
      node_(hierarchy_of(solution)[sender]),
      x_(x),
      n_(n),
      places_(hash64(node_.stable_id, kPlaceSeed)) {
    if (node_.kind == NodeKind::kLamp) {
        lamp_ = &hierarchy_of(solution).scene().lamps[node_.source];
        sampler_.emplace(*lamp_, x, n);
    }
}

SenderPlace SenderSampler::place(std::uint32_t index) const {
    SenderPlace place;
    place.u = places_(index, 0);
    place.v = places_(index, 1);
    if (lamp_ == nullptr) {
        const Vec3 w = square_to_triangle(place.u, place.v);
        place.target = w.x * node_.corner[0] + w.y * node_.corner[1] + w.z * node_.corner[2];
        // What is hidden of a floor is dark.
        place.light = luminance(radiosity_at(solution_, sender_, place.target));
    } else if (lamp_->shape == LampShape::kDistant) {
        const LampSample sample = sampler_->sample(place.u, place.v);
        place.target = sample.direction;
        place.light = luminance(sample.normal_irradiance);
    } else if (lamp_->shape == LampShape::kRectangle || lamp_->shape == LampShape::kEllipse) {
        place.target = flat_point(*lamp_, place.u, place.v);
    }
    return place;
}

SenderPoint SenderSampler::point(const SenderPlace& place) const {
    if (lamp_ == nullptr) {
        const Vec3 to = place.target - x_;
        const float square = length_squared(to) + kSoftShare * node_.area;
        return {to, false,
                place.light * std::max(0.0F, dot(n_, to)) * std::max(0.0F, -dot(node_.normal, to)) / (square * square)};
    }
    if (lamp_->shape == LampShape::kDistant) {
        return {place.target, true, place.light * std::max(0.0F, dot(n_, place.target))};
    }
    const LampSample sample = sampler_->sample(place.u, place.v);
    return {sample.point - x_, false, luminance(sample.normal_irradiance) * std::max(0.0F, dot(n_, sample.direction))};
}

float SenderSampler::facing_weight() const {
    return lamp_ != nullptr ? luminance(lamp_irradiance_vector(*lamp_, x_).irradiance)
                            : luminance(radiosity_of(solution_, sender_)) /
                                  (length_squared(node_.center - x_) + node_.radius * node_.radius);
}

std::span<const std::uint32_t> SenderSampler::in_blocks(std::uint32_t count, std::vector<std::uint32_t>& order) const {
    constexpr std::uint32_t kBlocks = 16;
    const auto block = [&](std::uint32_t index) {
        const auto u = static_cast<std::uint32_t>(4 * places_(index, 0)),
                   v = static_cast<std::uint32_t>(4 * places_(index, 1));
        return (u & 1) | (v & 1) << 1 | (u & 2) << 1 | (v & 2) << 2;
    };
    std::array<std::uint32_t, kBlocks + 1> begin{};
    for (std::uint32_t i = 0; i < count; ++i) {
        ++begin[block(i) + 1];
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    order.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        order[begin[block(i)]++] = i;
    }
    return order;
}

}  // namespace gg
