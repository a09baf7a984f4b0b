// What a render is made from, in a file: to render it again without Blender, to profile it, to hold it against slow
// truths.
#pragma once

#include <string>

#include "render/pipeline.h"
#include "scene/description.h"

namespace gg {

struct Capture {
    SceneDescription scene;
    RenderSettings settings;
};

// Images that the scene names by path stay where they are. A file that is there is replaced once the new one is whole.
// Throws Error(GG_IO_ERROR).
void write_capture(const SceneDescription& scene, const RenderSettings& settings, const std::string& path);

// Throws Error(GG_IO_ERROR) for what cannot be read, or was not written by this version of the library. Indices within
// the capture are not checked.
[[nodiscard]] Capture read_capture(const std::string& path);

}  // namespace gg
