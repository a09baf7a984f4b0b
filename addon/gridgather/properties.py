"""scene.gridgather: the settings; scene.gridgather_statistics: what the last render measured."""

import bpy
from bpy.props import EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from . import messages

QUALITY = {"DRAFT": 0.08, "PREVIEW": 0.04, "FINAL": 0.02, "PAPER": 0.02}


def _apply_preset(settings, _context) -> None:
    settings.quality = QUALITY[settings.preset]


class GridgatherSettings(bpy.types.PropertyGroup):
    preset: EnumProperty(
        name="Preset",
        items=(
            ("DRAFT", "Draft", "Rough and fast"),
            ("PREVIEW", "Preview", "To judge light and materials"),
            ("FINAL", "Final", "For finished pictures"),
            ("PAPER", "Paper", "The published method to the letter, for comparisons"),
        ),
        default="FINAL",
        update=_apply_preset,
        description="Sets the values below",
    )
    method: EnumProperty(
        name="Method",
        items=(
            ("GATHER", "Final Gather", "Work out light anew where it changes, and interpolate it elsewhere"),
            ("SOLUTION", "Radiosity Solution", "Show the interpolated radiosity solution"),
            ("FULL", "Full Gather", "Work out all light anew at every point: slow, for comparisons"),
        ),
        default="GATHER",
        description="How the picture is made from the radiosity solution",
    )
    quality: FloatProperty(
        name="Error",
        default=QUALITY["FINAL"],
        min=0.001,
        max=1.0,
        soft_max=0.2,
        precision=3,
        description="Error of a surface element's radiosity, as a share of the reference white",
    )
    samples: IntProperty(
        name="Samples",
        default=16,
        min=1,
        max=256,
        description="Coverage samples of a pixel: smoothness of borders and leaves",
    )


def register() -> None:
    bpy.utils.register_class(GridgatherSettings)
    bpy.types.Scene.gridgather = PointerProperty(type=GridgatherSettings)
    bpy.types.Scene.gridgather_statistics = StringProperty(
        name="Gridgather Statistics",
        description="Timings, counts and memory of the last render as JSON, by view layer",
        get=messages.statistics_of_scene,
        options={"SKIP_SAVE"},
    )


def unregister() -> None:
    del bpy.types.Scene.gridgather_statistics
    del bpy.types.Scene.gridgather
    bpy.utils.unregister_class(GridgatherSettings)
