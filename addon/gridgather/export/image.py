"""Images: by file where the file is what Blender shows, else by pixels."""

import os

import bpy
import numpy as np

from .. import description
from ..description import COLOR_LINEAR, COLOR_SRGB, NONE

_EXTENSIONS = {
    "REPEAT": description.EXTENSION_REPEAT,
    "EXTEND": description.EXTENSION_EXTEND,
    "CLIP": description.EXTENSION_CLIP,
    "MIRROR": description.EXTENSION_MIRROR,
}
_LINEAR_SPACES = {"Non-Color", "Linear", "Raw", "Linear Rec.709", "scene_linear"}
_PARTIAL = {
    "TILED": "only the first tile is used",
    "SEQUENCE": "only one frame is used",
    "MOVIE": "only one frame is used",
}


class ImageExport:
    """Collects each image once per way of reading it."""

    def __init__(self, scene: description.Scene):
        self._scene = scene
        self._indices: dict[tuple, int] = {}

    def index(self, node) -> int:
        """Index of an Image Texture node's image, or NONE when it has none."""
        image = node.image
        if image is None:
            return NONE
        key = (image.name_full, node.extension, node.interpolation == "Closest")
        if key not in self._indices:
            exported = export_image(image, self._scene)
            exported.extension = _EXTENSIONS.get(node.extension, description.EXTENSION_REPEAT)
            exported.filter_mode = description.FILTER_CLOSEST if key[2] else description.FILTER_LINEAR
            self._scene.images.append(exported)
            self._indices[key] = len(self._scene.images) - 1
        return self._indices[key]


def export_image(image, scene: description.Scene) -> description.Image:
    """The image without the settings that belong to a node. Says what could not be kept to `scene`."""
    if image.source in _PARTIAL:
        scene.say(image.name, f"image of source {image.source}: {_PARTIAL[image.source]}")
    path = _file_path(image)
    space = _color_space(image, scene)
    if path is not None:
        return description.Image(image.name, path=path, color_space=space)
    pixels = _pixels(image)
    if pixels is None:
        scene.say(image.name, "image has no pixels: shown in magenta")
        return description.Image(image.name, pixels=np.array([[[1, 0, 1, 1]]], np.float32), color_space=COLOR_LINEAR)
    # Byte pixels are in the file's colour space; float pixels were made scene-linear when they were loaded.
    return description.Image(image.name, pixels=pixels, color_space=COLOR_LINEAR if image.is_float else space)


def _file_path(image) -> str | None:
    """Absolute path of the file, or None when only Blender has the pixels."""
    if image.source not in {"FILE", "TILED", "SEQUENCE"} or image.packed_file is not None or image.is_dirty:
        return None
    path = bpy.path.abspath(image.filepath, library=image.library)
    if image.source == "TILED" and len(image.tiles):
        number = image.tiles[0].number
        path = path.replace("<UDIM>", str(number))
        path = path.replace("<UVTILE>", f"u{(number - 1001) % 10 + 1}_v{(number - 1001) // 10 + 1}")
    if not os.path.isfile(path) and image.has_data:
        return None
    return os.path.abspath(path)  # a missing file too: the library reports it


def _color_space(image, scene: description.Scene) -> int:
    name = image.colorspace_settings.name
    if name == "sRGB":
        return COLOR_SRGB
    if name not in _LINEAR_SPACES:
        nearest = "Linear" if name.startswith("Linear") else "sRGB"
        scene.say(image.name, f"colour space {name} is read as {nearest}")
        return COLOR_LINEAR if nearest == "Linear" else COLOR_SRGB
    return COLOR_LINEAR


def _pixels(image) -> np.ndarray | None:
    """float32 (height, width, 4), bottom row first; None when the image cannot be loaded."""
    count = len(image.pixels)  # loads the image
    width, height = image.size
    if count == 0 or width == 0 or height == 0:
        return None
    flat = np.empty(count, np.float32)
    image.pixels.foreach_get(flat)
    channels = flat.reshape(height, width, -1)
    if channels.shape[2] == 4:
        return channels
    full = np.ones((height, width, 4), np.float32)
    full[..., :3] = channels[..., :3]  # one channel spreads to three
    return full
