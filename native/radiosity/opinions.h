// What rays and links say of the light at leaf elements, made one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/hierarchy.h"

namespace gg {

class Control;

// Mean over a leaf element, W/m2.
struct Opinions {
    Rgb by_links{0.0F}, by_rays{0.0F};
    float rays = 1;  // how many
};

// Standard deviations, as shares of what links say.
struct Trust {
    float whole = 1;  // of the truth of a whole triangle to what links say
    float part = 0;   // of a part to its whole
    float ray = 1;    // of what one ray says
};

// Rays are right in the mean, but few and noisy; links know the course of light over a triangle, and little of its
// level. So by the rays of all its parts a triangle differs from what links say, and every part differs from its whole
// as far as it has rays.
class ElementOpinions {
  public:
    ElementOpinions() = default;
    // leaves: all leaf elements of the hierarchy, which must outlive this, unchanged.
    ElementOpinions(const Hierarchy& hierarchy, std::span<const NodeId> leaves);

    // opinions[i] are about leaves[i]; the outcome replaces by_rays.
    void blend(std::span<Opinions> opinions, const Trust& trust, const Control& control) const;

  private:
    const Hierarchy* hierarchy_ = nullptr;
    std::vector<std::uint32_t> opinion_of_;  // per node
    std::vector<NodeId> roots_;              // elements of whole triangles
};

}  // namespace gg
