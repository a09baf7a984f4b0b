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
    // tiles: of the view. seen: of the picture that they make up; null: nobody looks.
    SiteReceivers(const Solution& solution, const View& view, const SitePlaces& places,
                  std::span<const TileFragments> tiles, const MaskingMap* seen, const Control& control);

    [[nodiscard]] std::size_t site_count() const { return begin_.size() - 1; }
    [[nodiscard]] std::span<const Receiver> of(std::size_t site) const {
        return std::span(receivers_).subspan(begin_[site], begin_[site + 1] - begin_[site]);
    }
    [[nodiscard]] std::span<const SiteView> views() const { return views_; }  // per site, if anybody looks
    [[nodiscard]] std::uint32_t vertex_of(std::size_t site) const { return vertices_[site]; }
    // kNone for a vertex without a site.
    [[nodiscard]] std::uint32_t site_at(std::uint32_t vertex) const { return site_of_[vertex]; }
    [[nodiscard]] float mean_radiosity() const { return mean_radiosity_; }  // reflected, of what is seen, W/m2

  private:
    std::vector<Receiver> receivers_;
    std::vector<std::uint32_t> begin_{0};
    std::vector<std::uint32_t> vertices_;  // per site
    std::vector<std::uint32_t> site_of_;   // per vertex
    std::vector<SiteView> views_;          // per site
    float mean_radiosity_ = 0;
};

}  // namespace gg
