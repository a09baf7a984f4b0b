// Points even over the faces of a node, made without the solver's own sampling.
#pragma once

#include <array>
#include <vector>

#include "core/vec.h"
#include "radiosity/hierarchy.h"

namespace gg::test {

struct EvenPoint {
    Vec3 position{0.0F};
    Vec3 normal{0.0F};  // unit, of a side that light reaches
};

// Every lit side of every face counts by its area.
class FacePoints {
  public:
    FacePoints(const Hierarchy& hierarchy, const Node& node);

    // u chooses the face, (v, w) the point on it; all in [0, 1).
    [[nodiscard]] EvenPoint sample(float u, float v, float w) const;
    [[nodiscard]] double area() const { return prefix_.back(); }  // m2, every lit side

  private:
    struct Face {
        Vec3 corners[3];
        Vec3 normal;
    };
    void add(const std::array<Vec3, 3>& corners, Vec3 normal, double area);

    std::vector<Face> faces_;
    std::vector<double> prefix_{0.0};
};

}  // namespace gg::test
