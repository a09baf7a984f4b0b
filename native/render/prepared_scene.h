// A scene made ready for light and rays, kept for further renders of it together with the lighting solved so far.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/messages.h"
#include "image/texture.h"
#include "material/surface_color.h"
#include "radiosity/solution.h"
#include "scene/description.h"
#include "scene/scene.h"
#include "trace/ray_tracer.h"

namespace gg {

class Control;
class Statistics;

// Later members refer to earlier ones.
struct PreparedScene {
    Scene scene;
    TextureSet textures;
    std::optional<SurfaceColors> colors;
    std::unique_ptr<RayTracer> tracer;
    std::vector<Message> messages;  // what was left out or replaced
};

// The work that renders of one scene share. `description` is the caller's until the first render, ours from then on.
struct SceneCache {
    SceneDescription description;  // emptied once `prepared` stands

    std::timed_mutex mutex;  // guards all but the description; held for as long as its work takes
    std::shared_ptr<const PreparedScene> prepared;
    std::map<float, std::shared_ptr<const Solution>> solutions;  // by quality; they refer to `prepared`
};

// Builds it, or takes it from the cache; messages reach this render either way. Renders that come meanwhile wait.
// Throws Cancelled, and the cache then stays as it was.
[[nodiscard]] std::shared_ptr<const PreparedScene> prepare_scene(SceneCache& cache, Control& control,
                                                                 Messages& messages, Statistics& statistics);

// Solves the lighting or takes it from the cache, in the same way. `prepared` has to be the cache's.
[[nodiscard]] std::shared_ptr<const Solution> solve_lighting(SceneCache& cache, const PreparedScene& prepared,
                                                             float quality, Control& control, Statistics& statistics);

}  // namespace gg
