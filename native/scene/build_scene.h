// From what the user asked for to what the stages read: validates, converts, and says what was left out.
#pragma once

#include "scene/description.h"
#include "scene/scene.h"

namespace gg {

class Control;
class Messages;

// Never fails on bad data: broken triangles, instances and lamps are left out, one message per object and kind. The
// result's instances are all of non-empty meshes; meshes keep their index. Throws Cancelled.
[[nodiscard]] Scene build_scene(const SceneDescription& description, const Control& control, Messages& messages);

}  // namespace gg
