"""F12 of every scene script."""

import json

import bpy
import numpy as np
import pytest
from pictures import render_pixels
from scene_files import scene_file, scene_names

WIDTH = 160


def shade_flat():
    for mesh in bpy.data.meshes:
        mesh.polygons.foreach_set("use_smooth", np.zeros(len(mesh.polygons), bool))
        mesh.use_auto_smooth = False  # custom normals are then left out


def rendered(name, preset, threads=0, flat=False, method="SOLUTION"):
    """(pixels bottom row first, statistics of the view layer) of a small picture. threads: 0 for all cores."""
    bpy.ops.wm.open_mainfile(filepath=str(scene_file(name)))
    scene = bpy.context.scene
    scene.gridgather.preset = preset
    scene.gridgather.method = method
    if flat:
        shade_flat()
    if threads:
        scene.render.threads_mode = "FIXED"
        scene.render.threads = threads
    scene.render.resolution_percentage = int(100 * WIDTH / scene.render.resolution_x)
    pixels = render_pixels(scene, "GRIDGATHER")
    (statistics,) = json.loads(scene.gridgather_statistics).values()
    return pixels, statistics


@pytest.mark.parametrize("name", scene_names())
def test_scene_renders(name):
    pixels, statistics = rendered(name, "DRAFT")
    assert WIDTH * 0.95 < pixels.shape[1] <= WIDTH
    assert np.isfinite(pixels).all() and pixels.min() >= 0
    assert pixels[..., :3].mean() > 0.01 and pixels[..., :3].std() > 0.001
    assert statistics["counts"] and sum(statistics["stages"].values()) > 0


@pytest.mark.parametrize("method", ["SOLUTION", "GATHER", "FULL"])
def test_furnace_is_emission_over_one_minus_albedo(method):
    pixels, _ = rendered("furnace", "FINAL", method=method)
    assert pixels[..., :3].mean() == pytest.approx(0.5, rel=0.02)


def test_room_has_the_same_bytes_on_one_thread():
    """With flat faces: Blender sums the normals of smooth ones in the order in which its threads come along."""
    pixels, _ = rendered("room", "FINAL", flat=True)
    alone, _ = rendered("room", "FINAL", threads=1, flat=True)
    assert np.array_equal(pixels, alone)


@pytest.mark.parametrize("method", ["GATHER", "FULL"])
def test_gathers_are_as_bright_as_the_solution(method):
    solution, _ = rendered("cornell_box", "FINAL")
    gathered, statistics = rendered("cornell_box", "FINAL", method=method)
    assert gathered[..., :3].mean() == pytest.approx(solution[..., :3].mean(), rel=0.05)
    assert not np.array_equal(gathered, solution)
    assert statistics["counts"]["gathered points"] > gathered.shape[0] * gathered.shape[1] / 2
    assert statistics["counts"]["visibility rays"] > statistics["counts"]["gathered points"]


def test_gather_has_the_same_bytes_on_one_thread():
    pixels, statistics = rendered("cornell_box", "FINAL", method="GATHER")
    alone, _ = rendered("cornell_box", "FINAL", threads=1, method="GATHER")
    assert np.array_equal(pixels, alone)
    counts = statistics["counts"]
    assert 10 < counts["sites"] < counts["grid vertices"]
    for kind in ("both", "visibility", "form factor"):
        assert counts[f"senders resampled: {kind}"] > 0.01 * counts["senders of sites"]
