// Hierarchies all of whose clusters are opened, so that every triangle is an element or two.
#pragma once

#include <cstddef>
#include <vector>

#include "radiosity/lighting.h"
#include "support/test_scenes.h"

namespace gg::test {

inline void open_clusters(Hierarchy& hierarchy, const Control& control) {
    for (NodeId id = 0; id < hierarchy.nodes().size(); ++id) {
        if (is_cluster(hierarchy[id])) {
            hierarchy.open(std::vector<NodeId>{id}, control);
        }
    }
}

// A scene like that, with no light as yet.
struct OpenedClusters {
    Prepared prepared;
    Hierarchy hierarchy{prepared.scene, *prepared.colors, prepared.faces()};
    Lighting lighting{hierarchy};
    std::size_t before = 0;  // nodes

    explicit OpenedClusters(const SceneDescription& description) : prepared(description) {
        open_clusters(hierarchy, prepared.control);
        lighting.grow(prepared.control);
        before = hierarchy.nodes().size();
    }
};

}  // namespace gg::test
