#include "scene/load_textures.h"

#include <vector>

namespace gg {

namespace {

Wrap wrap_of(Extension extension) {
    switch (extension) {
        case Extension::kExtend:
            return Wrap::kExtend;
        case Extension::kClip:
            return Wrap::kClip;
        case Extension::kMirror:
            return Wrap::kMirror;
        default:
            return Wrap::kRepeat;
    }
}

}  // namespace

TextureSet load_textures(const SceneDescription& description, const Control& control, Messages& messages) {
    std::vector<ImageSource> sources;
    sources.reserve(description.images.size());
    for (const ImageDescription& image : description.images) {
        sources.push_back({image.name, image.path, image.pixels, image.width, image.height,
                           image.color_space == ColorSpace::kSrgb, wrap_of(image.extension),
                           image.filter_mode == FilterMode::kClosest});
    }
    return {sources, control, messages};
}

}  // namespace gg
