#include "radiosity/face_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "core/random.h"
#include "radiosity/instance_parts.h"
#include "radiosity/solution_data.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"

namespace gg {

namespace {

constexpr int kBounces = 3;  // between faces of clusters, beyond what links tell of them
constexpr std::uint32_t kRaysPerLampRay = 3;
constexpr float kSize = 1.0F / 128;  // of a group, as a share of the scene's, from which all rays start
constexpr float kEvenShare = 0.1F;   // of the lamps' rays: spread over all lamps, whatever the first point gets
constexpr std::size_t kGroupsAtOnce = 32;

}  // namespace

class FaceGatherer {
  public:
    FaceGatherer(const Solution& solution, const RayTracer& tracer, int rays, const Control& control)
        : solution_(solution),
          hierarchy_(solution.hierarchy),
          scene_(solution.hierarchy.scene()),
          tracer_(tracer),
          rays_(static_cast<std::uint32_t>(rays)),
          size_(kSize * solution.hierarchy[kGeometryRoot].radius * 2),
          control_(control) {}

    FaceLight gather() {
        find_groups();
        arriving_.assign(groups_.size(), Rgb(0.0F));
        hits_.assign(groups_.empty() ? 0 : groups_.back().first_ray + groups_.back().rays, kNone);
        parallel_blocks(groups_.size(), kGroupsAtOnce, control_,
                        [&](std::size_t begin, std::size_t end) { Block(*this).gather(begin, end); });
        for (int bounce = 0; bounce < kBounces; ++bounce) {
            reflect();
        }
        return std::move(light_);
    }

  private:
    // A group of an instance with at least one face in a cluster.
    struct Group {
        std::uint32_t instance = 0, group = 0;
        std::uint32_t rays = 0;
        std::size_t first_ray = 0;
    };

    const FaceGroups& groups_of(std::uint32_t instance) const {
        return hierarchy_.faces().meshes[scene_.instances[instance].mesh].groups;
    }
    const FaceColors& colors_of(std::uint32_t instance) const {
        return hierarchy_.faces().colors[hierarchy_.faces().instance_colors[instance]];
    }

    // Lists the groups and gives each what its cluster's links tell.
    void find_groups() {
        const auto parts = parts_of_instances(hierarchy_);
        light_.first_.assign(parts.size(), kNone);
        std::uint32_t total = 0;
        for (std::uint32_t i = 0; i < parts.size(); ++i) {
            if (!parts[i].leaf_clusters.empty()) {
                light_.first_[i] = total;
                total += static_cast<std::uint32_t>(groups_of(i).count());
            }
        }
        light_.irradiance_.assign(total, Rgb(0.0F));
        reflectance_.assign(total, Rgb(0.0F));
        groups_ = parallel_collect<Group>(parts.size(), 1, control_,
                                          [&](std::size_t begin, std::size_t end, std::vector<Group>& out) {
                                              for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                                                  list_groups(i, parts[i], out);
                                              }
                                          });
        for (std::size_t i = 1; i < groups_.size(); ++i) {
            groups_[i].first_ray = groups_[i - 1].first_ray + groups_[i - 1].rays;
        }
    }

    void list_groups(std::uint32_t instance, const InstanceParts& parts, std::vector<Group>& out) {
        if (parts.leaf_clusters.empty()) {
            return;
        }
        const FaceGroups& groups = groups_of(instance);
        const MeshFaces& mesh = hierarchy_.faces().meshes[scene_.instances[instance].mesh];
        std::vector<NodeId> cluster(groups.count(), kNone);
        for (const NodeId leaf : parts.leaf_clusters) {
            for_each_triangle_in(hierarchy_, leaf, instance, [&](std::uint32_t triangle) {
                for (const std::uint32_t group : {groups.of_front[triangle], groups.of_back[triangle]}) {
                    if (group != kNone) {
                        cluster[group] = leaf;
                    }
                }
            });
        }
        for (std::uint32_t g = 0; g < cluster.size(); ++g) {
            if (cluster[g] == kNone) {
                continue;
            }
            Rgb reflected(0.0F), irradiance(0.0F);
            float area = 0;
            for (const FaceSide side : groups[g]) {
                const Vec3 vector = world_area_vector(scene_, instance, side.triangle);
                const Vec3 normal = normalize_or_zero(side.back ? -vector : vector);
                const float face = length(vector);
                area += face;
                reflected += face * colors_of(instance).reflectance[side.triangle];
                irradiance += face * solution_.lighting.irradiance_of_face(cluster[g], mesh.exposure[side.triangle],
                                                                           side.back, normal);
            }
            const float inverse = 1 / std::max(area, 1e-30F);
            light_.irradiance_[light_.first_[instance] + g] = inverse * irradiance;
            reflectance_[light_.first_[instance] + g] = inverse * reflected;
            out.push_back({instance, g, rays_for(std::sqrt(area)), 0});
        }
    }

    // From a group of this size [m]: small ones have many neighbours.
    std::uint32_t rays_for(float size) const {
        const auto whole = static_cast<float>(rays_);
        return static_cast<std::uint32_t>(std::clamp(whole * size / size_, 0.25F * whole, 2 * whole));
    }

