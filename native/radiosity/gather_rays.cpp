// GatheredLight: the rays of its places.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/random.h"
#include "radiosity/gathered_light.h"
#include "radiosity/lighting.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"
#include "transport/form_factor.h"

namespace gg {

namespace {

constexpr std::uint32_t kRaysPerLampRay = 2;
constexpr int kCandidates = 4;
constexpr float kAlmost = 0.9999F;  // of the way to a source
constexpr float kEvenShare = 0.1F;  // of the lamps' rays: spread over all lamps, whatever the middle point gets

}  // namespace

// Places whose rays are traced together.
class GatheredLight::Block {
  public:
    Block(GatheredLight& owner, const ElementTable& elements, const Lighting& lighting, const RayTracer& tracer)
        : owner_(owner), elements_(elements), lighting_(lighting), tracer_(tracer), scene_(owner.hierarchy_->scene()) {}

    void gather(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            add_points(i);
            add_lamp_rays(i);
        }
        hits_.resize(rays_.size());
        tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
        blocked_.resize(shadow_rays_.size());
        tracer_.occluded(shadow_rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
        for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
            if (!blocked_[i]) {
                owner_.constant_[shadow_places_[i]] += shadow_light_[i];
            }
        }
        std::size_t ray = 0;
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t k = 0; k < owner_.places_[i].rays; ++k, ++ray) {
                arrive(i, owner_.places_[i].first_ray + k, rays_[ray], hits_[ray]);
            }
        }
    }

  private:
    static std::uint32_t lamp_rays_of(const Place& place) { return std::max(1U, place.rays / kRaysPerLampRay); }

    struct Point {
        Vec3 position{0.0F}, normal{0.0F};
    };

    // Points of a place, evenly by area, each with a ray into its hemisphere.
    void add_points(std::size_t i) {
        points_.clear();
        if (owner_.places_[i].element == kNone) {
            add_group_points(owner_.places_[i]);
        } else {
            add_element_points(owner_.places_[i]);
        }
    }

    void add_group_points(const Place& place) {
        const std::span<const FaceSide> sides = owner_.groups_of(place.instance)[place.group];
        ends_.clear();
        float area = 0;
        for (const FaceSide side : sides) {
            area += length(world_area_vector(scene_, place.instance, side.triangle));
            ends_.push_back(area);
        }
        const Sequence6 sequence(seed_of(place));
        for (std::uint32_t k = 0; k < place.rays; ++k) {
            const float target = area * (static_cast<float>(k) + 0.5F) / static_cast<float>(place.rays);
            const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, target);
            const FaceSide side = sides[static_cast<std::size_t>(found - ends_.begin())];
            const Vec3 vector = world_area_vector(scene_, place.instance, side.triangle);
            add_point(world_triangle(scene_, place.instance, side.triangle),
                      normalize_or_zero(side.back ? -vector : vector), sequence, k);
        }
    }

    void add_element_points(const Place& place) {
        const Node& node = (*owner_.hierarchy_)[place.element];
        const Sequence6 sequence(seed_of(place));
        for (std::uint32_t k = 0; k < place.rays; ++k) {
            add_point(node.corner, node.normal, sequence, k);
        }
    }

    void add_point(const std::array<Vec3, 3>& c, Vec3 normal, const Sequence6& sequence, std::uint32_t k) {
        const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
        const float size = std::max({length(c[1] - c[0]), length(c[2] - c[0]), length(c[2] - c[1])});
        const Vec3 x = w.x * c[0] + w.y * c[1] + w.z * c[2];
        points_.push_back({offset_origin(x, normal, size), normal});
        const Vec3 direction = square_to_cosine_hemisphere(sequence(k, 2), sequence(k, 3));
        rays_.push_back({points_.back().position, Frame(normal).to_world(direction), 0, kInfinity});
    }

    std::uint64_t seed_of(const Place& place) const {
        return place.element == kNone ? hash64(scene_.instances[place.instance].stable_id,
                                               owner_.groups_of(place.instance)[place.group].front().triangle)
                                      : (*owner_.hierarchy_)[place.element].stable_id;
    }

    // Shadow rays are dealt out to lamps and emitters by what they would bring to the middle of the place. Elements
    // know sources close by from their links, better than from a few points.
    void add_lamp_rays(std::size_t i) {
        const std::vector<Lamp>& lamps = scene_.lamps;
        const Place& place = owner_.places_[i];
        const bool of_element = place.element != kNone;
        const Point& middle = points_[points_.size() / 2];
        float total = 0;
        ends_.clear();
        for (std::size_t lamp = 0; lamp < lamps.size(); ++lamp) {
            if (!of_element || lamps[lamp].shape == LampShape::kDistant) {
                total += about_from(owner_.hierarchy_->infinite_and_lamps()[lamp], lamps[lamp].shape, middle);
            }
            ends_.push_back(total);
        }
        for (const NodeId emitter : owner_.emitters_) {
            total += of_element ? 0 : about_from(emitter, LampShape::kRectangle, middle);
            ends_.push_back(total);
        }
        if (ends_.empty() || (of_element && !(total > 0))) {
            return;
        }
        const auto sources = static_cast<float>(ends_.size());
        const float even = of_element ? 0 : total > 0 ? kEvenShare : 1.0F;
        const float unit = 1 / std::max(total, 1e-30F);
        for (std::size_t j = 0; j < ends_.size(); ++j) {
            ends_[j] = (1 - even) * unit * ends_[j] + even * static_cast<float>(j + 1) / sources;
        }
        const Sequence6 sequence(seed_of(place));
        const float shift = sequence(0, 4);
        const std::uint32_t count = lamp_rays_of(place);
        for (std::uint32_t k = 0; k < count; ++k) {
            const float u = (static_cast<float>(k) + shift) / static_cast<float>(count);
            const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, u);
            const auto source = static_cast<std::size_t>(found - ends_.begin());
            const float chance = ends_[source] - (source > 0 ? ends_[source - 1] : 0);
            const Point& x = points_[k * points_.size() / count];
            if (!(chance > 0)) {
                continue;
            }
            const float share = 1 / (chance * static_cast<float>(count));
            const Vec3 sample(sequence(k, 0), sequence(k, 5), sequence(k, 3));
            if (source < lamps.size()) {
                add_lamp_ray(i, x, lamps[source], sample, share);
            } else {
                add_emitter_ray(i, x, owner_.emitters_[source - lamps.size()], sample, share);
            }
        }
    }

    // What a source brings, to some factor: luminance of the irradiance of a sphere of its size, if any is above the
    // horizon.
    float about_from(NodeId source, LampShape shape, const Point& x) const {
        const Node& node = (*owner_.hierarchy_)[source];
        const float light = luminance(node.emission);
        if (shape == LampShape::kDistant) {
            return light * std::max(0.0F, dot(x.normal, node.center));
        }
        const Vec3 towards = node.center - x.position;
        const float square = length_squared(towards), size = node.radius * node.radius;
        const float distance = std::sqrt(square);
        const float cosine = (dot(x.normal, towards) + node.radius) / (distance + node.radius);
        const float factor = shape == LampShape::kPoint ? 1 / square : size / std::max(square, size);
        return cosine > 0 ? light * factor * cosine : 0.0F;
    }

    // The irradiance is exact; visibility is that of one point of the source, chosen from a few by what they bring. A
    // point next to the source would else now and then bring a multiple of what all others do.
    void add_lamp_ray(std::size_t i, const Point& x, const Lamp& lamp, Vec3 sample, float share) {
        std::array<LampSample, kCandidates> candidates;
        std::array<float, kCandidates> weights{};
        for (int c = 0; c < kCandidates; ++c) {
            const Vec2 uv = candidate(sample, c);
            candidates[c] = sample_lamp(lamp, x.position, uv.x, uv.y);
            weights[c] =
                std::max(0.0F, dot(x.normal, candidates[c].direction)) * luminance(candidates[c].normal_irradiance);
        }
        const int chosen = choose(weights, sample.z);
        if (weights[chosen] > 0) {
            add_shadow_ray(i, {x.position, candidates[chosen].direction, 0, kAlmost * candidates[chosen].distance},
                           share * lamp_irradiance(lamp, x.position, x.normal));
        }
    }

    void add_emitter_ray(std::size_t i, const Point& x, NodeId emitter, Vec3 sample, float share) {
        const Node& node = (*owner_.hierarchy_)[emitter];
        const auto& corner = node.corner;
        std::array<Vec3, kCandidates> towards;
        std::array<float, kCandidates> weights{};
        for (int c = 0; c < kCandidates; ++c) {
            const Vec2 uv = candidate(sample, c);
            const Vec3 w = square_to_triangle(uv.x, uv.y);
            towards[c] = w.x * corner[0] + w.y * corner[1] + w.z * corner[2] - x.position;
            const float square = std::max(length_squared(towards[c]), 1e-30F);
            weights[c] = std::max(0.0F, dot(towards[c], x.normal)) * std::max(0.0F, -dot(towards[c], node.normal)) /
                         (square * square);
        }
        const int chosen = choose(weights, sample.z);
        if (weights[chosen] > 0) {
            add_shadow_ray(i, {x.position, towards[chosen], 0, kAlmost}, share * irradiance_from(emitter, x));
        }
    }

    // One in each quarter of the unit square.
    static Vec2 candidate(Vec3 sample, int c) {
        return {0.5F * (sample.x + static_cast<float>(c % 2)), 0.5F * (sample.y + static_cast<float>(c / 2))};
    }

    static int choose(const std::array<float, kCandidates>& weights, float u) {
        float target = u * (weights[0] + weights[1] + weights[2] + weights[3]);
        int chosen = 0;
        while (chosen < kCandidates - 1 && !(target < weights[chosen])) {
            target -= weights[chosen++];
        }
        return chosen;
    }

    void add_shadow_ray(std::size_t i, const Ray& ray, Rgb light) {
        shadow_rays_.push_back(ray);
        shadow_light_.push_back(light);
        shadow_places_.push_back(i);
    }

    Rgb irradiance_from(NodeId emitter, const Point& x) const {
        const Node& node = (*owner_.hierarchy_)[emitter];
        const auto& c = node.corner;
        if (!(dot(x.position - c[0], node.normal) > 0)) {
            return Rgb(0.0F);
        }
        return node.emission * point_to_triangle(x.position, x.normal, c[0], c[1], c[2]);
    }

    void arrive(std::size_t place, std::size_t slot, const Ray& ray, const Hit& hit) {
        const float share = 1 / static_cast<float>(owner_.places_[place].rays);
        Rgb& arriving = owner_.constant_[place];
        const bool of_element = owner_.places_[place].element != kNone;
        if (hit.missed()) {
            arriving += share * kPi * scene_.world;
            return;
        }
        const bool back = dot(world_area_vector(scene_, hit.instance, hit.triangle), ray.direction) > 0;
        const NodeId element = elements_.of(hit.instance, hit.triangle, back);
        if (element != kNone) {
            const Vec3 y = ray.origin + hit.distance * ray.direction;
            owner_.hits_[slot] = lighting_.leaf_element_at(element, y) | kElementBit;
            return;
        }
        const std::uint32_t other = owner_.groups_of(hit.instance).of(hit.triangle, back);
        if (other == kNone || owner_.first_[hit.instance] == kNone) {
            return;  // a side that no light reaches
        }
        owner_.hits_[slot] = owner_.first_[hit.instance] + other;
        const FaceColors& colors = owner_.colors_of(hit.instance);
        if (!colors.emission.empty() && !of_element) {
            owner_.glow_[place] += share * kPi * colors.emission[hit.triangle];
        }
    }

    GatheredLight& owner_;
    const ElementTable& elements_;
    const Lighting& lighting_;
    const RayTracer& tracer_;
    const Scene& scene_;
    std::vector<Point> points_;
    std::vector<float> ends_;
    std::vector<Ray> rays_, shadow_rays_;
    std::vector<Hit> hits_;
    std::vector<std::uint8_t> blocked_;
    std::vector<Rgb> shadow_light_;
    std::vector<std::size_t> shadow_places_;
};

void GatheredLight::trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
                          const RayTracer& tracer) {
    Block(*this, elements, lighting, tracer).gather(begin, end);
}

}  // namespace gg
