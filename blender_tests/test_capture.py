"""Captures: what renders are made from, in files; the final gather of whole captured scenes against slow truth."""

import json
import subprocess
from pathlib import Path

import bpy
import pytest
from pictures import render_pixels
from scene_files import scene_file

ORACLE = Path(__file__).parents[1] / "build" / "native" / "tests" / "capture_oracle"


def captured(scene, path):
    scene.gridgather.method, scene.gridgather.quality = "SOLUTION", 1.0  # the fastest picture; it is not looked at
    scene.gridgather.capture_path = str(path)
    render_pixels(scene, "GRIDGATHER")
    return path


def agreement(path, points, rays):
    done = subprocess.run([ORACLE, path, str(points), str(rays)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


# rmse: of single points, by the light of all; of the truth's own rays, too, where there are few.
@pytest.mark.parametrize(
    ("name", "rays", "rmse"),
    [
        ("cornell_box", 65536, 0.02),
        ("startup", 65536, 0.02),
        ("toy_room", 16384, 0.05),
        ("library", 4096, 0.08),
        ("attic", 16384, 0.07),
    ],
)
def test_light_at_points_of_a_scene_is_that_of_dense_rays(name, rays, rmse, tmp_path):
    bpy.ops.wm.open_mainfile(filepath=str(scene_file(name)))
    bpy.context.scene.render.resolution_percentage = 50
    found = agreement(captured(bpy.context.scene, tmp_path / "capture"), 200, rays)
    assert found["points"] >= 200
    assert abs(found["mean_ratio"] - 1) < 0.01
    assert found["rel_rmse"] < rmse


def test_captures_are_the_same_each_time(lit, tmp_path):
    first = captured(lit, tmp_path / "first").read_bytes()
    assert first == captured(lit, tmp_path / "second").read_bytes()
    lit.camera.location.z += 1
    assert first != captured(lit, tmp_path / "first").read_bytes()


def test_a_capture_that_cannot_be_written_is_told(lit, tmp_path):
    lit.gridgather.capture_path = str(tmp_path / "missing" / "capture")
    with pytest.raises(RuntimeError, match="cannot write .*missing/capture"):
        bpy.ops.render.render()
