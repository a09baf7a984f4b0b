// The description's images as textures, in the same order: image ids index both.
#pragma once

#include "image/texture.h"
#include "scene/description.h"

namespace gg {

class Control;
class Messages;

// Unreadable images become messages, see TextureSet. Keeps nothing of the description.
[[nodiscard]] TextureSet load_textures(const SceneDescription& description, const Control& control, Messages& messages);

}  // namespace gg
