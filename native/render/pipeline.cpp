#include "render/pipeline.h"

#include <optional>

#include "core/control.h"
#include "core/messages.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "film/solution_view.h"
#include "gather/render_gather.h"
#include "radiosity/solution.h"
#include "render/prepared_scene.h"

namespace gg {

namespace {

ViewCounts gather(const Solution& solution, const View& view, const RenderSettings& settings, Film& film,
                  Control& control, Messages& messages, Statistics& statistics) {
    std::optional<DisplayTransform> transform;
    std::optional<Observer> observer;
    if (settings.display) {
        transform.emplace(*settings.display);
        observer.emplace();
        observer->display = [&](std::span<Rgb> pixels) { transform->show(pixels); };
        observer->viewing = settings.viewing;
        observer->noticeable = settings.noticeable;
        observer->masking = settings.masking;
        if (!transform->failure().empty()) {
            messages.add("Color Management", "errors are judged as if the display were sRGB: " + transform->failure());
        }
    }
    return grid_gather(solution, view, settings.gather, observer ? &*observer : nullptr, settings.width,
                       settings.height, film, control, statistics);
}

}  // namespace

void render(SceneCache& cache, const RenderSettings& settings, Film& film, Control& control, Messages& messages,
            Statistics& statistics) {
    run_with_threads(settings.threads, [&] {
        statistics.set_bytes("film", static_cast<double>(film.bytes()));
        const auto prepared = prepare_scene(cache, control, messages, statistics);

        control.begin_stage("lighting", 0.75F);
        const auto solution = solve_lighting(cache, *prepared, settings.quality, control, statistics);

        control.begin_stage("picture", 1.0F);
        const StageTimer timer(statistics, "picture");
        const View view{prepared->scene,
                        *prepared->tracer,
                        *prepared->colors,
                        PixelCamera(settings.camera, settings.width, settings.height),
                        PixelFilter(settings.filter_type, settings.filter_width),
                        settings.view};
        const ViewCounts counts = settings.method == Method::kSolution
                                      ? render_view(view, irradiance_by(*solution), film, control)
                                  : settings.method == Method::kFull
                                      ? full_gather(*solution, view, settings.gather.samples, film, control, statistics)
                                      : gather(*solution, view, settings, film, control, messages, statistics);
        statistics.set_count("coverage samples", static_cast<double>(counts.samples));
        statistics.set_count("dropped samples", static_cast<double>(counts.dropped));
    });
}

}  // namespace gg
