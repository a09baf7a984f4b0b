// Where a sender stands as seen by receivers.
#pragma once

#include "core/vec.h"
#include "radiosity/hierarchy.h"
#include "scene/scene.h"

namespace gg {

// All of the sender lies below the horizon of a point with this unit normal, or part of it may.
[[nodiscard]] bool is_below_horizon(const Scene& scene, const Node& sender, Vec3 position, Vec3 normal);
[[nodiscard]] bool crosses_horizon(const Scene& scene, const Node& sender, Vec3 position, Vec3 normal);

// Whether it is a surface that does not glow.
[[nodiscard]] inline bool is_soft(const Node& sender) {
    return sender.kind != NodeKind::kLamp && sender.emission == Rgb(0.0F);
}

// Too close to the box for a few points of it to tell how much the sender's form factor varies there.
[[nodiscard]] bool is_close(const Scene& scene, const Node& sender, const Box& receivers);

}  // namespace gg
