#include "transport/emitter_sampling.h"

#include <algorithm>
#include <array>

#include "core/random.h"
#include "scene/light_units.h"
#include "transport/form_factor.h"

namespace gg {
namespace {

LampSample sample_sphere(const Lamp& lamp, const SphereView& view, Vec3 x, float u, float v) {
    LampSample sample;
    sample.direction = sample_cone(view.axis, view.depth, square_to_disk(u, v));
    sample.distance = view.distance_along(lamp, dot(sample.direction, view.axis));
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
    LampSample sample;
    sample.point = flat_point(lamp, u, v);
    const Vec3 to_sample = sample.point - x;
    const float squared = length_squared(to_sample);
    if (!(squared > 0)) {
        return sample;
    }
    sample.distance = std::sqrt(squared);
    sample.direction = to_sample / sample.distance;
    const float cosine = std::max(0.0F, -dot(sample.direction, lamp.direction));
    sample.normal_irradiance = lamp.radiance * (flat_area(lamp) * cosine / squared);
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
    sample.direction = sample_cone(-lamp.direction, depth, square_to_disk(u, v));
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
        const std::array<Vec3, 4> corners = rectangle_corners(lamp);
        std::copy(corners.begin(), corners.end(), result.corners.begin());
        result.count = corners.size();
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

std::array<Vec3, 4> rectangle_corners(const Lamp& lamp) {
    const Vec3 x = lamp.half_x, y = lamp.half_y, c = lamp.position;
    return {c - x - y, c + x - y, c + x + y, c - x + y};
}

Vec3 flat_point(const Lamp& lamp, float u, float v) {
    const Vec2 local = lamp.shape == LampShape::kEllipse ? square_to_disk(u, v) : Vec2(2 * u - 1, 2 * v - 1);
    return lamp.position + local.x * lamp.half_x + local.y * lamp.half_y;
}

float flat_area(const Lamp& lamp) {
    return (lamp.shape == LampShape::kEllipse ? kPi : 4.0F) * length(cross(lamp.half_x, lamp.half_y));
}

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
    } else if (lamp.shape == LampShape::kSphere) {
        sphere_ = view_sphere(lamp, x);
    }
}

LampSampler::LampSampler(const Lamp& lamp, Vec3 x, Vec3 n) : LampSampler(lamp, x) {
    constexpr float kLeast = 0.1F;  // of the largest cosine, for no part may have no samples
    if (rectangle_) {
        std::array<float, 4> cosines{};
        float largest = 0;
        for (int k = 0; k < 4; ++k) {
            const Vec3 to = rectangle_->corner(k % 2 != 0, k / 2 != 0);
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
            return sample_sphere(lamp_, sphere_, x_, u, v);
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
