// From fragments to pixels: light at every fragment, and at parts of theirs where it jumps.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "film/film.h"
#include "film/fragments.h"
#include "film/solution_view.h"
#include "gather/gather_counts.h"
#include "gather/shade.h"
#include "gather/shared_light.h"
#include "perception/masking.h"

namespace gg {

class Control;
class Statistics;

// Works out light; for one thread.
class Gatherer {
  public:
    virtual ~Gatherer() = default;

    // Neighbours are faster together. known, light, taken: of each; what it took.
    virtual void shade(std::span<const Fragment> fragments, std::span<const KnownLight> known,
                       std::span<PointLight> light, std::span<PointCounts> taken) = 0;
    // The same for parts of a fragment that has been shaded: what is known of the light around it does for them, too,
    // though they may lie where nothing else was seen. soft: of that fragment.
    virtual void shade_parts(const Fragment& whole, Rgb soft, std::span<const Fragment> parts,
                             std::span<PointLight> light, std::span<PointCounts> taken) = 0;
    [[nodiscard]] virtual const GatherCounts& counts() const = 0;  // of all that it did
    // The cell of the grid that a fragment lies in, 0 without a grid.
    [[nodiscard]] virtual std::uint32_t cell_of(const Fragment& fragment) const = 0;
    // Error of radiosity that a sender may have around a fragment [W/m2], 0 without an observer.
    [[nodiscard]] virtual float threshold_at(const Fragment& fragment) const = 0;
};

// Fills the film and its passes. tiles: of the film, in its order. seen: of the whole film; null without an observer.
// make: called once for each tile and thread. Reports stage progress. Throws Cancelled.
ViewCounts light_tiles(const View& view, std::span<const TileFragments> tiles, const MaskingMap* seen,
                       const Sharing& sharing, const std::function<std::unique_ptr<Gatherer>()>& make, Film& film,
                       Control& control, Statistics& statistics);

}  // namespace gg
