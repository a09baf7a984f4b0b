#include "radiosity/exposure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/parallel.h"
#include "core/random.h"
#include "trace/ray_tracer.h"
#include "trace/surface_point.h"

namespace gg {

namespace {

constexpr std::uint32_t kFirstRays = 2;  // enough for faces that both get away from
constexpr std::uint32_t kRays = 5;
constexpr float kRoom = 0.5F;  // how far a ray must get, as a share of the instance's size
// Whose hemisphere is open by no more than the first share gets next to no light from outside, by the second and more
// about as much as any [measured: armchair, sofa, dresser, books, bear, peace lily of the furnished room].
constexpr float kCovered = 0.13F, kExposed = 0.5F;
constexpr float kLeast = 1.0F / 64;  // of a covered face: no cluster is without any area
constexpr float kAligned = 0.8F;     // cosine between normals of faces that are looked at as one
constexpr float kThickness = 0.1F;   // of such faces together, as a share of their tree node's size
constexpr std::size_t kNodes = 32;   // of the tree, whose rays are traced together

struct FaceSide {
    std::uint32_t triangle = 0;
    bool back = false;
    Vec3 normal{0.0F};
};

// Neighbours of the same leaf that face one way: one share of open directions for all of them.
struct Group {
    std::vector<FaceSide> faces;
    Vec3 position{0.0F};        // of its first face
    std::uint32_t blocked = 0;  // rays
};

bool is_small(const ClusterTree::Node& node) {
    constexpr std::uint32_t kFaces = 24;
    return node.end - node.begin <= kFaces;
}

// Looks around on the faces of one instance, many at a time.
class Surveyor {
  public:
    Surveyor(const Scene& scene, std::uint32_t instance, const RayTracer& tracer)
        : scene_(scene),
          instance_(instance),
          tracer_(tracer),
          reach_(kRoom * scene.instances[instance].bounds.diameter()) {}

    // Faces of one node of the cluster tree, of this size [m]; those that lie alike may be looked at together.
    void add(std::span<const std::uint32_t> triangles, bool together, float size) {
        const std::size_t first = groups_.size();
        for (const std::uint32_t triangle : triangles) {
            const Vec3 front = normalize_or_zero(world_area_vector(scene_, instance_, triangle));
            const Sides sides = scene_.sides_of(instance_, triangle);
            for (const bool back : {false, true}) {
                if (has_side(sides, back)) {
                    const FaceSide face{triangle, back, back ? -front : front};
                    group_for(face, together ? first : groups_.size(), size).faces.push_back(face);
                }
            }
        }
    }

    void survey(std::vector<Exposure>& exposure) {
        look(0, kFirstRays);
        const auto doubtful =
            std::partition(groups_.begin(), groups_.end(), [](const Group& group) { return group.blocked == 0; });
        for (auto group = groups_.begin(); group < doubtful; ++group) {
            set(*group, 1, exposure);
        }
        groups_.erase(groups_.begin(), doubtful);
        look(kFirstRays, kRays);
        for (const Group& group : groups_) {
            set(group, 1 - static_cast<float>(group.blocked) / kRays, exposure);
        }
        groups_.clear();
    }

  private:
    Group& group_for(const FaceSide& face, std::size_t first, float size) {
        const Vec3 position = world_triangle(scene_, instance_, face.triangle)[0];
        for (std::size_t i = first; i < groups_.size(); ++i) {
            const Vec3 normal = groups_[i].faces.front().normal;
            if (dot(normal, face.normal) > kAligned &&
                std::abs(dot(position - groups_[i].position, normal)) < kThickness * size) {
                return groups_[i];
            }
        }
        groups_.push_back({{}, position, 0});
        return groups_.back();
    }

    static void set(const Group& group, float open, std::vector<Exposure>& exposure) {
        const float exposed = std::clamp((open - kCovered) / (kExposed - kCovered), kLeast, 1.0F);
        const float sheltered = std::max(kLeast, exposed * (1 - open));
        for (const FaceSide& face : group.faces) {
            Exposure& result = exposure[face.triangle];
            (face.back ? result.back : result.front) = exposed;
            (face.back ? result.back_shelter : result.front_shelter) = sheltered;
        }
    }

    // Rays [first, last) of every group; those that the instance blocks are counted.
    void look(std::uint32_t first, std::uint32_t last) {
        rays_.clear();
        for (const Group& group : groups_) {
            const Sequence4 sequence(hash64(scene_.instances[instance_].stable_id, group.faces.front().triangle));
            for (std::uint32_t k = first; k < last; ++k) {
                const FaceSide& face = group.faces[k * group.faces.size() / kRays];
                const auto corner = world_triangle(scene_, instance_, face.triangle);
                const Vec3 w = square_to_triangle(sequence(k, 0), sequence(k, 1));
                const Vec3 x = w.x * corner[0] + w.y * corner[1] + w.z * corner[2];
                const Vec3 direction = square_to_cosine_hemisphere(sequence(k, 2), sequence(k, 3));
                rays_.push_back(
                    {offset_origin(x, face.normal, reach_), Frame(face.normal).to_world(direction), 0, reach_});
            }
        }
        hits_.resize(rays_.size());
        tracer_.closest_hits(rays_, hits_, RayMask::kLight, Coherence::kIncoherent);
        for (std::size_t i = 0; i < hits_.size(); ++i) {
            groups_[i / (last - first)].blocked += hits_[i].instance == instance_ ? 1 : 0;
        }
    }

    const Scene& scene_;
    std::uint32_t instance_;
    const RayTracer& tracer_;
    float reach_;
    std::vector<Group> groups_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
};

}  // namespace

std::vector<Exposure> find_exposure(const Scene& scene, std::uint32_t instance, const ClusterTree& tree,
                                    const RayTracer& tracer, const Control& control) {
    const Affine& to_world = scene.instances[instance].to_world;
    std::vector<Exposure> exposure(tree.order.size(), {0, 0, 0, 0});
    parallel_blocks(tree.nodes.size(), kNodes, control, [&](std::size_t begin, std::size_t end) {
        Surveyor surveyor(scene, instance, tracer);
        const auto add = [&](const ClusterTree::Node& node, std::uint32_t last, bool together) {
            const std::span<const std::uint32_t> faces(tree.order.data() + node.begin, last - node.begin);
            surveyor.add(faces, together, transformed(node.bounds, to_world).diameter());
        };
        for (std::size_t i = begin; i < end; ++i) {
            const ClusterTree::Node& node = tree.nodes[i];
            if (i == 0 && is_small(node)) {
                add(node, node.end, true);
            }
            if (is_small(node)) {
                continue;
            }
            add(node, node.direct_end, false);
            for (std::uint32_t child = node.first_child; child < node.first_child + node.child_count; ++child) {
                if (is_small(tree.nodes[child])) {
                    add(tree.nodes[child], tree.nodes[child].end, true);
                }
            }
        }
        surveyor.survey(exposure);
    });
    return exposure;
}

}  // namespace gg