    void reflect() {
        std::vector<Rgb> next = light_.irradiance_;
        parallel_for(groups_.size(), 1024, control_, [&](std::size_t i) {
            Rgb sum = arriving_[i];
            const auto& [instance, group, rays, first] = groups_[i];
            for (std::size_t k = first; k < first + rays; ++k) {
                if (hits_[k] != kNone) {
                    sum += reflectance_[hits_[k]] * light_.irradiance_[hits_[k]] / static_cast<float>(rays);
                }
            }
            next[light_.first_[instance] + group] = sum;
        });
        light_.irradiance_ = std::move(next);
    }

    // Groups whose rays are traced together.
    class Block {
      public:
        explicit Block(FaceGatherer& owner) : owner_(owner) {}

        void gather(std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                add_points(i);
                add_lamp_rays(i);
            }
            hits_.resize(rays_.size());
            owner_.tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
            blocked_.resize(shadow_rays_.size());
            owner_.tracer_.occluded(shadow_rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
            for (std::size_t i = 0; i < shadow_rays_.size(); ++i) {
                if (!blocked_[i]) {
                    owner_.arriving_[shadow_groups_[i]] += shadow_light_[i];
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
            const auto [instance, group, rays, first] = owner_.groups_[i];
            const std::span<const FaceSide> sides = owner_.groups_of(instance)[group];
            ends_.clear();
            float area = 0;
            for (const FaceSide side : sides) {
                area += length(world_area_vector(owner_.scene_, instance, side.triangle));
                ends_.push_back(area);
            }
            const Sequence6 sequence(hash64(owner_.scene_.instances[instance].stable_id, sides.front().triangle));
            points_.clear();
            for (std::uint32_t k = 0; k < rays; ++k) {
                const float target = area * (static_cast<float>(k) + 0.5F) / static_cast<float>(rays);
                const auto found = std::upper_bound(ends_.begin(), ends_.end() - 1, target);
                const FaceSide side = sides[static_cast<std::size_t>(found - ends_.begin())];
                const auto c = world_triangle(owner_.scene_, instance, side.triangle);
                const Vec3 vector = world_area_vector(owner_.scene_, instance, side.triangle);
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
            const std::vector<Lamp>& lamps = owner_.scene_.lamps;
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
            const auto [instance, group, rays, first] = owner_.groups_[i];
            const Sequence6 sequence(hash64(owner_.scene_.instances[instance].stable_id,
                                            owner_.groups_of(instance)[group].front().triangle));
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
                    shadow_light_.push_back(sample.normal_irradiance *
                                            (cosine / (chance * static_cast<float>(lamp_rays))));
                    shadow_groups_.push_back(i);
                }
            }
        }

        void arrive(std::size_t group, std::size_t slot, const Ray& ray, const Hit& hit) {
            const float share = 1 / static_cast<float>(owner_.groups_[group].rays);
            Rgb& arriving = owner_.arriving_[group];
            if (hit.missed()) {
                arriving += share * kPi * owner_.scene_.world;
                return;
            }
            const bool back = dot(world_area_vector(owner_.scene_, hit.instance, hit.triangle), ray.direction) > 0;
            const InstanceVertices& vertices = owner_.solution_.vertices[hit.instance];
            const auto& elements = back ? vertices.back_element : vertices.front_element;
            const NodeId element = elements.empty() ? kNone : elements[hit.triangle];
            if (element != kNone) {
                const Vec3 y = ray.origin + hit.distance * ray.direction;
                arriving += share * owner_.solution_.lighting.at(element, y).radiosity;
                return;
            }
            const std::uint32_t other = owner_.groups_of(hit.instance).of(hit.triangle, back);
            if (other == kNone || owner_.light_.first_[hit.instance] == kNone) {
                return;  // a side that no light reaches
            }
            owner_.hits_[slot] = owner_.light_.first_[hit.instance] + other;
            const FaceColors& colors = owner_.colors_of(hit.instance);
            if (!colors.emission.empty()) {
                arriving += share * kPi * colors.emission[hit.triangle];
            }
        }

        FaceGatherer& owner_;
        std::vector<Point> points_;
        std::vector<float> ends_;
        std::vector<Ray> rays_, shadow_rays_;
        std::vector<Hit> hits_;
        std::vector<std::uint8_t> blocked_;
        std::vector<Rgb> shadow_light_;
        std::vector<std::size_t> shadow_groups_;
    };

    const Solution& solution_;
    const Hierarchy& hierarchy_;
    const Scene& scene_;
    const RayTracer& tracer_;
    std::uint32_t rays_;
    float size_;
    const Control& control_;
    FaceLight light_;
    std::vector<Group> groups_;
    std::vector<Rgb> arriving_;        // per group of groups_: from elements, lamps, sky and glowing faces
    std::vector<std::uint32_t> hits_;  // per ray: the group of a cluster that it hit, as in FaceLight, or kNone
    std::vector<Rgb> reflectance_;     // per group as in FaceLight
};

FaceLight gather_face_light(const Solution& solution, const RayTracer& tracer, int rays, const Control& control) {
    return FaceGatherer(solution, tracer, rays, control).gather();
}

std::size_t FaceLight::bytes() const {
    return irradiance_.capacity() * sizeof(Rgb) + first_.capacity() * sizeof(std::uint32_t);
}

}  // namespace gg
