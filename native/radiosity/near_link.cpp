#include "radiosity/near_link.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "radiosity/face_sampling.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

// Standard deviation of a share from `count` samples, uniform prior.
float share_uncertainty(float share, std::size_t count) {
    const auto n = static_cast<float>(count);
    const float hits = share * n;
    return std::sqrt((hits + 1) * (n - hits + 1) / ((n + 2) * (n + 2) * (n + 3)));
}

// Least squares of the irradiance of faces as a linear function of their normals, with a prior of no difference: a face
// that gets more by dE adds dE * (result . (n_k - mean)) / count to what faces with normal n have more, times n.
struct NormalFit {
    Mat3 inverse{1.0F};
    Vec3 mean{0.0F};
};

NormalFit fit_normals(std::span<const Vec3> normals) {
    constexpr float kPrior = 0.3F;  // the variance of a coordinate of evenly spread normals is 1/3
    const auto count = static_cast<float>(normals.size());
    NormalFit fit;
    Mat3 squares(0.0F);
    for (const Vec3 n : normals) {
        fit.mean += n / count;
        squares += glm::outerProduct(n, n) / count;
    }
    fit.inverse = glm::inverse(squares - glm::outerProduct(fit.mean, fit.mean) + Mat3(kPrior));
    return fit;
}

}  // namespace

Sequence6 pair_sequence(const Node& receiver, const Node& sender, SampleSet samples) {
    return Sequence6(hash64(hash64(receiver.stable_id, sender.stable_id), static_cast<std::uint64_t>(samples)));
}

void estimate_near(const Hierarchy& hierarchy, const RayTracer& tracer, const Node& receiver, const Node& sender,
                   int count, SampleSet samples, Link& link, NearHits* out) {
    const Sequence6 sequence = pair_sequence(receiver, sender, samples);
    std::array<Ray, kMaxRays> rays;
    std::array<Hit, kMaxRays> hits;
    std::array<Vec3, kMaxRays> normals;
    for (int k = 0; k < count; ++k) {
        const auto i = static_cast<std::uint32_t>(k);
        FacePoint x = sample_face(hierarchy, receiver, Spread::kByArea, sequence(i, 2), sequence(i, 0), sequence(i, 1));
        if (sequence(i, 5) >= x.front) {
            x.normal = -x.normal;
        }
        const Vec3 direction = square_to_cosine_hemisphere(sequence(i, 3), sequence(i, 4));
        normals[k] = x.normal;
        rays[k] = {offset_origin(x.position, x.normal, receiver.radius), Frame(x.normal).to_world(direction), 0,
                   kInfinity};
    }
    const auto n = static_cast<std::size_t>(count);
    tracer.closest_hits(std::span<const Ray>(rays.data(), n), std::span<Hit>(hits.data(), n), RayMask::kLight,
                        Coherence::kIncoherent);
    const NormalFit fit = fit_normals(std::span<const Vec3>(normals.data(), n));
    link.first_hit = out ? static_cast<std::uint32_t>(out->size()) : 0;
    int found = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Hit& hit = hits[i];
        if (hit.missed() || !hierarchy.contains(sender, hit.instance, hit.triangle)) {
            continue;
        }
        ++found;
        if (out) {
            const bool back =
                dot(world_area_vector(hierarchy.scene(), hit.instance, hit.triangle), rays[i].direction) > 0;
            const Vec3 lean = fit.inverse * (normals[i] - fit.mean) / static_cast<float>(count);
            out->push_back({hit.instance, hit.triangle, kNone, back, lean});
        }
    }
    link.near = true;
    link.ray_count = static_cast<std::uint8_t>(count);
    link.hit_count = static_cast<std::uint8_t>(found);
    link.form_factor = static_cast<float>(found) / static_cast<float>(count);
    link.visibility = found > 0 ? 1.0F : 0.0F;
    constexpr float kVariation = 0.25F;  // between the receiver's faces, which all get the same
    link.level_error = found > 0 ? share_uncertainty(link.form_factor, n) + kVariation * link.form_factor
                                 : kUnproven / static_cast<float>(count + 2);
}

}  // namespace gg
