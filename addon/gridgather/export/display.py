"""How the scene is shown: Blender's colour management, and the display in front of the observer."""

import math
import os

import bpy

from ..description import Display, Scene

_INCH = 0.0254  # m


def export_display(scene, out: Scene) -> Display:
    """The scene's view transform as Blender's own OpenColorIO configuration has it."""
    view, own = scene.view_settings, scene.gridgather
    if view.use_curve_mapping:
        out.say("Color Management", "curves are not taken into account where errors are judged")
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
        pixels_per_degree=math.tan(math.radians(1)) * own.viewing_distance * own.display_density / _INCH,
    )


def config_path() -> str:
    """The file that Blender reads: $OCIO if there is one, else its own; "" if neither can be found."""
    folder = bpy.utils.system_resource("DATAFILES", path="colormanagement") or ""
    for path in (os.environ.get("OCIO", ""), os.path.join(folder, "config.ocio")):
        if os.path.isfile(path):
            return path
    return ""
