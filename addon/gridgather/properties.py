"""scene.gridgather: the settings; scene.gridgather_statistics: what the last render measured."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, PointerProperty, StringProperty

from . import messages

# What each preset sets. Paper: as published, with errors that an eye just notices.
_STANDARD = {
    "quality": 0.02,
    "threshold": 3.0,
    "gather_samples": 512,
    "cell_size": 20.0,
    "receivers": "VISIBLE",
    "depth_law": "LOGARITHMIC",
    "use_perception": False,
    "noticeable": 0.25,
}
PRESETS = {
    "DRAFT": _STANDARD | {"quality": 0.08, "threshold": 10.0, "gather_samples": 128, "cell_size": 28.0},
    "PREVIEW": _STANDARD | {"quality": 0.04, "threshold": 5.0, "gather_samples": 256},
    "FINAL": _STANDARD,
    "PAPER": _STANDARD
    | {
        "threshold": 1.4,
        "gather_samples": 256,
        "receivers": "FREE_SPACE",
        "depth_law": "RECIPROCAL",
        "use_perception": True,
        "noticeable": 1.0,
    },
}


def _apply_preset(settings, _context) -> None:
    for name, value in PRESETS[settings.preset].items():
        setattr(settings, name, value)


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
        default=_STANDARD["quality"],
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
    threshold: FloatProperty(
        name="Threshold",
        default=_STANDARD["threshold"],
        min=0.01,
        max=100.0,
        soft_max=20.0,
        precision=1,
        subtype="PERCENTAGE",
        description="Error that the light of one sender may have before it is worked out anew at every point, as a "
        "share of the light of its surroundings. Lower is slower",
    )
    gather_samples: IntProperty(
        name="Shadow Samples",
        default=_STANDARD["gather_samples"],
        min=16,
        max=4096,
        description="Rays from a point to senders that are worked out anew, about: smoothness of shadows",
    )
    use_perception: BoolProperty(
        name="Judge as Shown",
        default=_STANDARD["use_perception"],
        description="Judge errors and steps in shadows as they show on a display, through the scene's view transform, "
        "instead of as a share of the light: what nobody would see has fewer rays",
    )
    noticeable: FloatProperty(
        name="Noticeable",
        default=_STANDARD["noticeable"],
        min=0.01,
        max=100.0,
        soft_max=2.0,
        description="Error that the light of one sender may have before it is worked out anew at every point, and "
        "height of the steps that its shadow may have, in just noticeable differences. Lower is slower",
    )
    shown_as: EnumProperty(
        name="Shown As",
        items=(
            ("STILL", "Still", "One picture: patterns may hide errors"),
            ("WALKTHROUGH", "Walkthrough", "Pictures in a row: an error that a pattern hides in one is seen to move"),
        ),
        default="STILL",
        description="Masking is left out of a walkthrough, where what patterns hide would flicker",
    )
    use_masking: BoolProperty(
        name="Masking",
        default=True,
        description="In a still, allow larger errors where textures and leaves hide them",
    )
    display_white: FloatProperty(
        name="White",
        default=100.0,
        min=0.001,
        max=1e6,
        soft_min=50.0,
        soft_max=1000.0,
        description="Luminance of the display's white, cd/m2",
    )
    display_black: FloatProperty(
        name="Black",
        default=0.2,
        min=0.0,
        max=1e6,
        soft_max=5.0,
        description="Luminance of the display's black in a lit room, cd/m2",
    )
    viewing_distance: FloatProperty(
        name="Distance",
        default=0.6,
        min=0.05,
        max=100.0,
        soft_max=3.0,
        subtype="DISTANCE",
        unit="LENGTH",
        description="From the eye to the display",
    )
    display_density: FloatProperty(
        name="Pixels per Inch",
        default=96.0,
        min=5.0,
        max=2000.0,
        soft_min=50.0,
        soft_max=300.0,
        precision=0,
        description="Of the display",
    )
    cell_size: FloatProperty(
        name="Cell Size",
        default=_STANDARD["cell_size"],
        min=4.0,
        max=200.0,
        soft_max=60.0,
        precision=0,
        description="Side of a cell of the grid over the picture, in pixels of a picture 350 pixels high; larger "
        "pictures have larger cells",
    )
    use_surface_sites: BoolProperty(
        name="Surface Sites",
        default=True,
        description="Interpolate light over surfaces whose triangles are larger than cells of the grid. Otherwise the "
        "grid does for everything",
    )
    receivers: EnumProperty(
        name="Receivers",
        items=(
            ("VISIBLE", "Visible Surfaces", "Places in the grid look around from surfaces that are seen"),
            ("FREE_SPACE", "Free Space", "They look from points in free space and count hits, as published"),
        ),
        default=_STANDARD["receivers"],
        description="From where the light around a vertex of the grid is judged",
    )
    depth_law: EnumProperty(
        name="Depth",
        items=(
            ("LOGARITHMIC", "Logarithmic", "Cells keep their shape over all depths"),
            ("RECIPROCAL", "Perspective", "Even steps after perspective projection, as published"),
        ),
        default=_STANDARD["depth_law"],
        description="How the grid is divided along the depth. Orthographic cameras have even steps",
    )
    capture_path: StringProperty(
        name="Capture",
        subtype="FILE_PATH",
        description="If set, renders also write all that they are made from to this file, the last view layer at the "
        "end, so that problems can be looked into without Blender. Image files are not copied into it",
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
