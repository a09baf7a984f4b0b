// Refinement replaces links by links between children and loses no pair: every receiving point is linked to every
// sending point exactly once, unless no light can pass.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/random.h"
#include "support/face_points.h"
#include "support/law_scenes.h"
#include "support/solution_measures.h"
#include "transport/emitter_sampling.h"

namespace gg::test {
namespace {

class LinkCover {
  public:
    explicit LinkCover(const Solution& solution) : solution_(solution), nodes_(solution.hierarchy.nodes()) {
        links_of_.resize(nodes_.size());
        for (const Link& link : solution.links.all) {
            links_of_[link.receiver].push_back(link.sender);
        }
    }

    // Links through which each node sends to `receiver`: between any of its ancestors and any of the receiver's.
    std::vector<int> counts(NodeId receiver) const {
        std::vector<int> counts(nodes_.size());
        for (NodeId id = receiver; id != kNone; id = nodes_[id].parent) {
            for (const NodeId sender : links_of_[id]) {
                ++counts[sender];
            }
        }
        for (NodeId id = 0; id < nodes_.size(); ++id) {  // children come after their parents
            if (nodes_[id].parent != kNone) {
                counts[id] += counts[nodes_[id].parent];
            }
        }
        return counts;
    }

  private:
    const Solution& solution_;
    const std::vector<Node>& nodes_;
    std::vector<std::vector<NodeId>> links_of_;
};

// Whether any of some random points of the two face each other.
bool can_exchange(const Solution& solution, const Node& receiver, const Node& sender) {
    constexpr std::uint32_t kPairs = 32;
    const Sequence6 sequence(hash64(receiver.stable_id, sender.stable_id));
    const FacePoints receiver_points(solution.hierarchy, receiver);
    for (std::uint32_t i = 0; i < kPairs; ++i) {
        const EvenPoint x = receiver_points.sample(sequence(i, 0), sequence(i, 1), sequence(i, 2));
        Vec3 direction(0.0F);
        if (sender.kind == NodeKind::kSky) {
            direction = cell_direction(sky_cell_of(sender), sequence(i, 3), sequence(i, 4));
        } else if (sender.kind == NodeKind::kLamp) {
            const LampSample sample = sample_lamp(solution.hierarchy.scene().lamps[sender.source], x.position,
                                                  sequence(i, 3), sequence(i, 4));
            direction = luminance(sample.normal_irradiance) > 0 ? sample.direction : Vec3(0.0F);
        } else {
            const EvenPoint y =
                FacePoints(solution.hierarchy, sender).sample(sequence(i, 5), sequence(i, 3), sequence(i, 4));
            const Vec3 apart = y.position - x.position;
            direction = dot(y.normal, apart) < -1e-5F ? apart : Vec3(0.0F);
        }
        if (dot(x.normal, direction) > 1e-5F) {
            return true;
        }
    }
    return false;
}

TEST(LinksCoverOnce, every_receiver_is_linked_to_every_sender_once) {
    Prepared prepared(mixed_scene());
    const auto solution = prepared.solve(0.08F);
    const Hierarchy& hierarchy = solution->hierarchy;
    const LinkCover cover(*solution);
    const auto receivers = surface_leaves(*solution);
    std::size_t clusters = 0, linked = 0, left_out = 0, of_lamps = 0, of_sky = 0;
    for (const NodeId receiver : receivers) {
        const auto counts = cover.counts(receiver);
        clusters += is_cluster(hierarchy[receiver]);
        for (NodeId sender = 0; sender < hierarchy.nodes().size(); ++sender) {
            if (hierarchy[sender].child_count > 0) {
                continue;
            }
            ASSERT_LE(counts[sender], 1) << "receiver " << receiver << " sender " << sender;
            linked += counts[sender];
            of_lamps += counts[sender] == 1 && hierarchy[sender].kind == NodeKind::kLamp;
            of_sky += counts[sender] == 1 && hierarchy[sender].kind == NodeKind::kSky;
            if (counts[sender] == 0) {
                ++left_out;
                ASSERT_FALSE(can_exchange(*solution, hierarchy[receiver], hierarchy[sender]))
                    << "receiver " << receiver << " sender " << sender;
            }
        }
    }
    // Nothing is proven by a scene that has no such pairs.
    EXPECT_GT(receivers.size(), 500U);
    EXPECT_GT(clusters, 10U);
    EXPECT_GT(linked, 100000U);
    EXPECT_GT(left_out, 100000U);
    EXPECT_GT(of_lamps, 500U);
    EXPECT_GT(of_sky, 500U);
}

}  // namespace
}  // namespace gg::test
