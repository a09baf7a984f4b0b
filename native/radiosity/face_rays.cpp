// FaceLight: the rays of its groups.
#include <algorithm>
#include <cmath>
#include <span>

#include "core/random.h"
#include "radiosity/face_light.h"
#include "radiosity/lighting.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"

namespace gg {

namespace {

constexpr std::uint32_t kRaysPerLampRay = 3;
constexpr float kEvenShare = 0.1F;  // of the lamps' rays: spread over all lamps, whatever the middle point gets

}  // namespace

// Groups whose rays are traced together.
class FaceLight::Block {
  public:
    Block(FaceLight& owner, const ElementTable& elements, const Lighting& lighting, const RayTracer& tracer)
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
                owner_.constant_[shadow_groups_[i]] += shadow_light_[i];
            }
        }
        std::size_t ray = 0;
        for (std::size_t i = begin; i < end; ++i) {
            for (std::size_t k = 0; k < owner_.groups_[i].rays; ++k, ++ray) {
                arrive(i, owner_.groups_[i].first_ray + k, rays_[ray], hits_[ray]);
            }
        }
    }

  private:
    struct Point {
        Vec3 position{0.0F}, normal{0.0F};
        float size = 0;  // of its triangle, m
    };

    // Points of a group, evenly by area, each with a ray into its hemisphere.
    void add_points(std::size_t i) {
        const auto [instance, group, area_of_group, rays, first] = owner_.groups_[i];
        const std::span<const FaceSide> sides = owner_.groups_of(instance)[group];
        ends_.clear();
        float area = 0;
        for (const FaceSide side : sides) {
            area += length(world_area_vector(scene_, instance, side.triangle));
            ends_.push_back(area);
        }
        const Sequence6 sequence(hash64(scene_.instances[instance].stable_id, sides.front().triangle));
        points_.clear();
        for (std::uint32_t k = 0; k < rays; ++k) {
            const float target = area * (static_cast<float>(k) + 0.5F) / static_cast<float>(rays);
            const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, target);
            const FaceSide side = sides[static_cast<std::size_t>(found - ends_.begin())];
            const auto c = world_triangle(scene_, instance, side.triangle);
            const Vec3 vector = world_area_vector(scene_, instance, side.triangle);
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
            const Vec3 normal = normalize_or_zero(side.back ? -vector : vector);
            const float size = std::max({length(c[1] - c[0]), length(c[2] - c[0]), length(c[2] - c[1])});
            const Vec3 x = w.x * c[0] + w.y * c[1] + w.z * c[2];
            points_.push_back({offset_origin(x, normal, size), normal, size});
            const Vec3 direction = square_to_cosine_hemisphere(sequence(k, 2), sequence(k, 3));
            rays_.push_back({points_.back().position, Frame(normal).to_world(direction), 0, kInfinity});
        }
    }

    // Shadow rays are dealt out to the lamps by what they would bring to the middle of the group.
    void add_lamp_rays(std::size_t i) {
        const std::vector<Lamp>& lamps = scene_.lamps;
        const Point& middle = points_[points_.size() / 2];
        float total = 0;
        ends_.clear();
        for (const Lamp& lamp : lamps) {
            total += luminance(lamp_irradiance(lamp, middle.position, middle.normal));
            ends_.push_back(total);
        }
        if (lamps.empty()) {
            return;
        }
        const auto count = static_cast<float>(lamps.size());
        const float even = total > 0 ? kEvenShare : 1.0F;
        const float unit = 1 / std::max(total, 1e-30F);
        for (std::size_t j = 0; j < ends_.size(); ++j) {
            ends_[j] = (1 - even) * unit * ends_[j] + even * static_cast<float>(j + 1) / count;
        }
        const auto [instance, group, area_of_group, rays, first] = owner_.groups_[i];
        const Sequence6 sequence(
            hash64(scene_.instances[instance].stable_id, owner_.groups_of(instance)[group].front().triangle));
        const float shift = sequence(0, 4);
        const std::uint32_t lamp_rays = std::max(2U, rays / kRaysPerLampRay);
        for (std::uint32_t k = 0; k < lamp_rays; ++k) {
            const float u = (static_cast<float>(k) + shift) / static_cast<float>(lamp_rays);
            const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, u);
            const auto lamp = static_cast<std::size_t>(found - ends_.begin());
            const float chance = ends_[lamp] - (lamp > 0 ? ends_[lamp - 1] : 0);
            const Point& x = points_[k * points_.size() / lamp_rays];
            const LampSample sample = sample_lamp(lamps[lamp], x.position, sequence(k, 0), sequence(k, 5));
            const float cosine = dot(x.normal, sample.direction);
            if (cosine > 0 && luminance(sample.normal_irradiance) > 0 && chance > 0) {
                constexpr float kAlmost = 0.9999F;
                shadow_rays_.push_back({x.position, sample.direction, 0, kAlmost * sample.distance});
                shadow_light_.push_back(sample.normal_irradiance * (cosine / (chance * static_cast<float>(lamp_rays))));
                shadow_groups_.push_back(i);
            }
        }
    }

    void arrive(std::size_t group, std::size_t slot, const Ray& ray, const Hit& hit) {
        const float share = 1 / static_cast<float>(owner_.groups_[group].rays);
        Rgb& arriving = owner_.constant_[group];
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
        if (!colors.emission.empty()) {
            owner_.glow_[group] += share * kPi * colors.emission[hit.triangle];
        }
    }

    FaceLight& owner_;
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
    std::vector<std::size_t> shadow_groups_;
};

void FaceLight::trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
                      const RayTracer& tracer) {
    Block(*this, elements, lighting, tracer).gather(begin, end);
}

}  // namespace gg
