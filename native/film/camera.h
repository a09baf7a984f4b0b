// From places in the picture to rays.
#pragma once

#include <cstdint>

#include "core/vec.h"
#include "scene/description.h"
#include "trace/ray_tracer.h"

namespace gg {

class PixelCamera {
  public:
    // width, height: of the full picture in pixels.
    PixelCamera(const CameraDescription& camera, std::uint32_t width, std::uint32_t height);

    // Through (x, y) pixels from the lower left corner of the full picture. The ray's t is the depth along the view
    // direction in m; near and far are the camera's clip distances.
    [[nodiscard]] Ray ray(float x, float y) const;

    // x and y as above, and the depth along the view direction, m, of a point in world space. Behind a perspective
    // camera x and y mean nothing.
    [[nodiscard]] Vec3 project(Vec3 point) const;

    // Unit, in which the camera sees a point.
    [[nodiscard]] Vec3 direction_to(Vec3 point) const;

    [[nodiscard]] bool is_perspective() const { return perspective_; }
    // Side of a pixel, m, across the view direction at that depth.
    [[nodiscard]] float pixel_size(float depth) const { return perspective_ ? pixel_size_ * depth : pixel_size_; }

  private:
    bool perspective_;
    Vec3 position_, forward_;
    Vec3 corner_, step_x_, step_y_;  // lower left corner of the window relative to position, and pixel steps
    float near_, far_;
    float pixel_size_;
};

}  // namespace gg
