// Scenes that gathers are tested on, and a view of each.
#pragma once

#include "support/test_scenes.h"

namespace gg::test {

// A scene and where it is looked at from.
struct ViewedScene {
    SceneDescription description;
    CameraDescription camera;
};

// See law_scenes.h.
[[nodiscard]] ViewedScene viewed_lamp_room();
[[nodiscard]] ViewedScene viewed_mixed_scene();

// A furnished room of 4 x 3 x 2.5 m under sun and sky, with a window of 1.2 x 1 m in the wall at +y.
[[nodiscard]] ViewedScene viewed_window_room();

// A floor (instance 0) below two slanted glowing panels and two lamps, with nothing that stands in the way of anything.
[[nodiscard]] ViewedScene viewed_stage();

// The room with the window, a lamp and twelve finely tessellated spheres, 330,000 triangles in all.
[[nodiscard]] ViewedScene viewed_furnished_room();

// The room with the window and three clouds of `count` leaves each.
[[nodiscard]] ViewedScene viewed_jungle(std::uint32_t count);

}  // namespace gg::test
