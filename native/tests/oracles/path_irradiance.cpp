#include "oracles/path_irradiance.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "support/face_points.h"
#include "trace/surface_point.h"
#include "transport/emitter_sampling.h"

namespace gg::oracle {
namespace {

class Numbers {
  public:
    explicit Numbers(std::uint64_t seed) : seed_(seed) {}
    float next() { return unit_float(hash64(seed_, ++count_)); }

  private:
    std::uint64_t seed_, count_ = 0;
};

Vec3d from_lamps(const WalkedScene& scene, Vec3 x, Vec3 normal, Numbers& numbers) {
    Vec3d sum(0.0);
    for (const Lamp& lamp : scene.scene.lamps) {
        const float u = numbers.next();
        const LampSample sample = sample_lamp(lamp, x, u, numbers.next());
        const float cosine = dot(normal, sample.direction);
        if (!(cosine > 0) || !(luminance(sample.normal_irradiance) > 0)) {
            continue;
        }
        const bool infinite = std::isinf(sample.distance);
        const Vec3 origin = offset_origin(x, normal, infinite ? 1.0F : sample.distance);
        const Vec3 direction = infinite ? sample.direction : sample.point - origin;
        if (!scene.tracer.occluded({origin, direction, 0, infinite ? kInfinity : 1.0F}, RayMask::kLight)) {
            sum += Vec3d(cosine * sample.normal_irradiance);
        }
    }
    return sum;
}

}  // namespace

Vec3d walked_irradiance(const WalkedScene& scene, Vec3 position, Vec3 normal, std::uint64_t seed) {
    Numbers numbers(seed);
    Vec3d irradiance(0.0), throughput(1.0);
    for (;;) {
        irradiance += throughput * from_lamps(scene, position, normal, numbers);
        const float u = numbers.next();
        const Vec2 disk = square_to_disk(u, numbers.next());
        const Vec3 direction = Frame(normal).to_world({disk.x, disk.y, std::sqrt(std::max(0.0F, 1 - dot(disk, disk)))});
        const Hit hit = scene.tracer.closest_hit({offset_origin(position, normal, 1.0F), direction}, RayMask::kLight);
        if (hit.missed()) {
            return irradiance + throughput * Vec3d(kPi * scene.scene.world);
        }
        const SurfacePoint point = surface_point(scene.scene, hit);
        const std::uint32_t material = scene.scene.material_of(hit.instance, hit.triangle);
        irradiance += throughput * Vec3d(kPi * scene.colors.emission_at(material, point.uv, 0));
        const Rgb reflectance = scene.colors.reflectance_at(material, point.uv, 0);
        const float survives = std::min(0.95F, max_component(reflectance));
        if (!(numbers.next() < survives)) {
            return irradiance;
        }
        throughput *= Vec3d(reflectance / survives);
        position = point.position;
        normal = dot(point.geometric_normal, direction) > 0 ? -point.geometric_normal : point.geometric_normal;
    }
}

Vec3d mean_irradiance(const WalkedScene& scene, const Hierarchy& hierarchy, const Node& node, std::uint32_t walks) {
    const test::FacePoints points(hierarchy, node);
    const Sequence4 sequence(node.stable_id);
    Vec3d sum(0.0);
    for (std::uint32_t i = 0; i < walks; ++i) {
        const test::EvenPoint x = points.sample(sequence(i, 0), sequence(i, 1), sequence(i, 2));
        sum += walked_irradiance(scene, x.position, x.normal, hash64(node.stable_id, i));
    }
    return sum / static_cast<double>(walks);
}

}  // namespace gg::oracle
