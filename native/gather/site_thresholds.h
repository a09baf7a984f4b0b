// Which errors somebody who looks at the picture would see around sites [Scheel et al. 2002, section 5.2].
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "film/fragments.h"
#include "perception/masking.h"
#include "perception/viewing.h"
#include "radiosity/solution.h"

namespace gg {

class Control;

// Who looks at the picture, and where.
struct Observer {
    // From scene-linear pixels to the light of a display, linear, 0..1 of its white. For many threads at once.
    std::function<void(std::span<Rgb>)> display;
    Viewing viewing;
    float noticeable = 0.25F;  // error that one sender may have, in just noticeable differences
    bool masking = true;       // patterns hide errors
};

// What an observer of the radiosity solution's picture is used to, and what patterns hide there: elevation is 1
// everywhere without masking. tiles: of all of the view's crop. Throws Cancelled.
[[nodiscard]] MaskingMap observe(const Observer& observer, const Solution& solution, const View& view,
                                 std::span<const TileFragments> tiles, const Control& control);

// What is seen around a site: means over the fragments of its cells or triangles.
struct SiteView {
    Rgb radiance{0.0F};    // reflected, by the radiosity solution
    float adaptation = 0;  // cd/m2
    float elevation =
        1;  // of the threshold, by patterns: nearer to the least, for an error is seen where nothing hides it
};

// For each site the error of radiosity [W/m2], in light of its own brightness, that shows as observer.noticeable;
// exposure: of the view. All are > 0 unless every site is black. Throws Cancelled.
[[nodiscard]] std::vector<float> noticeable_radiosity(const Observer& observer, std::span<const SiteView> sites,
                                                      float exposure, const Control& control);

}  // namespace gg
