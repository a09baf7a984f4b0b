#include "oracles/solution_irradiance.h"

#include <cmath>

#include "core/random.h"
#include "transport/emitter_sampling.h"

namespace gg::oracle {

Vec3d solution_irradiance(const Solution& solution, const RayTracer& tracer, Vec3 x, Vec3 n, std::uint32_t rays) {
    const Scene& scene = hierarchy_of(solution).scene();
    const Sequence4 sequence(hash64(9));
    const Frame frame(n);
    Vec3d sum(0.0);
    for (std::uint32_t i = 0; i < rays; ++i) {
        const float u = sequence(i, 0), v = sequence(i, 1);
        const Vec3 direction = frame.to_world(square_to_cosine_hemisphere(u, v));
        const Hit hit = tracer.closest_hit({x, direction, 0, kInfinity}, RayMask::kLight);
        if (hit.missed()) {
            sum += Vec3d(kPi * scene.world);
        } else {
            const bool back = dot(world_area_vector(scene, hit.instance, hit.triangle), direction) > 0;
            sum += Vec3d(lit_place(solution, hit, back).radiosity);
        }
        for (const Lamp& lamp : scene.lamps) {
            const LampSample sample = sample_lamp(lamp, x, sequence(i, 2), sequence(i, 3));
            const Rgb light = std::max(0.0F, dot(n, sample.direction)) * sample.normal_irradiance;
            const bool infinite = std::isinf(sample.distance);
            const Vec3 to = infinite ? sample.direction : sample.point - x;
            if (luminance(light) > 0 && !tracer.occluded({x, to, 0, infinite ? kInfinity : 0.9999F}, RayMask::kLight)) {
                sum += Vec3d(light);
            }
        }
    }
    return sum / static_cast<double>(rays);
}

}  // namespace gg::oracle
