"""Rendering to arrays."""

import bpy
import numpy as np
import OpenImageIO as oiio


def render_pixels(scene, engine, name="picture.exr"):
    """float32 (height, width, 4) of F12 with an engine, bottom row first, through a 32-bit OpenEXR file."""
    scene.render.engine = engine
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
    scene.render.filepath = bpy.app.tempdir + name
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)


def cycles_pixels(scene, samples):
    """render_pixels() of Cycles on the CPU, towards its limit."""
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.use_denoising, cycles.use_adaptive_sampling = "CPU", samples, False, False
    cycles.max_bounces = cycles.diffuse_bounces = 32
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    return render_pixels(scene, "CYCLES", "cycles.exr")


def multilayer(scene) -> dict:
    """Channels by name, each float32 (height, width), top row first, of an F12 into a multilayer file."""
    scene.render.engine = "GRIDGATHER"
    settings = scene.render.image_settings
    settings.file_format, settings.color_depth = "OPEN_EXR_MULTILAYER", "32"
    scene.render.filepath = bpy.app.tempdir + "layers.exr"
    bpy.ops.render.render(write_still=True)
    picture = oiio.ImageInput.open(scene.render.filepath)  # not from a cache
    return dict(zip(picture.spec().channelnames, np.moveaxis(picture.read_image(oiio.FLOAT), 2, 0)))
