// The iteration ends even where sampled links send on more than they get.
#include <gtest/gtest.h>

#include "support/law_scenes.h"

namespace gg::test {
namespace {

// Two facing plates that send each other `factor` of their radiosity.
struct Plates {
    explicit Plates(float factor) {
        SceneBuilder builder;
        const std::uint32_t bright = builder.material(Rgb(0.9F), Rgb(1 / kPi));
        builder.quad({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, bright, "below");
        builder.quad({0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}, bright, "above");
        prepared = std::make_unique<Prepared>(builder.description);
        hierarchy = std::make_unique<Hierarchy>(prepared->scene, *prepared->colors, prepared->faces());
        for (int level = 0; level < 4; ++level) {
            std::vector<NodeId> leaves;
            for (NodeId id = 0; id < hierarchy->nodes().size(); ++id) {
                if (is_cluster((*hierarchy)[id]) && (*hierarchy)[id].child_count == 0) {
                    leaves.push_back(id);
                }
            }
            hierarchy->open(leaves, prepared->control);
        }
        lighting = std::make_unique<Lighting>(*hierarchy);
        lighting->grow(prepared->control);
        std::vector<NodeId> elements;
        for (NodeId id = 0; id < hierarchy->nodes().size(); ++id) {
            if ((*hierarchy)[id].kind == NodeKind::kElement) {
                elements.push_back(id);
            }
        }
        for (const NodeId receiver : elements) {
            for (const NodeId sender : elements) {
                Link link;
                link.receiver = receiver;
                link.sender = sender;
                link.shape = Vec3(1);
                link.form_factor = factor / static_cast<float>(elements.size());
                link.visibility = 1;
                links.all.push_back(link);
            }
        }
        element = elements.front();
        lighting->set_links(links, prepared->control);
        lighting->clear(prepared->control);
    }
    std::unique_ptr<Prepared> prepared;
    std::unique_ptr<Hierarchy> hierarchy;
    std::unique_ptr<Lighting> lighting;
    Links links;
    NodeId element = 0;
};

TEST(Settle, sums_a_geometric_series) {
    Plates plates(0.5F);
    EXPECT_LT(plates.lighting->settle(200, 1e-6, plates.prepared->control), 30);
    // All radiosities are B = 1 + 0.9 * 0.5 B.
    EXPECT_NEAR(plates.lighting->radiosity(plates.element).g, 1 / (1 - 0.45F), 1e-4F);
}

TEST(Settle, ends_where_links_multiply_light) {
    Plates plates(1.5F);
    EXPECT_LT(plates.lighting->settle(400, 1e-4, plates.prepared->control), 400);
    const float radiosity = plates.lighting->radiosity(plates.element).g;
    EXPECT_TRUE(std::isfinite(radiosity));
    EXPECT_LT(radiosity, 1e4F);
}

}  // namespace
}  // namespace gg::test
