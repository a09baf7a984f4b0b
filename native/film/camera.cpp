#include "film/camera.h"

namespace gg {

PixelCamera::PixelCamera(const CameraDescription& camera, std::uint32_t width, std::uint32_t height)
    : perspective_(camera.type == CameraType::kPerspective),
      position_(camera.to_world.translation),
      forward_(-camera.to_world.linear[2]),
      near_(camera.clip_start),
      far_(camera.clip_end) {
    const float window_width = camera.window[1] - camera.window[0];
    const float window_height = camera.window[3] - camera.window[2];
    const float pixel_width = window_width / static_cast<float>(width);
    const float pixel_height = window_height / static_cast<float>(height);
    corner_ = camera.window[0] * camera.to_world.linear[0] + camera.window[2] * camera.to_world.linear[1];
    step_x_ = pixel_width * camera.to_world.linear[0];
    step_y_ = pixel_height * camera.to_world.linear[1];
    pixel_size_ = std::sqrt(std::abs(pixel_width * pixel_height));
}

Ray PixelCamera::ray(float x, float y) const {
    const Vec3 place = corner_ + x * step_x_ + y * step_y_;
    if (perspective_) {
        return {position_, forward_ + place, near_, far_};
    }
    return {position_ + place, forward_, near_, far_};
}

Vec3 PixelCamera::project(Vec3 point) const {
    const Vec3 from = point - position_;
    const float depth = dot(from, forward_);
    const Vec3 in_window = (perspective_ ? from / std::max(depth, 1e-20F) : from - depth * forward_) - corner_;
    return {dot(in_window, step_x_) / length_squared(step_x_), dot(in_window, step_y_) / length_squared(step_y_),
            depth};
}

Vec3 PixelCamera::direction_to(Vec3 point) const {
    return perspective_ ? normalize_or_zero(point - position_) : forward_;
}

}  // namespace gg
