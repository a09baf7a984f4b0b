// GatheredLight: the rays of its places.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/random.h"
#include "radiosity/gathered_light.h"
#include "radiosity/lighting.h"
#include "radiosity/sky_balance.h"
#include "radiosity/source_rays.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::uint32_t kRaysPerShadowRay = 2;  // of groups
constexpr std::uint32_t kProbes = 3;
constexpr std::uint64_t kProbeSeed = 0x70726f62, kShadowSeed = 0x73686164;  // no place of a ray may go with its target

}  // namespace

// Places whose rays are traced together.
class GatheredLight::Block {
  public:
    Block(GatheredLight& owner, const ElementTable& elements, const Lighting& lighting, const RayTracer& tracer)
        : owner_(owner), elements_(elements), lighting_(lighting), tracer_(tracer), scene_(owner.hierarchy_->scene()) {}

    void gather(std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            first_point_.push_back(points_.size());
            add_points(i);
        }
        first_point_.push_back(points_.size());
        hits_.resize(rays_.size());
        tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
        covered_.assign(points_.size(), 0);
        for (std::size_t i = begin; i < end; ++i) {
            probe_close_points(i, first_point_[i - begin], first_point_[i - begin + 1]);
        }
        find_covered_points();
        for (std::size_t i = begin; i < end; ++i) {
            leave_out_covered_points(i, first_point_[i - begin], first_point_[i - begin + 1]);
            add_source_rays(i);
            arrive(i);
        }
        blocked_.resize(shadow_rays_.size());
        tracer_.occluded(shadow_rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
        for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
            if (!blocked_[i]) {
                owner_.emitted_[shadows_[i].place] += shadows_[i].light;
            }
        }
    }

  private:
    struct Shadow {
        std::size_t place = 0;
        Rgb light{0.0F};  // if nothing is in the way: share of the irradiance
    };

    // Points of a place, evenly by area, each with a ray into its hemisphere.
    void add_points(std::size_t i) {
        if (owner_.places_[i].element == kNone) {
            add_group_points(owner_.places_[i]);
        } else {
            add_element_points(owner_.places_[i]);
        }
    }

    // Points that lie below or within something else are not seen, and their darkness must not count.
    // Where a ray does not get far, more are sent out.
    void probe_close_points(std::size_t i, std::size_t begin, std::size_t end) {
        const Place& place = owner_.places_[i];
        // By area: what stands before a thin element as far off as that is long does not cover it.
        const float reach = std::min(2 * std::sqrt(place.area), 0.5F * owner_.hierarchy_->faces().patches.reach);
        const Sequence4 sequence(hash64(seed_of(place), kProbeSeed));
        for (std::size_t k = begin; k < end; ++k) {
            if (hits_[k].missed() || hits_[k].distance > reach) {
                continue;
            }
            for (std::uint32_t j = 0; j < kProbes; ++j) {
                const auto index = static_cast<std::uint32_t>(k - begin) * kProbes + j;
                const Vec3 direction = square_to_cosine_hemisphere(sequence(index, 0), sequence(index, 1));
                probes_.push_back({points_[k].position, Frame(points_[k].normal).to_world(direction), 0, reach});
            }
            probed_.push_back(k);
        }
    }

    void find_covered_points() {
        blocked_.resize(probes_.size());
        tracer_.occluded(probes_, blocked_, RayMask::kLight, Coherence::kIncoherent);
        for (std::size_t p = 0; p < probed_.size(); ++p) {
            const auto first = blocked_.begin() + static_cast<std::ptrdiff_t>(p * kProbes);
            covered_[probed_[p]] = std::all_of(first, first + kProbes, [](std::uint8_t b) { return b != 0; });
        }
    }

    // Fills open_points_. Where all are covered, they are all that is seen.
    void leave_out_covered_points(std::size_t i, std::size_t begin, std::size_t end) {
        open_points_.clear();
        for (std::size_t k = begin; k < end; ++k) {
            if (!covered_[k]) {
                open_points_.push_back(k);
            }
        }
        if (open_points_.empty()) {
            open_points_.resize(end - begin);
            std::iota(open_points_.begin(), open_points_.end(), begin);
        }
        Place& place = owner_.places_[i];
        place.open = static_cast<float>(open_points_.size()) / static_cast<float>(end - begin);
        place.rays = static_cast<std::uint32_t>(open_points_.size());
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

    // The place as far as its sources are concerned.
    Neighbourhood neighbourhood(const Place& place) const {
        if (place.element != kNone) {
            const Node& node = (*owner_.hierarchy_)[place.element];
            return {node.center, node.normal, node.radius, place.element};
        }
        const OffsetPoint& middle = points_[open_points_[open_points_.size() / 2]];
        float radius = 0;
        for (const std::size_t k : open_points_) {
            radius = std::max(radius, length(points_[k].position - middle.position));
        }
        return {middle.position, middle.normal, 2 * radius, place.cluster};
    }

    void add_source_rays(std::size_t i) {
        owner_.guide_->list(neighbourhood(owner_.places_[i]), sources_);
        for (std::size_t kind = 0; kind < Sources::kKinds; ++kind) {
            add_rays_to(i, kind);
        }
    }

    // Shadow rays are dealt out to the sources of a kind by what they may bring.
    void add_rays_to(std::size_t i, std::size_t kind) {
        if (!sources_.has(kind)) {
            return;
        }
        const Place& place = owner_.places_[i];
        const Sequence6 sequence(hash64(seed_of(place), kShadowSeed + kind));
        const float shift = sequence(0, 4);
        const std::uint32_t count = source_ray_count(place);
        for (std::uint32_t k = 0; k < count; ++k) {
            const auto [source, chance] =
                sources_.choose(kind, (static_cast<float>(k) + shift) / static_cast<float>(count));
            const OffsetPoint& x = points_[open_points_[scattered(k, count) * open_points_.size() / count]];
            const Vec3 sample(sequence(k, 0), sequence(k, 5), sequence(k, 3));
            const SourceRay ray = ray_to_source(*owner_.hierarchy_, source, x, sample);
            if (luminance(ray.light) > 0) {
                const float rays = chance * static_cast<float>(count);  // expected to the source
                const float share = kind == kSkySources
                                        ? 1 / (rays + hemisphere_rays_into((*owner_.hierarchy_)[source].area,
                                                                           place.rays, x.normal, ray.ray.direction))
                                        : 1 / rays;
                shadow_rays_.push_back(ray.ray);
                shadows_.push_back({i, share * ray.light});
            }
        }
    }

    // What counts of the sky that a ray of the hemisphere meets, 0..1.
    float sky_share(const Place& place, Vec3 normal, Vec3 direction) const {
        return hemisphere_share(*owner_.hierarchy_, sources_, {place.rays, source_ray_count(place)}, normal, direction);
    }

    static std::uint32_t source_ray_count(const Place& place) {
        return std::max(1U, place.element == kNone ? place.rays / kRaysPerShadowRay : place.rays);
    }

    // A permutation of 0..count-1, so that neighbouring shares of the sources go to points all over the place.
    static std::uint32_t scattered(std::uint32_t k, std::uint32_t count) {
        std::uint32_t step = static_cast<std::uint32_t>(0.618F * static_cast<float>(count)) | 1U;
        while (std::gcd(step, count) != 1) {
            step += 2;
        }
        return k * step % count;
    }

    // What the open points' rays of a place have hit.
    void arrive(std::size_t i) {
        const Place& place = owner_.places_[i];
        const float share = 1 / static_cast<float>(place.rays);
        Rgb& emitted = owner_.emitted_[i];
        std::size_t slot = place.first_ray;
        for (const std::size_t k : open_points_) {
            const Hit& hit = hits_[k];
            if (hit.missed()) {
                emitted += sky_share(place, points_[k].normal, rays_[k].direction) * share * kPi * scene_.world;
            } else {
                owner_.hits_[slot] = place_at(rays_[k], hit, share, emitted);
            }
            ++slot;
        }
    }

    // kNone for a side that no light reaches. Adds what is emitted there, if no shadow rays look for it.
    std::uint32_t place_at(const Ray& ray, const Hit& hit, float share, Rgb& emitted) const {
        const bool back = dot(world_area_vector(scene_, hit.instance, hit.triangle), ray.direction) > 0;
        const NodeId element = elements_.of(hit.instance, hit.triangle, back);
        if (element != kNone) {
            const NodeId leaf = lighting_.leaf_element_at(element, ray.origin + hit.distance * ray.direction);
            if (owner_.guide_->emitters().empty()) {
                emitted += share * (*owner_.hierarchy_)[leaf].emission;
            }
            return owner_.place_of_element_[leaf];
        }
        const std::uint32_t group = owner_.groups_of(hit.instance).of(hit.triangle, back);
        if (group == kNone || owner_.first_[hit.instance] == kNone) {
            return kNone;
        }
        const FaceColors& colors = owner_.colors_of(hit.instance);
        if (!colors.emission.empty()) {
            emitted += share * kPi * colors.emission[hit.triangle];
        }
        return owner_.place_of_group_[owner_.first_[hit.instance] + group];
    }

    GatheredLight& owner_;
    const ElementTable& elements_;
    const Lighting& lighting_;
    const RayTracer& tracer_;
    const Scene& scene_;
    std::vector<std::size_t> first_point_;  // of every place in points_, and the end
    std::vector<OffsetPoint> points_;
    std::vector<Ray> rays_, probes_, shadow_rays_;  // rays_: one of every point
    std::vector<Hit> hits_;
    std::vector<std::size_t> probed_;  // points, kProbes rays each
    std::vector<std::uint8_t> covered_, blocked_;
    std::vector<std::size_t> open_points_;  // of one place
    std::vector<float> ends_;
    Sources sources_;
    std::vector<Shadow> shadows_;  // per shadow ray
};

void GatheredLight::trace(std::size_t begin, std::size_t end, const ElementTable& elements, const Lighting& lighting,
                          const RayTracer& tracer) {
    Block(*this, elements, lighting, tracer).gather(begin, end);
}

}  // namespace gg
