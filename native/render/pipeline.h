// The pipeline on one page: description -> scene -> lighting -> picture.
#pragma once

#include <cstdint>
#include <optional>

#include "film/passes.h"
#include "film/pixel_filter.h"
#include "film/solution_view.h"
#include "gather/render_gather.h"
#include "image/display_transform.h"
#include "scene/description.h"

namespace gg {

class Control;
class Film;
class Messages;
class Statistics;
struct SceneCache;

// How the picture is made from the radiosity solution.
enum class Method { kGather, kSolution, kFull };

struct RenderSettings {
    Method method = Method::kSolution;
    CameraDescription camera;
    std::uint32_t width = 1, height = 1;  // of the full picture, pixels
    ViewSettings view;
    FilterType filter_type = FilterType::kBlackmanHarris;
    float filter_width = 1.5F;  // pixels
    float quality = 0.02F;      // see SolveSettings
    int threads = 0;            // 0: all cores
    PassSet passes;             // of the film
    GatherSettings gather;
    std::optional<DisplaySettings> display;  // on which the final gather's errors are judged
    Viewing viewing;
    float noticeable = 0.25F;  // see Observer
    bool masking = false;
};

// Fills the film, which has the size of settings.view.crop. Throws Cancelled or Error; statistics and messages then
// hold what was found until there.
void render(SceneCache& cache, const RenderSettings& settings, Film& film, Control& control, Messages& messages,
            Statistics& statistics);

}  // namespace gg
