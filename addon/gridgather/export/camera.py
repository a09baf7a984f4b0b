"""The scene's camera as a window and a matrix."""

from ..description import CAMERA_ORTHOGRAPHIC, CAMERA_PERSPECTIVE, Camera
from . import ExportError
from .identity import rows


def export_camera(depsgraph, camera, width: int, height: int) -> Camera:
    """The camera object of a full picture of width x height pixels. Raises ExportError for None and unknown kinds."""
    if camera is None:
        raise ExportError(f"The scene {depsgraph.scene.name} has no camera")
    camera = camera.evaluated_get(depsgraph)
    if camera.type != "CAMERA":
        raise ExportError(f"{camera.name} is used as a camera but is of type {camera.type}")
    if camera.data.type not in {"PERSP", "ORTHO"}:
        raise ExportError(f"The camera {camera.name} is neither perspective nor orthographic: {camera.data.type}")
    render = depsgraph.scene_eval.render
    projection = camera.calc_matrix_camera(
        depsgraph, x=width, y=height, scale_x=render.pixel_aspect_x, scale_y=render.pixel_aspect_y
    )
    orthographic = camera.data.type == "ORTHO"
    return Camera(
        type=CAMERA_ORTHOGRAPHIC if orthographic else CAMERA_PERSPECTIVE,
        matrix=rows(camera.matrix_world.normalized()),
        window=_window(projection, orthographic),
        clip_start=camera.data.clip_start,
        clip_end=camera.data.clip_end,
    )


def _window(projection, orthographic: bool) -> tuple[float, float, float, float]:
    """Where x and y of an OpenGL projection matrix reach -1 and 1, in the plane z = -1.

    The matrix maps x to (p00 x + p02 z + p03) / w, with w = -z (perspective) or 1.
    """
    edges = []
    for axis in range(2):
        scale = projection[axis][axis]
        offset = -projection[axis][3] if orthographic else projection[axis][2]
        edges += [(offset - 1) / scale, (offset + 1) / scale]
    return tuple(edges)
