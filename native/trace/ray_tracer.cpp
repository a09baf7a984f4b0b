#include "trace/ray_tracer.h"

#include <algorithm>

#include "trace/embree_scene.h"

namespace gg {

struct RayTracer::State {
    EmbreeScene embree;
};

namespace {

// Embree's behaviour on rays that are not finite is undefined.
bool traceable(const Ray& ray) {
    const Vec3 sum = ray.origin + ray.direction;
    return std::isfinite(sum.x + sum.y + sum.z) && ray.direction != Vec3(0) && ray.far >= std::max(ray.near, 0.0F);
}

// Works for one ray and for packets, whose fields are arrays.
float& lane(float& value, std::size_t) {
    return value;
}
unsigned& lane(unsigned& value, std::size_t) {
    return value;
}
template <typename T, std::size_t N>
T& lane(T (&values)[N], std::size_t index) {
    return values[index];
}

template <typename EmbreeRay>
void load_ray(const Ray& ray, RayMask mask, EmbreeRay& out, std::size_t index) {
    lane(out.org_x, index) = ray.origin.x;
    lane(out.org_y, index) = ray.origin.y;
    lane(out.org_z, index) = ray.origin.z;
    lane(out.tnear, index) = std::max(ray.near, 0.0F);
    lane(out.dir_x, index) = ray.direction.x;
    lane(out.dir_y, index) = ray.direction.y;
    lane(out.dir_z, index) = ray.direction.z;
    lane(out.time, index) = 0;
    lane(out.tfar, index) = ray.far;
    lane(out.mask, index) = static_cast<unsigned>(mask);
    lane(out.id, index) = 0;
    lane(out.flags, index) = 0;
}

template <typename EmbreeRayHit>
Hit read_hit(EmbreeRayHit& in, std::size_t index) {
    const unsigned geometry = lane(in.hit.geomID, index);
    if (geometry == RTC_INVALID_GEOMETRY_ID) {
        return {};
    }
    const unsigned instance = lane(in.hit.instID[0], index);
    return {instance != RTC_INVALID_GEOMETRY_ID ? instance : geometry, lane(in.hit.primID, index),
            lane(in.hit.u, index), lane(in.hit.v, index), lane(in.ray.tfar, index)};
}

template <typename EmbreeRayHit>
void clear_hit(EmbreeRayHit& out, std::size_t index) {
    lane(out.hit.geomID, index) = RTC_INVALID_GEOMETRY_ID;
    lane(out.hit.instID[0], index) = RTC_INVALID_GEOMETRY_ID;
}

// Packets of 8: of 16, Embree 3.13's coherent occlusion query with AVX-512 reads stack memory that it never wrote, and
// now and then loops for ever.
constexpr std::size_t kWidth = 8;

struct Lanes {
    alignas(32) int valid[kWidth];
};

// Fills the packet with rays.front() and what follows it; lanes of unusable rays, and beyond the end, are off.
template <typename Packet>
Lanes load_packet(std::span<const Ray> rays, RayMask mask, Packet& packet) {
    Lanes lanes;
    for (std::size_t index = 0; index < kWidth; ++index) {
        const bool used = index < rays.size() && traceable(rays[index]);
        lanes.valid[index] = used ? -1 : 0;
        load_ray(used ? rays[index] : Ray{}, mask, packet, index);
    }
    return lanes;
}

}  // namespace

RayTracer::RayTracer(const Scene& scene, const Control& control) : state_(std::make_unique<State>()) {
    build_embree_scene(scene, control, state_->embree);
}

RayTracer::~RayTracer() = default;

Hit RayTracer::closest_hit(const Ray& ray, RayMask mask) const {
    if (!traceable(ray)) {
        return {};
    }
    EmbreeQuery query(false);
    RTCRayHit embree_ray;
    load_ray(ray, mask, embree_ray.ray, 0);
    clear_hit(embree_ray, 0);
    closest(state_->embree.top.get(), query, embree_ray);
    return read_hit(embree_ray, 0);
}

float RayTracer::farthest_hit(const Ray& ray, RayMask mask) const {
    const Hit hit = closest_hit({ray.origin + ray.far * ray.direction, -ray.direction, 0, ray.far - ray.near}, mask);
    return hit.missed() ? 0 : ray.far - hit.distance;
}

bool RayTracer::occluded(const Ray& ray, RayMask mask) const {
    if (!traceable(ray)) {
        return false;
    }
    EmbreeQuery query(false);
    RTCRay embree_ray;
    load_ray(ray, mask, embree_ray, 0);
    any(state_->embree.top.get(), query, embree_ray);
    return embree_ray.tfar < 0;
}

void RayTracer::closest_hits(std::span<const Ray> rays, std::span<Hit> hits, RayMask mask, Coherence coherence) const {
    EmbreeQuery query(coherence == Coherence::kCoherent);
    RTCRayHit8 packet;
    for (std::size_t begin = 0; begin < rays.size(); begin += kWidth) {
        const Lanes lanes = load_packet(rays.subspan(begin), mask, packet.ray);
        for (std::size_t index = 0; index < kWidth; ++index) {
            clear_hit(packet, index);
        }
        closest(lanes.valid, state_->embree.top.get(), query, packet);
        for (std::size_t index = 0; index < std::min(kWidth, rays.size() - begin); ++index) {
            hits[begin + index] = read_hit(packet, index);
        }
    }
}

void RayTracer::occluded(std::span<const Ray> rays, std::span<std::uint8_t> results, RayMask mask,
                         Coherence coherence) const {
    EmbreeQuery query(coherence == Coherence::kCoherent);
    RTCRay8 packet;
    for (std::size_t begin = 0; begin < rays.size(); begin += kWidth) {
        const Lanes lanes = load_packet(rays.subspan(begin), mask, packet);
        any(lanes.valid, state_->embree.top.get(), query, packet);
        for (std::size_t index = 0; index < std::min(kWidth, rays.size() - begin); ++index) {
            results[begin + index] = packet.tfar[index] < 0 ? 1 : 0;  // Embree marks occlusion by -infinity
        }
    }
}

std::size_t RayTracer::bytes() const {
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, state_->embree.reports.bytes.load()));
}

}  // namespace gg
