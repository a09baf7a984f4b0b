// Scenes that several laws are tested on. Rooms are 4 x 3 x 2.5 m boxes of six quads, instances 0 to 5.
#pragma once

#include "support/test_scenes.h"

namespace gg::test {

inline constexpr Vec3 kRoomSize{4.0F, 3.0F, 2.5F};

// A cube (instance 6) and a finely tessellated sphere (instance 7) in the room, floating.
void add_furniture(SceneBuilder& builder, std::uint32_t material);

// Every face has this reflectance and emits radiosity 1 W/m2.
[[nodiscard]] SceneDescription furnace(float reflectance, bool furnished);

// The furnished room of one grey with a square lamp of 100 W below its ceiling.
[[nodiscard]] SceneDescription lamp_room(float reflectance);

// Everything that a solve may meet: a furnished room that is open to the sky at +y, with a sun, an area lamp, a point
// lamp, a floor with a texture, a glowing wall and two clouds of small faces.
[[nodiscard]] SceneDescription mixed_scene();

// What the lamps of a scene emit, W, luminance. Rectangles only.
[[nodiscard]] double lamp_power(const Scene& scene);

}  // namespace gg::test
