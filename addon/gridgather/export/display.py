"""How the scene is shown: Blender's colour management, and the display in front of the observer."""

import math
import os

import bpy
import numpy as np

from ..description import Curves, Display, Scene

_INCH = 0.0254  # m
_CURVE_STEPS = 256


def export_display(scene, out: Scene) -> Display:
    """The scene's view transform as Blender's own OpenColorIO configuration has it."""
    view, own = scene.view_settings, scene.gridgather
    if getattr(view, "use_white_balance", False):  # older versions have none
        out.say("Color Management", "white balance is not taken into account where errors are judged")
    return Display(
        config=config_path(),
        device=scene.display_settings.display_device,
        view=view.view_transform,
        look="" if view.look.lower() == "none" else view.look,
        exposure=view.exposure,
        gamma=view.gamma,
        white=own.display_white,
        black=own.display_black,
        curves=_curves(view.curve_mapping) if view.use_curve_mapping else None,
        pixels_per_degree=math.tan(math.radians(1)) * own.viewing_distance * own.display_density / _INCH,
    )


def _curves(mapping) -> Curves:
    """Each channel's curve and then the one for all of them, in as many steps as Blender's own tables have."""
    mapping.initialize()
    *channels, combined = mapping.curves
    lower, upper = mapping.clip_min_x, mapping.clip_max_x
    steps = np.linspace(lower, upper, _CURVE_STEPS + 1)

    def slope(curve, x, outwards):
        return (mapping.evaluate(curve, x + outwards) - mapping.evaluate(curve, x)) / outwards

    values = [[mapping.evaluate(combined, mapping.evaluate(channel, x)) for x in steps] for channel in channels]
    slopes = [
        slope(channel, x, outwards) * slope(combined, x, outwards)
        for channel in channels
        for x, outwards in ((lower, -1), (upper, 1))
    ]
    return Curves(
        np.array(values, np.float32),
        (lower, upper),
        tuple(slopes),
        tuple(mapping.black_level),
        tuple(mapping.white_level),
    )


def config_path() -> str:
    """The file that Blender reads: $OCIO if there is one, else its own; "" if neither can be found."""
    folder = bpy.utils.system_resource("DATAFILES", path="colormanagement") or ""
    for path in (os.environ.get("OCIO", ""), os.path.join(folder, "config.ocio")):
        if os.path.isfile(path):
            return path
    return ""
