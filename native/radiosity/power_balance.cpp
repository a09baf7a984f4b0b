#include "radiosity/power_balance.h"

#include <algorithm>
#include <vector>

#include "core/parallel.h"
#include "core/random.h"
#include "radiosity/face_sampling.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::uint32_t kRays = 1U << 14;
constexpr std::size_t kRaysAtOnce = 256;
constexpr float kMostCorrection = 1.25F;

// Power that surfaces send, W, luminance, and the share of it that lands on some side that receives light.
struct Sent {
    double power = 0, landing = 0;
};

Sent sent_power(const Hierarchy& hierarchy, const Lighting& lighting, const RayTracer& tracer, const Control& control) {
    std::vector<NodeId> leaves;
    std::vector<double> prefix{0};
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (is_surface(hierarchy[id]) && hierarchy[id].child_count == 0) {
            const double power = lighting.area(id) * luminance(lighting.radiosity(id));
            if (power > 0) {
                leaves.push_back(id);
                prefix.push_back(prefix.back() + power);
            }
        }
    }
    if (leaves.empty()) {
        return {};
    }
    const Scene& scene = hierarchy.scene();
    const Sequence6 sequence(0);
    const std::size_t landed = ordered_reduce<std::size_t>(
        kRays, kRaysAtOnce, control, 0,
        [&](std::size_t begin, std::size_t end) {
            std::vector<Ray> rays;
            for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
                const auto count = static_cast<std::uint32_t>(leaves.size());
                const float u = (static_cast<float>(i) + 0.5F) / kRays;
                const Node& node = hierarchy[leaves[sample_prefix(prefix, 0, count, u)]];
                FacePoint x =
                    sample_face(hierarchy, node, Spread::kByExposure, sequence(i, 0), sequence(i, 1), sequence(i, 2));
                if (sequence(i, 5) >= x.front) {
                    x.normal = -x.normal;
                }
                const Vec3 direction = square_to_cosine_hemisphere(sequence(i, 3), sequence(i, 4));
                rays.push_back({offset_origin(x.position, x.normal, node.radius), Frame(x.normal).to_world(direction),
                                0, kInfinity});
            }
            std::vector<Hit> hits(rays.size());
            tracer.closest_hits(rays, hits, RayMask::kLight, Coherence::kIncoherent);
            std::size_t count = 0;
            for (std::size_t i = 0; i < hits.size(); ++i) {
                if (!hits[i].missed()) {
                    const Vec3 normal = world_area_vector(scene, hits[i].instance, hits[i].triangle);
                    const bool back = dot(normal, rays[i].direction) > 0;
                    count += has_side(scene.sides_of(hits[i].instance, hits[i].triangle), back) ? 1 : 0;
                }
            }
            return count;
        },
        [](std::size_t a, std::size_t b) { return a + b; });
    return {prefix.back(), static_cast<double>(landed) / kRays};
}

}  // namespace

float missing_gain(const Hierarchy& hierarchy, const Lighting& lighting, const FaceLight& faces,
                   const RayTracer& tracer, const Control& control) {
    Lighting only_lamps = lighting;
    only_lamps.set_gain(0);
    only_lamps.iterate(control);
    const double brought = lighting.power_at_elements() - only_lamps.power_at_elements();
    const Sent sent = sent_power(hierarchy, lighting, tracer, control);
    const double due = sent.power * sent.landing - faces.power_from_surfaces(lighting);
    if (!(brought > 0) || !(due > 0)) {
        return 1;
    }
    // What lands in an open scene is known by few rays, and what is lost there is lost once.
    constexpr double kDoubt = 0.01;
    const double doubt = std::sqrt((1 - sent.landing) / (sent.landing * kRays)) / kDoubt;
    const double ratio = 1 + (due / brought - 1) / (1 + doubt * doubt);
    return std::clamp(static_cast<float>(ratio), 1 / kMostCorrection, kMostCorrection);
}

}  // namespace gg
