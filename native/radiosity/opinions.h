// What rays and links say of the light at leaf elements, made one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "radiosity/hierarchy.h"

namespace gg {

class Control;

// Of one kind of light, W/m2, mean over a leaf element or over some faces of a leaf cluster.
struct Opinions {
    NodeId node = 0;
    float area = 0;  // m2
    Rgb by_links{0.0F}, by_rays{0.0F};
    float rays = 1;  // how many
};

// Standard deviations, as shares of what links say.
struct Trust {
    float whole = 1;  // of the truth of a whole triangle to what links say
    float part = 0;   // of a part to its whole
    float ray = 1;    // of what one ray says; the same everywhere: trust must not depend on what it is to
                      // judge, for where few rays miss what is bright, they agree
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

// The same for faces, in whose place a triangle is their leaf cluster.
void blend_faces(const Hierarchy& hierarchy, std::span<Opinions> opinions, const Trust& trust);

// Trust::ray; variance: of the luminance that one ray brings.
[[nodiscard]] float spread_of_rays(std::span<const Opinions> opinions, std::span<const float> variance);

}  // namespace gg
