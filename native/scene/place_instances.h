// Instances in the world: matrices checked, normals' matrices and bounds, and which ones have something inside.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "scene/description.h"
#include "scene/scene.h"

namespace gg {

class Control;
class Messages;

// The map itself when it can be inverted. Nothing when it collapses space to a line or point, or is not finite. A map
// that flattens one axis alone, as a scale of (1, 1, 0) does, is common for planes, and Cycles shows it: that axis gets
// a length again, enough to invert and too little to see (any length at all when the mesh is flat along it anyway).
[[nodiscard]] std::optional<Affine> make_invertible(const Affine& map, const Box& mesh_bounds);

// Of meshes that have triangles, in the description's order. A message for each that cannot be placed.
// `list_count`: number of material lists; an index beyond them reads as the last.
[[nodiscard]] std::vector<Instance> place_instances(std::span<const InstanceDescription> instances,
                                                    std::span<const Mesh> meshes, std::size_t list_count,
                                                    Messages& messages);

// Sets Instance::encloses: a lamp with a position, or another instance's bounds as a whole, lies in the bounds.
void mark_enclosing(std::vector<Instance>& instances, std::span<const Lamp> lamps, const Control& control);

}  // namespace gg
