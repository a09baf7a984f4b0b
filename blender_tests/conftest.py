"""Fixtures for tests that run inside Blender."""

import sys
from pathlib import Path

import addon_utils
import bpy
import numpy as np
import pytest

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "blender_tests"), str(ROOT / "scenes")]
from building import lamp, link, material, quad  # noqa: E402 (needs the path)
from capture import CaptureEngine  # noqa: E402 (needs the path)


@pytest.fixture(scope="session", autouse=True)
def gridgather():
    """The add-on as BLENDER_USER_SCRIPTS has it, registered for the whole run."""
    module = addon_utils.enable("gridgather")
    assert module is not None, "the add-on does not register"
    bpy.utils.register_class(CaptureEngine)
    return module


@pytest.fixture(autouse=True)
def scene(gridgather):
    """An empty scene with a camera, small, without dither, set to render with Gridgather."""
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    scene = bpy.context.scene
    scene.render.engine = "GRIDGATHER"
    scene.render.resolution_x, scene.render.resolution_y = 64, 48
    scene.render.dither_intensity = 0
    scene.camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    scene.collection.objects.link(scene.camera)
    scene.camera.location.z = 10
    return scene


@pytest.fixture
def lit(scene):
    """A lit floor seen from above."""
    floor = quad("Floor", size=100)
    floor.materials.append(material("Floor", (0.5, 0.5, 0.5)))
    link(floor)
    lamp("SUN", energy=np.pi)
    return scene
