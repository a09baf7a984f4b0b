// From the interface's camera and settings to ours, defaults filled in.
#pragma once

#include "gridgather.h"
#include "render/pipeline.h"

namespace gg {

// Throws Error: GG_INVALID_SCENE without a camera, GG_INVALID_ARGUMENT for numbers out of range.
[[nodiscard]] DisplaySettings convert_display(const gg_display& display);
[[nodiscard]] RenderSettings convert_settings(const gg_camera* camera, const gg_settings& settings);

}  // namespace gg
