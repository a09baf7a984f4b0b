"""The scene's render settings."""

import numpy as np

from ..description import (
    DEPTH_LOGARITHMIC,
    DEPTH_RECIPROCAL,
    METHOD_FULL,
    METHOD_GATHER,
    METHOD_SOLUTION,
    PIXEL_BLACKMAN_HARRIS,
    PIXEL_BOX,
    PIXEL_GAUSS,
    RECEIVERS_FREE_SPACE,
    RECEIVERS_VISIBLE,
    SITES_GRID,
    SITES_SURFACES_AND_GRID,
    Settings,
)

_METHODS = {"GATHER": METHOD_GATHER, "SOLUTION": METHOD_SOLUTION, "FULL": METHOD_FULL}
_RECEIVERS = {"VISIBLE": RECEIVERS_VISIBLE, "FREE_SPACE": RECEIVERS_FREE_SPACE}
_DEPTH_LAWS = {"LOGARITHMIC": DEPTH_LOGARITHMIC, "RECIPROCAL": DEPTH_RECIPROCAL}
_FILTERS = {"BLACKMAN_HARRIS": PIXEL_BLACKMAN_HARRIS, "GAUSSIAN": PIXEL_GAUSS, "BOX": PIXEL_BOX}


def export_settings(scene, width: int, height: int) -> Settings:
    """Settings for a full picture of width x height pixels; film settings are those of Cycles where it is enabled."""
    own, render, cycles = scene.gridgather, scene.render, getattr(scene, "cycles", None)
    settings = Settings(
        width=width,
        height=height,
        crop=_crop(render, width, height),
        method=_METHODS[own.method],
        quality=own.quality,
        samples=own.samples,
        sites=SITES_SURFACES_AND_GRID if own.use_surface_sites else SITES_GRID,
        receivers=_RECEIVERS[own.receivers],
        depth_law=_DEPTH_LAWS[own.depth_law],
        cell_size=own.cell_size,
        threshold=own.threshold / 100,
        gather_samples=own.gather_samples,
        noticeable=own.noticeable,
        use_masking=own.use_masking and own.shown_as == "STILL",
        film_transparent=render.film_transparent,
        threads=render.threads if render.threads_mode == "FIXED" else 0,
    )
    if cycles:
        settings.filter_width = cycles.filter_width
        settings.filter_type = _FILTERS.get(cycles.pixel_filter_type, PIXEL_BLACKMAN_HARRIS)
        settings.exposure = cycles.film_exposure
    return settings


def _crop(render, width: int, height: int) -> tuple[int, int, int, int]:
    """Blender's border in pixels: single precision, cut off, as Blender itself rounds it."""
    if not render.use_border:
        return (0, 0, width, height)
    left, right = (int(np.float32(x) * np.float32(width)) for x in (render.border_min_x, render.border_max_x))
    bottom, top = (int(np.float32(y) * np.float32(height)) for y in (render.border_min_y, render.border_max_y))
    return (left, bottom, right - left, top - bottom)
