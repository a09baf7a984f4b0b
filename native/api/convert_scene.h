// From the interface's structs to descriptions. All throw Error(GG_INVALID_ARGUMENT) for null pointers, sizes, ids and
// enumerators out of range. Geometry and lamps that make no sense are the scene builder's to name in messages.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gridgather.h"
#include "scene/description.h"

namespace gg {

[[nodiscard]] ImageDescription convert(const gg_image& image);
[[nodiscard]] MaterialDescription convert(const gg_material& material, std::size_t image_count);
[[nodiscard]] MeshDescription convert(const gg_mesh& mesh);
[[nodiscard]] LightDescription convert(const gg_light& light);
// `materials`: index of their material list in `scene`.
[[nodiscard]] std::vector<InstanceDescription> convert(const gg_instances& instances, const SceneDescription& scene,
                                                       std::uint32_t materials);
// The slots of the instances as a list of materials.
[[nodiscard]] std::vector<std::uint32_t> convert_slots(const gg_instances& instances, std::size_t material_count);
[[nodiscard]] Rgb convert_world(const float* radiance);

[[nodiscard]] std::string text(const char* value);  // null reads as ""
// 3x4 row-major.
[[nodiscard]] Affine convert_matrix(const float* matrix);

}  // namespace gg
