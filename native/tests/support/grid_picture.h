// A small picture with the gather's sites, as rendering makes them.
#pragma once

#include <vector>

#include "film/view.h"
#include "gather/shade.h"
#include "gather/site_places.h"
#include "gather/site_receivers.h"
#include "support/test_scenes.h"

namespace gg::test {

// At `eye`, looking at `target`, Z up, 70 degrees wide.
[[nodiscard]] CameraDescription camera_at(Vec3 eye, Vec3 target);

struct PictureSettings {
    std::uint32_t width = 160, height = 80;
    float cell = 16;  // side of a grid cell, pixels
    float threshold = 0.03F;
    int samples = 512;
    bool surfaces = true;  // have sites of their own where they are large
};

// A visible point of a triangle's front; weights of corners 1 and 2.
[[nodiscard]] Fragment fragment_at(const Scene& scene, std::uint32_t instance, std::uint32_t triangle, Vec2 weights);

class GridPicture {
  public:
    GridPicture(const GridPicture&) = delete;
    GridPicture& operator=(const GridPicture&) = delete;
    GridPicture(const SceneDescription& description, const CameraDescription& camera, const PictureSettings& settings);

    // A fragment among the sites around it; but vertices that have none.
    [[nodiscard]] PlacedFragment place(const Fragment& at) const;
    [[nodiscard]] Shader shader() const { return {*solution, order, points, *prepared.tracer}; }
    // About `count` of what is seen, evenly over the picture.
    [[nodiscard]] std::vector<Fragment> some_fragments(std::size_t count) const;

    Prepared prepared;
    std::shared_ptr<const Solution> solution;
    ClusterPoints points;
    NodeOrder order;
    View view;
    std::vector<TileFragments> tiles;
    PerspectiveGrid grid;
    SurfaceMesh surfaces;
    SitePlaces places;
    SiteReceivers receivers;
    std::vector<Site> sites;
};

// Irradiance at points, shaded together, W/m2.
[[nodiscard]] std::vector<Rgb> light_at(Shader& shader, const std::vector<PlacedFragment>& points);

}  // namespace gg::test
