// The sites of a picture, and from where they look around.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "gather/classify.h"
#include "gather/site_places.h"
#include "gather/site_thresholds.h"

namespace gg {

class Control;

// Visible points around every vertex that has any, chosen evenly and without regard to their order.
class SiteReceivers {
  public:
    // tiles: of the view; they, the solution and the camera of the view must outlive this. seen: of the picture that
    // they make up; null: nobody looks.
    SiteReceivers(const Solution& solution, const View& view, const SitePlaces& places,
                  std::span<const TileFragments> tiles, const MaskingMap* seen, const Control& control);

    [[nodiscard]] std::size_t site_count() const { return begin_.size() - 1; }
    [[nodiscard]] std::vector<Receiver> of(std::size_t site) const;
    [[nodiscard]] std::span<const SiteView> views() const { return views_; }  // per site, if anybody looks
    [[nodiscard]] std::uint32_t vertex_of(std::size_t site) const { return vertices_[site]; }
    // kNone for a vertex without a site.
    [[nodiscard]] std::uint32_t site_at(std::uint32_t vertex) const { return site_of_[vertex]; }
    [[nodiscard]] std::size_t bytes() const {
        return seen_.capacity() * sizeof(SeenPlace) + site_of_.capacity() * sizeof(std::uint32_t);
    }
    [[nodiscard]] float mean_radiosity() const { return mean_radiosity_; }  // reflected, of what is seen, W/m2

  private:
    // A receiver takes five times the memory.
    struct SeenPlace {
        std::uint32_t tile = 0, fragment = 0;
        NodeId place = kNone;
    };
    [[nodiscard]] Receiver receiver(const SeenPlace& seen) const;

    const Solution& solution_;
    const PixelCamera& camera_;
    std::span<const TileFragments> tiles_;
    std::vector<SeenPlace> seen_;
    std::vector<std::uint32_t> begin_{0};
    std::vector<std::uint32_t> vertices_;  // per site
    std::vector<std::uint32_t> site_of_;   // per vertex
    std::vector<SiteView> views_;          // per site
    float mean_radiosity_ = 0;
};

}  // namespace gg
