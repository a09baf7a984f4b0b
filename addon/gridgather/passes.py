"""Passes that tell how a picture was made: their properties of a view layer, and Blender's render passes for them."""

import bpy
from bpy.props import BoolProperty, PointerProperty

# Name of the property, name of the pass, bit in the library's settings.
_DIAGNOSTICS = (
    ("use_visibility_samples", "Visibility Samples", 1),
    ("use_form_factor_samples", "Form Factor Samples", 2),
    ("use_resampled_senders", "Resampled Senders", 4),
    ("use_cell_lines", "Cell Lines", 8),
    ("use_surface_site_share", "Surface Sites", 16),
    ("use_threshold_elevation", "Threshold Elevation", 32),
    ("use_adaptation_luminance", "Adaptation Luminance", 64),
    ("use_site_threshold", "Site Threshold", 128),
)
PROPERTIES = tuple(name for name, _, _ in _DIAGNOSTICS)


class GridgatherLayerSettings(bpy.types.PropertyGroup):
    """Which passes a view layer has."""

    use_visibility_samples: BoolProperty(
        name="Visibility Samples", description="Rays that a pixel sent to senders of light and to what is near"
    )
    use_form_factor_samples: BoolProperty(
        name="Form Factor Samples", description="Form factors that were worked out for a pixel"
    )
    use_resampled_senders: BoolProperty(
        name="Resampled Senders", description="Senders that were looked at anew, mean over the points of a pixel"
    )
    use_cell_lines: BoolProperty(
        name="Cell Lines", description="1 where a cell of the grid over the picture ends, elsewhere 0"
    )
    use_surface_site_share: BoolProperty(
        name="Surface Sites",
        description="1 where light is interpolated over the surface itself, 0 where by the grid, in between where one "
        "fades into the other",
    )
    use_threshold_elevation: BoolProperty(
        name="Threshold Elevation",
        description="Factor by which patterns around a pixel hide errors, 1 to 10. Only where errors are judged as "
        "shown",
    )
    use_adaptation_luminance: BoolProperty(
        name="Adaptation Luminance",
        description="Luminance that an eye is used to which looks at a pixel, cd/m2. Only where errors are judged as "
        "shown",
    )
    use_site_threshold: BoolProperty(
        name="Site Threshold",
        description="Error of radiosity that one sender may have there, W/m2. Only where errors are judged as shown",
    )


def enabled(view_layer) -> list[str]:
    """Names of the passes that a view layer asks for, in their order."""
    return [name for key, name, _ in _DIAGNOSTICS if getattr(view_layer.gridgather, key)]


def bits(view_layer) -> int:
    """The same for the library."""
    return sum(bit for key, _, bit in _DIAGNOSTICS if getattr(view_layer.gridgather, key))


def register() -> None:
    bpy.utils.register_class(GridgatherLayerSettings)
    bpy.types.ViewLayer.gridgather = PointerProperty(type=GridgatherLayerSettings)


def unregister() -> None:
    del bpy.types.ViewLayer.gridgather
    bpy.utils.unregister_class(GridgatherLayerSettings)
