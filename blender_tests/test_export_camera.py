"""Cameras against Blender's own projection, borders, settings."""

import bpy
import numpy as np
import pytest
from bpy_extras.object_utils import world_to_camera_view
from building import lamp
from capture import export
from gridgather import description
from gridgather.description import (
    DEPTH_LOGARITHMIC,
    DEPTH_RECIPROCAL,
    RECEIVERS_FREE_SPACE,
    RECEIVERS_VISIBLE,
    SITES_GRID,
    SITES_SURFACES_AND_GRID,
    Settings,
)
from gridgather.export import ExportError
from gridgather.export.scene import export_frame
from mathutils import Vector

CAMERAS = {
    "perspective": {},
    "tall picture": {"size": (48, 96)},
    "shift": {"shift_x": 0.3, "shift_y": -0.2},
    "vertical fit": {"sensor_fit": "VERTICAL", "sensor_height": 20.0},
    "horizontal fit, tall": {"sensor_fit": "HORIZONTAL", "size": (48, 96)},
    "pixel aspect": {"aspect": (2.0, 1.0)},
    "pixel aspect, other way": {"aspect": (1.0, 1.5), "shift_y": 0.1},
    "orthographic": {"type": "ORTHO", "ortho_scale": 7.0},
    "orthographic shift": {"type": "ORTHO", "shift_x": 0.5, "shift_y": 0.25},
    "orthographic, tall": {"type": "ORTHO", "size": (48, 96), "aspect": (1.0, 2.0)},
}


@pytest.mark.parametrize("name", CAMERAS)
def test_window_agrees_with_blender(scene, name):
    properties = dict(CAMERAS[name])
    scene.render.resolution_x, scene.render.resolution_y = properties.pop("size", (96, 48))
    scene.render.pixel_aspect_x, scene.render.pixel_aspect_y = properties.pop("aspect", (1.0, 1.0))
    for key, value in properties.items():
        setattr(scene.camera.data, key, value)
    scene.camera.location, scene.camera.rotation_euler = (3, -4, 2), (1.1, 0.2, 0.6)
    bpy.context.view_layer.update()
    camera = export().camera
    matrix = np.vstack([np.array(camera.matrix).reshape(3, 4), [0, 0, 0, 1]])
    for point in ((0, 0, 0), (1, 2, 0.5), (-3, 5, 1), (0.2, 0, -2)):
        local = np.linalg.inv(matrix) @ [*point, 1]
        scale = 1.0 if camera.type == description.CAMERA_ORTHOGRAPHIC else -local[2]
        left, right, bottom, top = camera.window
        ours = (local[0] / scale - left) / (right - left), (local[1] / scale - bottom) / (top - bottom)
        blenders = world_to_camera_view(scene, scene.camera, Vector(point))
        assert ours == pytest.approx(blenders[:2], abs=1e-4)


def test_scale_of_the_camera_does_not_matter(scene):
    scene.camera.scale = (2, 3, 4)
    assert export().camera.matrix == pytest.approx((1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 10), abs=1e-6)


def test_clipping(scene):
    scene.camera.data.clip_start, scene.camera.data.clip_end = 0.25, 50
    camera = export().camera
    assert (camera.clip_start, camera.clip_end) == (0.25, 50)


def test_what_cameras_do_not_have_yet_is_named(scene):
    scene.camera.data.dof.use_dof = scene.render.use_motion_blur = scene.render.use_multiview = True
    assert sorted(export().scene.messages) == [
        ("Camera", "Depth of Field is left out"),
        ("Scene", "Motion Blur is left out"),
        ("Scene", "Stereoscopy is left out"),
    ]


def test_no_camera_is_an_error(scene):
    scene.camera = None
    with pytest.raises(ExportError, match="Scene has no camera"):
        export_frame(bpy.context.evaluated_depsgraph_get(), 64, 48)


def test_panoramic_camera_is_an_error(scene):
    scene.camera.data.type = "PANO"
    with pytest.raises(ExportError, match="neither perspective nor orthographic"):
        export()


def test_lamp_as_camera_is_an_error(scene):
    scene.camera = lamp("SPOT")
    with pytest.raises(ExportError, match="of type LIGHT"):
        export()


def test_percentage_and_border(scene):
    render = scene.render
    render.resolution_x, render.resolution_y, render.resolution_percentage = 200, 100, 50
    assert (export().settings.width, export().settings.height) == (100, 50)
    assert export().settings.crop == (0, 0, 100, 50)
    render.use_border = True
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.25, 0.75, 0.1, 0.5
    assert export().settings.crop == (25, 5, 50, 20)


def test_film_settings_are_those_of_cycles(scene):
    scene.cycles.filter_width, scene.cycles.pixel_filter_type, scene.cycles.film_exposure = 2.5, "GAUSSIAN", 1.5
    scene.render.film_transparent = True
    scene.render.threads_mode, scene.render.threads = "FIXED", 3
    scene.gridgather.samples = 5
    settings = export().settings
    assert (settings.filter_width, settings.filter_type, settings.exposure) == (2.5, description.PIXEL_GAUSS, 1.5)
    assert (settings.film_transparent, settings.threads, settings.samples) == (True, 3, 5)


@pytest.mark.parametrize("preset, quality, threshold", [
    ("DRAFT", 0.08, 0.1), ("PREVIEW", 0.04, 0.05), ("FINAL", 0.02, 0.03), ("PAPER", 0.02, 0.014),
])
def test_presets_set_the_errors(scene, preset, quality, threshold):
    assert scene.gridgather.preset == "FINAL"
    scene.gridgather.preset = preset
    settings = export().settings
    assert (settings.quality, settings.threshold) == pytest.approx((quality, threshold))


def test_paper_is_as_published_and_final_comes_back(scene):
    standard = export().settings
    scene.gridgather.preset = "PAPER"
    paper = export().settings
    assert (paper.receivers, paper.depth_law) == (RECEIVERS_FREE_SPACE, DEPTH_RECIPROCAL)
    assert (standard.receivers, standard.depth_law) == (RECEIVERS_VISIBLE, DEPTH_LOGARITHMIC)
    scene.gridgather.preset = "FINAL"
    assert export().settings == standard
    scene.gridgather.use_surface_sites = False
    assert (standard.sites, export().settings.sites) == (SITES_SURFACES_AND_GRID, SITES_GRID)
    own, library = (
        (each.quality, each.threshold, each.cell_size, each.gather_samples) for each in (standard, Settings(1, 1, ()))
    )
    assert own == pytest.approx(library)
