// Where shadow rays of a place go: to lamps, to cells of the sky and to glowing triangles, by what they may bring.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"
#include "radiosity/hierarchy.h"
#include "radiosity/link.h"

namespace gg {

// Points around a middle whose normals are about the same.
struct Neighbourhood {
    Vec3 middle{0.0F}, normal{0.0F};
    float radius = 0;
    NodeId node = kNone;  // the element, or the leaf cluster, that has the links
};

// Lamps, cells of the sky, glowing triangles.
struct Sources {
    // Two kinds, one after the other: lamps and glowing triangles, cells of the sky.
    static constexpr std::size_t kKinds = 2;
    std::vector<NodeId> nodes;
    std::vector<float> sums;  // running sum, for every kind, of bounds of what they bring [W/m2], less for what links
                              // found hidden
    std::array<std::size_t, kKinds + 1> begin{};  // of every kind, and the end

    [[nodiscard]] bool has(std::size_t kind) const { return begin[kind] < begin[kind + 1]; }

    struct Choice {
        NodeId source = kNone;
        float chance = 0;  // of being chosen, 0..1
    };
    // By u in [0, 1), of a kind that has any.
    [[nodiscard]] Choice choose(std::size_t kind, float u) const;
    // The first of a kind for which is_it(node) holds; kNone if it does for none.
    template <typename Test>
    [[nodiscard]] Choice find(std::size_t kind, const Test& is_it) const {
        for (std::size_t i = begin[kind]; i < begin[kind + 1]; ++i) {
            if (is_it(nodes[i])) {
                return {nodes[i], chance(kind, i)};
            }
        }
        return {};
    }

  private:
    [[nodiscard]] float chance(std::size_t kind, std::size_t i) const {
        return (sums[i] - (i > begin[kind] ? sums[i - 1] : 0)) / sums[begin[kind + 1] - 1];
    }
};
inline constexpr std::size_t kLocalSources = 0, kSkySources = 1;

class SourceGuide {
  public:
    SourceGuide() = default;
    // The hierarchy must outlive this. Nodes that are opened later have the links of their ancestors.
    SourceGuide(const Hierarchy& hierarchy, std::span<const Link> links);

    // Everything that some point of the neighbourhood may see. The sky is left out where much of it is seen: rays of
    // the hemisphere then meet it often enough.
    void list(const Neighbourhood& place, Sources& out) const;

    // Elements of whole triangles that glow. None when there are too many, or large ones: rays find those unaided.
    [[nodiscard]] std::span<const NodeId> emitters() const { return emitters_; }

  private:
    struct Arrow {
        NodeId sender = 0;
        float visibility = 0;
    };

    void find_emitters();
    [[nodiscard]] float bound(const Node& source, const Neighbourhood& place) const;

    const Hierarchy* hierarchy_ = nullptr;
    std::vector<std::uint32_t> begin_;  // per node, into arrows_
    std::vector<Arrow> arrows_;         // links from lamps and sky
    std::vector<NodeId> emitters_;
};

}  // namespace gg
