#include "radiosity/shadow_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "core/random.h"
#include "radiosity/open_elements.h"
#include "radiosity/oracle.h"
#include "radiosity/quarter.h"
#include "radiosity/source_rays.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr float kLeastRays = 16, kMostRays = 1024;
constexpr float kRaysPerDetail = 64;  // of an element of the size of a detail, see size_in_details()
constexpr std::uint64_t kSeed = 0x65646765;

// Looks at elements, one after the other.
class EdgeFinder {
  public:
    EdgeFinder(const Hierarchy& hierarchy, const SourceGuide& guide, const RayTracer& tracer)
        : hierarchy_(hierarchy), guide_(guide), tracer_(tracer) {}

    // Mean difference, over the quarters of an element, between the light that arrives and what an even visibility
    // would let through, beyond the noise [W/m2]. count: of rays, a multiple of 4.
    float unevenness(NodeId id, std::uint32_t count) {
        const Node& node = hierarchy_[id];
        guide_.list({node.center, node.normal, node.radius, id}, sources_);
        if (!sources_.has(kLocalSources)) {
            return 0;
        }
        add_rays(node, count);
        blocked_.resize(count);
        tracer_.occluded(rays_, blocked_, RayMask::kLight, Coherence::kIncoherent);
        std::array<float, kQuarters> sent{}, seen{};
        float all_sent = 0, all_seen = 0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const float arriving = blocked_[k] ? 0.0F : light_[k];
            sent[k % kQuarters] += light_[k];
            seen[k % kQuarters] += arriving;
            all_sent += light_[k];
            all_seen += arriving;
        }
        if (!(all_seen > 0)) {
            return 0;
        }
        const float visibility = all_seen / all_sent;
        float difference = 0;
        for (int k = 0; k < kQuarters; ++k) {
            difference += std::abs(seen[k] - visibility * sent[k]) / kQuarters;
        }
        constexpr float kNoise = 0.5F;
        const float noise = kNoise * all_sent / kQuarters * std::sqrt(visibility * (1 - visibility)) /
                            std::pow(static_cast<float>(count / kQuarters), 0.75F);
        return std::max(0.0F, difference - noise);
    }

  private:
    void add_rays(const Node& node, std::uint32_t count) {
        const Sequence6 sequence(hash64(node.stable_id, kSeed));
        const std::uint32_t each = count / kQuarters;
        rays_.resize(count);
        light_.resize(count);
        for (std::uint32_t k = 0; k < count; ++k) {
            // Quarters share the points on the source: what differs between them is then more than noise.
            const std::uint32_t j = k / kQuarters;
            const auto [source, chance] =
                sources_.choose(kLocalSources, (static_cast<float>(j) + sequence(0, 4)) / static_cast<float>(each));
            const auto c = quarter_of(node.corner, static_cast<int>(k % kQuarters));
            const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
            const Vec3 x = w.x * c[0] + w.y * c[1] + w.z * c[2];
            const SourceRay ray =
                ray_to_source(hierarchy_, source, {offset_origin(x, node.normal, node.radius), node.normal},
                              Vec3(sequence(j, 2), sequence(j, 5), sequence(j, 3)));
            rays_[k] = ray.ray;
            light_[k] = luminance(ray.light) / (chance * static_cast<float>(each));
        }
    }

    const Hierarchy& hierarchy_;
    const SourceGuide& guide_;
    const RayTracer& tracer_;
    Sources sources_;
    std::vector<Ray> rays_;
    std::vector<float> light_;  // of each if nothing is in the way: share of the luminance of its quarter's irradiance
    std::vector<std::uint8_t> blocked_;
};

}  // namespace

void split_at_shadow_edges(Hierarchy& hierarchy, Lighting& lighting, const SourceGuide& guide, const RayTracer& tracer,
                           const RefineSettings& settings, const Control& control) {
    const auto make_test = [&]() -> ElementTest {
        const auto finder = std::make_shared<EdgeFinder>(hierarchy, guide, tracer);
        return [&, finder](NodeId id) {
            const Node& node = hierarchy[id];
            const float size = size_in_details(node.radius, settings);
            const auto rays = static_cast<std::uint32_t>(
                std::clamp(kRaysPerDetail * std::max(size, size * size), kLeastRays, kMostRays));
            const float difference = finder->unevenness(id, rays / kQuarters * kQuarters);
            const float irradiance = std::max(luminance(lighting.irradiance(id)), difference);
            // An edge is as long as an element, not as large.
            return seen_reflectance(node) * std::min(size, 1.0F) * difference >
                   allowed_difference(irradiance, settings);
        };
    };
    open_elements(hierarchy, lighting, settings, make_test, control);
}

}  // namespace gg
