// Slow truths for form factors: closed forms of whole areas, areas by quadrature, points by counting rays.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace gg::oracle {

// Form factor between two equal parallel a x b rectangles, facing each other at distance c [Howell, C-11].
[[nodiscard]] double parallel_rectangles(double a, double b, double c);

// Form factor from a rectangle of depth w to a perpendicular one of height h that share an edge of length l
// [Howell, C-14].
[[nodiscard]] double perpendicular_rectangles(double w, double h, double l);

// Form factor from a disk of radius r1 to a coaxial parallel one of radius r2 at distance h [Howell, C-41].
[[nodiscard]] double coaxial_disks(double r1, double r2, double h);

// Regular polygon around +z in the plane z with the area of the disk of that radius, counter-clockwise.
[[nodiscard]] std::vector<Vec3d> disk_polygon(double radius, double z, int corners);

// Form factor from the parallelogram corner, corner + u, corner + v, whose normal is along u x v, to a convex polygon:
// the mean of point_to_polygon by double-exponential quadrature [Takahasi and Mori 1974], which copes with common
// edges.
[[nodiscard]] double area_to_polygon(Vec3d corner, Vec3d u, Vec3d v, std::span<const Vec3d> polygon);

// Form factor from the disk of that radius around the origin in z = 0, normal +z, to a polygon symmetric about z.
[[nodiscard]] double disk_to_polygon(double radius, std::span<const Vec3d> polygon);

// Mean over cosine-distributed directions around unit normal n of the share that meets a convex planar polygon.
[[nodiscard]] double counted_form_factor(Vec3d x, Vec3d n, std::span<const Vec3d> polygon, std::uint32_t rays);

}  // namespace gg::oracle
