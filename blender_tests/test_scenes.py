"""F12 of every scene script."""

import json
import subprocess
from pathlib import Path

import bpy
import numpy as np
import pytest

ROOT = Path(__file__).parents[1]
WIDTH = 160


def built(name):
    """The scene's file, made by its script unless it is newer than all scripts."""
    path = ROOT / "build" / "scenes" / f"{name}.blend"
    newest = max(script.stat().st_mtime for script in (ROOT / "scenes").glob("*.py"))
    if not path.exists() or path.stat().st_mtime < newest:
        path.parent.mkdir(parents=True, exist_ok=True)
        script = ROOT / "scenes" / f"{name}.py"
        command = [bpy.app.binary_path, "-b", "--factory-startup", "--python-exit-code", "7", "--python", script]
        subprocess.run([*command, "--", path], check=True, timeout=600)
    return path


def rendered(name, tmp_path):
    """(pixels bottom row first, statistics) of a small draft."""
    bpy.ops.wm.open_mainfile(filepath=str(built(name)))
    scene = bpy.context.scene
    scene.render.engine = "GRIDGATHER"
    scene.gridgather.preset = "DRAFT"
    scene.render.resolution_percentage = int(100 * WIDTH / scene.render.resolution_x)
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
    scene.render.filepath = str(tmp_path / "picture.exr")
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    pixels = np.empty(image.size[0] * image.size[1] * 4, np.float32)
    image.pixels.foreach_get(pixels)
    return pixels.reshape(image.size[1], image.size[0], 4), json.loads(scene.gridgather_statistics)


@pytest.mark.parametrize("name", ["cornell_box", "furnace", "startup", "room"])
def test_scene_renders(name, tmp_path):
    pixels, statistics = rendered(name, tmp_path)
    assert np.isfinite(pixels).all() and pixels.min() >= 0
    assert pixels[..., :3].mean() > 0.01
    assert pixels[..., :3].std() > (0 if name == "furnace" else 0.01)
    (layer,) = statistics.values()
    assert layer["counts"] and sum(layer["stages"].values()) > 0


def test_furnace_is_emission_over_one_minus_albedo(tmp_path):
    pixels, _ = rendered("furnace", tmp_path)
    assert np.percentile(abs(pixels[..., :3] / 0.5 - 1), 99) < 0.02
