#include "transport/emitter_sampling.h"

#include <array>

#include "core/random.h"
#include "scene/light_units.h"
#include "transport/form_factor.h"
#include "transport/spherical_rectangle.h"

namespace gg {
namespace {

// Frame around d that turns continuously with d but for d = (0, 0, -1) [Frisvad 2012], with 1 + z taken from x and y
// where it would lose its digits. core's Frame flips where z changes sign, which would draw a line through penumbrae.
Vec3 continuous_to_world(Vec3 d, Vec3 local) {
    const float planar = d.x * d.x + d.y * d.y;
    const float one_plus_z = d.z < 0 ? planar / (1 - d.z) : 1 + d.z;
    if (!(one_plus_z > 1e-12F)) {
        return {local.x, -local.y, -local.z};
    }
    const float a = 1 / one_plus_z;
    const Vec3 tangent{1 - d.x * d.x * a, -d.x * d.y * a, -d.x};
    const Vec3 bitangent{-d.x * d.y * a, 1 - d.y * d.y * a, -d.y};
    return local.x * tangent + local.y * bitangent + local.z * d;
}

// Uniform in solid angle over the cone around unit `axis` whose half angle theta has 1 - cos theta = `depth`.
Vec3 sample_cone(Vec3 axis, float depth, float u, float v) {
    const Vec2 disk = square_to_disk(u, v);
    const float drop = (disk.x * disk.x + disk.y * disk.y) * depth;  // 1 - cosine
    const float stretch = std::sqrt(depth * (2 - drop));
    return continuous_to_world(axis, {disk.x * stretch, disk.y * stretch, 1 - drop});
}

// A sphere, or the disk that faces x in its place, as seen from x.
struct SphereView {
    Vec3 axis{0.0F, 0.0F, 1.0F};  // unit, towards the centre
    float distance = 0;           // to the centre, of a sphere at least the radius
    float sine_squared = 0;       // of its angular radius
    float depth = 0;              // 1 - cosine of its angular radius
};

SphereView view_sphere(const Lamp& lamp, Vec3 x) {
    SphereView view;
    const Vec3 to_center = lamp.position - x;
    const float distance = length(to_center);
    if (distance > 0) {
        view.axis = to_center / distance;
    }
    const float square = lamp.radius * lamp.radius;
    view.distance = lamp.faces_receivers ? distance : std::max(distance, lamp.radius);
    view.sine_squared = square / (view.distance * view.distance + (lamp.faces_receivers ? square : 0.0F));
    view.depth = view.sine_squared / (1 + std::sqrt(1 - view.sine_squared));
    return view;
}

// Along a direction with that cosine to the axis.
float distance_to_sphere(const Lamp& lamp, const SphereView& view, float cosine) {
    const float sine_squared = std::max(0.0F, 1 - cosine * cosine);
    // Near intersection: d cos t - sqrt(r^2 - d^2 sin^2 t), by its conjugate.
    const float reach = view.distance * cosine;
    const float half_chord =
        std::sqrt(std::max(0.0F, lamp.radius * lamp.radius - view.distance * view.distance * sine_squared));
    const float gap = (view.distance - lamp.radius) * (view.distance + lamp.radius);
    return gap > 0 ? gap / (reach + half_chord) : 0.0F;
}

LampSample sample_sphere(const Lamp& lamp, Vec3 x, float u, float v) {
    const SphereView view = view_sphere(lamp, x);
    LampSample sample;
    sample.direction = sample_cone(view.axis, view.depth, u, v);
    const float cosine = dot(sample.direction, view.axis);
    sample.distance = lamp.faces_receivers
                          ? std::min(view.distance / std::max(cosine, 1e-6F), view.distance + lamp.radius)
                          : distance_to_sphere(lamp, view, cosine);
    sample.point = x + sample.distance * sample.direction;
    sample.normal_irradiance =
        lamp.radiance * (2 * kPi * view.depth * spot_factor(lamp, -dot(lamp.direction, sample.direction)));
    return sample;
}

// Whether it is sampled by solid angle, so that no sample outweighs the others. Not where a rectangle is so far that
// its area does as well, x lies in its plane, or it is sheared.
bool goes_by_solid_angle(const Lamp& lamp, Vec3 x, float far) {
    const Vec3 to = lamp.position - x;
    const float size = length_squared(lamp.half_x) + length_squared(lamp.half_y);
    const bool sheared = std::abs(dot(lamp.half_x, lamp.half_y)) > 1e-5F * size;
    return lamp.shape == LampShape::kRectangle && !sheared && length_squared(to) < far * far * size &&
           -dot(to, lamp.direction) > 1e-6F * std::sqrt(size);
}

LampSample sample_flat(const Lamp& lamp, Vec3 x, float u, float v) {
    Vec2 local{2 * u - 1, 2 * v - 1};
    float area = 4 * length(cross(lamp.half_x, lamp.half_y));
    if (lamp.shape == LampShape::kEllipse) {
        local = square_to_disk(u, v);
        area *= kPi / 4;
    }
    LampSample sample;
    sample.point = lamp.position + local.x * lamp.half_x + local.y * lamp.half_y;
    const Vec3 to_sample = sample.point - x;
    const float squared = length_squared(to_sample);
    if (!(squared > 0)) {
        return sample;
    }
    sample.distance = std::sqrt(squared);
    sample.direction = to_sample / sample.distance;
    const float cosine = std::max(0.0F, -dot(sample.direction, lamp.direction));
    sample.normal_irradiance = lamp.radiance * (area * cosine / squared);
    return sample;
}

LampSample sample_point(const Lamp& lamp, Vec3 x) {
    LampSample sample;
    sample.point = lamp.position;
    const Vec3 to_sample = sample.point - x;
    const float squared = length_squared(to_sample);
    if (!(squared > 0)) {
        return sample;
    }
    sample.distance = std::sqrt(squared);
    sample.direction = to_sample / sample.distance;
    sample.normal_irradiance = lamp.radiance * (spot_factor(lamp, -dot(lamp.direction, sample.direction)) / squared);
    return sample;
}

LampSample sample_distant(const Lamp& lamp, Vec3 x, float u, float v) {
    LampSample sample;
    const float depth = 1 - lamp.cos_half_angle;
    sample.direction = sample_cone(-lamp.direction, depth, u, v);
    sample.point = x + sample.direction;
    sample.distance = kInfinity;
    // The mean cosine of the cone to its axis is 1 - depth / 2.
    sample.normal_irradiance = lamp.irradiance / (1 - 0.5F * depth);
    return sample;
}

// Corners of the flat lamp; an ellipse becomes the 16-gon of the same area.
struct Outline {
    std::array<Vec3, 16> corners;
    std::size_t count = 0;
};

Outline outline(const Lamp& lamp) {
    Outline result;
    if (lamp.shape == LampShape::kRectangle) {
        const Vec3 x = lamp.half_x;
        const Vec3 y = lamp.half_y;
        const Vec3 c = lamp.position;
        result.corners = {c - x - y, c + x - y, c + x + y, c - x + y};
        result.count = 4;
        return result;
    }
    result.count = result.corners.size();
    const float step = 2 * kPi / static_cast<float>(result.count);
    const float scale = std::sqrt(step / std::sin(step));
    for (std::size_t i = 0; i < result.count; ++i) {
        const float angle = step * (static_cast<float>(i) + 0.5F);
        result.corners[i] =
            lamp.position + scale * std::cos(angle) * lamp.half_x + scale * std::sin(angle) * lamp.half_y;
    }
    return result;
}

IrradianceVector flat_irradiance(const Lamp& lamp, Vec3 x) {
    if (!(dot(x - lamp.position, lamp.direction) > 0)) {
        return {};
    }
    const Outline shape = outline(lamp);
    const Vec3 phi = vector_form_factor<Vec3>(x, std::span(shape.corners.data(), shape.count));
    const float magnitude = length(phi);
    if (!(magnitude > 0)) {
        return {};
    }
    return {lamp.radiance * (kPi * magnitude), phi / magnitude};
}

}  // namespace

Rgb lamp_irradiance(const Lamp& lamp, Vec3 x, Vec3 n) {
    if (lamp.shape == LampShape::kSphere) {
        const SphereView view = view_sphere(lamp, x);
        const float factor = point_to_sphere(dot(n, view.axis), 1 / std::sqrt(view.sine_squared));
        return lamp.radiance * (kPi * factor * spot_factor(lamp, -dot(lamp.direction, view.axis)));
    }
    if (lamp.shape == LampShape::kRectangle || lamp.shape == LampShape::kEllipse) {
        if (!(dot(x - lamp.position, lamp.direction) > 0)) {
            return Rgb(0.0F);
        }
        const Outline shape = outline(lamp);
        return lamp.radiance * (kPi * point_to_polygon<Vec3>(x, n, std::span(shape.corners.data(), shape.count)));
    }
    const IrradianceVector vector = lamp_irradiance_vector(lamp, x);
    return vector.irradiance * std::max(0.0F, dot(n, vector.direction));
}

LampSample sample_lamp(const Lamp& lamp, Vec3 x, float u, float v, float far) {
    return LampSampler(lamp, x, far).sample(u, v);
}

LampSampler::LampSampler(const Lamp& lamp, Vec3 x, float far) : lamp_(lamp), x_(x) {
    if (goes_by_solid_angle(lamp, x, far)) {
        rectangle_.emplace(lamp.position, lamp.half_x, lamp.half_y, x);
    }
}

LampSampler::LampSampler(const Lamp& lamp, Vec3 x, Vec3 n) : LampSampler(lamp, x) {
    constexpr float kLeast = 0.1F;  // of the largest cosine, for no part may have no samples
    if (rectangle_) {
        std::array<float, 4> cosines{};
        float largest = 0;
        for (int k = 0; k < 4; ++k) {
            const Vec3 to = rectangle_->point(static_cast<float>(k % 2), static_cast<float>(k / 2));
            cosines[k] = dot(n, to) / length(to);
            largest = std::max(largest, cosines[k]);
        }
        for (float& cosine : cosines) {
            cosine = std::max(cosine, kLeast * largest);
        }
        if (largest > 0) {
            warp_.emplace(cosines);
        }
    }
}

LampSample LampSampler::sample(float u, float v) const {
    if (rectangle_) {
        LampSample sample;
        float density = 1;
        if (warp_) {
            const Vec2 place = warp_->place(u, v);
            u = place.x;
            v = place.y;
            density = warp_->density(place);
        }
        const Vec3 to_sample = rectangle_->point(u, v);
        sample.point = x_ + to_sample;
        sample.distance = length(to_sample);
        sample.direction = to_sample / sample.distance;
        sample.normal_irradiance = lamp_.radiance * (rectangle_->solid_angle() / density);
        return sample;
    }
    switch (lamp_.shape) {
        case LampShape::kPoint:
            return sample_point(lamp_, x_);
        case LampShape::kSphere:
            return sample_sphere(lamp_, x_, u, v);
        case LampShape::kRectangle:
        case LampShape::kEllipse:
            return sample_flat(lamp_, x_, u, v);
        case LampShape::kDistant:
            return sample_distant(lamp_, x_, u, v);
    }
    return {};
}

IrradianceVector lamp_irradiance_vector(const Lamp& lamp, Vec3 x) {
    switch (lamp.shape) {
        case LampShape::kPoint: {
            const LampSample sample = sample_point(lamp, x);
            return {sample.normal_irradiance, sample.direction};
        }
        case LampShape::kSphere: {
            const SphereView view = view_sphere(lamp, x);
            return {lamp.radiance * (kPi * view.sine_squared * spot_factor(lamp, -dot(lamp.direction, view.axis))),
                    view.axis};
        }
        case LampShape::kRectangle:
        case LampShape::kEllipse:
            return flat_irradiance(lamp, x);
        case LampShape::kDistant:
            return {lamp.irradiance, -lamp.direction};
    }
    return {};
}

}  // namespace gg
