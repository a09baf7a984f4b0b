#include "radiosity/face_groups.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "radiosity/faces.h"

namespace gg {

namespace {

constexpr float kAligned = 0.8F;    // cosine between the normals of a group
constexpr float kThickness = 0.1F;  // of a group, as a share of its tree node's size
constexpr std::size_t kNodes = 256;

// So many faces are always looked at together, and
constexpr std::uint32_t kFew = 24;
// those of a node no larger than this share of its instance and of the scene.
constexpr float kNear = 1.0F / 16, kNearInScene = 1.0F / 128;

// The sides of a node's faces, group after group; `out` gets them.
class Sorter {
  public:
    Sorter(const Scene& scene, std::uint32_t instance, FaceGroups::Builder& out)
        : scene_(scene), instance_(instance), out_(out) {}

    // Few faces of a node of this size [m].
    void add_together(std::span<const std::uint32_t> triangles, float size) {
        groups_.clear();
        sides_.clear();
        for_each_side(triangles, [&](FaceSide side, Vec3 normal) {
            sides_.push_back({group_for(side.triangle, normal, size), side});
        });
        for (std::size_t group = 0; group < groups_.size(); ++group) {
            chosen_.clear();
            for (const auto& [of, side] : sides_) {
                if (of == group) {
                    chosen_.push_back(side);
                }
            }
            out_.add(chosen_);
        }
    }

    void add_apart(std::span<const std::uint32_t> triangles) {
        for_each_side(triangles, [&](FaceSide side, Vec3) { out_.add({&side, 1}); });
    }

  private:
    struct Group {
        Vec3 position{0.0F}, normal{0.0F};  // of its first face
    };

    template <typename Body>
    void for_each_side(std::span<const std::uint32_t> triangles, const Body& body) {
        for (const std::uint32_t triangle : triangles) {
            const Vec3 front = normalize_or_zero(world_area_vector(scene_, instance_, triangle));
            const Sides sides = scene_.sides_of(instance_, triangle);
            for (const bool back : {false, true}) {
                if (has_side(sides, back)) {
                    body(FaceSide{triangle, back}, back ? -front : front);
                }
            }
        }
    }

    std::size_t group_for(std::uint32_t triangle, Vec3 normal, float size) {
        const Vec3 position = world_triangle(scene_, instance_, triangle)[0];
        for (std::size_t i = 0; i < groups_.size(); ++i) {
            if (dot(groups_[i].normal, normal) > kAligned &&
                std::abs(dot(position - groups_[i].position, normal)) < kThickness * size) {
                return i;
            }
        }
        groups_.push_back({position, normal});
        return groups_.size() - 1;
    }

    const Scene& scene_;
    std::uint32_t instance_;
    FaceGroups::Builder& out_;
    std::vector<Group> groups_;
    std::vector<std::pair<std::size_t, FaceSide>> sides_;
    std::vector<FaceSide> chosen_;
};

}  // namespace

FaceGroups group_faces(const Scene& scene, std::uint32_t instance, const ClusterTree& tree, float scene_size,
                       const Control& control) {
    const Affine& to_world = scene.instances[instance].to_world;
    const float near = std::min(kNear * scene.instances[instance].bounds.diameter(), kNearInScene * scene_size);
    std::vector<FaceGroups::Builder> parts((tree.nodes.size() + kNodes - 1) / kNodes);
    parallel_blocks(tree.nodes.size(), kNodes, control, [&](std::size_t begin, std::size_t end) {
        Sorter sorter(scene, instance, parts[begin / kNodes]);
        const auto faces_of = [&](const ClusterTree::Node& node, std::uint32_t last) {
            return std::span(tree.order).subspan(node.begin, last - node.begin);
        };
        const auto add_small = [&](const ClusterTree::Node& node) {
            sorter.add_together(faces_of(node, node.end), transformed(node.bounds, to_world).diameter());
        };
        const auto is_small = [&](const ClusterTree::Node& node) {
            return node.end - node.begin <= kFew || transformed(node.bounds, to_world).diameter() <= near;
        };
        for (std::size_t i = begin; i < end; ++i) {
            const ClusterTree::Node& node = tree.nodes[i];
            if (is_small(node)) {
                if (i == 0) {
                    add_small(node);
                }
                continue;
            }
            sorter.add_apart(faces_of(node, node.direct_end));
            for (std::uint32_t child = node.first_child; child < node.first_child + node.child_count; ++child) {
                if (is_small(tree.nodes[child])) {
                    add_small(tree.nodes[child]);
                }
            }
        }
    });
    return make_groups(parts, tree.order.size());
}

FaceGroups make_groups(std::span<const FaceGroups::Builder> parts, std::size_t triangles) {
    FaceGroups groups;
    groups.of_front.assign(triangles, kNone);
    groups.of_back.assign(triangles, kNone);
    for (const FaceGroups::Builder& part : parts) {
        const auto first = static_cast<std::uint32_t>(groups.sides.size());
        groups.sides.insert(groups.sides.end(), part.sides.begin(), part.sides.end());
        for (const std::uint32_t end : part.ends) {
            groups.begin.push_back(first + end);
        }
    }
    for (std::uint32_t group = 0; group < groups.count(); ++group) {
        for (const FaceSide side : groups[group]) {
            (side.back ? groups.of_back : groups.of_front)[side.triangle] = group;
        }
    }
    return groups;
}

}  // namespace gg
