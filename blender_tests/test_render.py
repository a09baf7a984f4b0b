"""F12: pictures, statistics, messages, cancelling."""

import json
import time

import bpy
import numpy as np
import pytest
from building import add, lamp, link, material, quad, surface
from gridgather import engine, messages


@pytest.fixture
def lit(scene):
    """A lit floor seen from above."""
    floor = quad("Floor", size=100)
    floor.materials.append(material("Floor", (0.5, 0.5, 0.5)))
    link(floor)
    lamp("SUN", energy=np.pi)
    return scene


def rendered(scene, tmp_path, name="picture.exr"):
    """float32 (height, width, 4) of F12, bottom row first."""
    scene.render.filepath = str(tmp_path / name)
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_mode, scene.render.image_settings.color_depth = "RGBA", "32"
    bpy.ops.render.render(write_still=True)
    return pixels_of(scene.render.filepath)


def pixels_of(path):
    image = bpy.data.images.load(path)
    width, height = image.size
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)


def test_sun_of_irradiance_pi_on_a_half_grey_floor_is_half(lit, tmp_path):
    pixels = rendered(lit, tmp_path)
    assert pixels.shape == (48, 64, 4)
    assert pixels[..., :3] == pytest.approx(np.full((48, 64, 3), 0.5), rel=0.01)


def test_statistics_by_view_layer(lit, tmp_path):
    lit.view_layers.new("Second")
    rendered(lit, tmp_path)
    statistics = json.loads(lit.gridgather_statistics)
    assert set(statistics) == {"ViewLayer", "Second"}
    for layer in statistics.values():
        assert {"export", "upload"} < set(layer["stages"]) and layer["counts"]
    assert "gridgather_statistics" not in lit.keys()
    with pytest.raises(AttributeError):
        lit.gridgather_statistics = "{}"


def test_statistics_of_a_layer_that_is_off_are_not_kept(lit, tmp_path):
    lit.view_layers.new("Second")
    rendered(lit, tmp_path)
    lit.view_layers["Second"].use = False
    rendered(lit, tmp_path)
    assert set(json.loads(lit.gridgather_statistics)) == {"ViewLayer"}


def test_statistics_are_in_the_metadata_of_the_file(lit, tmp_path):
    rendered(lit, tmp_path)
    content = (tmp_path / "picture.exr").read_bytes()
    assert b"gridgather_statistics" in content
    assert lit.gridgather_statistics.encode() in content


@pytest.mark.parametrize("crop", [False, True])
def test_border_is_part_of_the_whole_picture(lit, tmp_path, crop):
    lit.world = bpy.data.worlds.new("World")
    link(quad("Small", size=2), location=(1, 1, 2))
    whole = rendered(lit, tmp_path)
    render = lit.render
    render.use_border, render.use_crop_to_border = True, crop
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.3, 0.72, 0.26, 0.9
    part = rendered(lit, tmp_path, "part.exr")
    inside = (slice(12, 43), slice(19, 46))
    if not crop:
        outside = part.copy()
        outside[inside] = 0
        assert not outside.any()
        part = part[inside]
    assert np.array_equal(part, whole[inside])


def test_transparent_film(scene, tmp_path):
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes, scene.world.color = False, (0.5, 0.5, 0.5)
    link(quad(size=1))
    opaque = rendered(scene, tmp_path)
    scene.render.film_transparent = True
    clear = rendered(scene, tmp_path)
    assert opaque[0, 0, 3] == 1 and clear[0, 0].tolist() == [0, 0, 0, 0]
    assert clear[24, 32, 3] == pytest.approx(1) and clear[24, 32, 0] == pytest.approx(opaque[24, 32, 0], rel=1e-3)


def test_same_scene_gives_the_same_pixels(lit, tmp_path):
    lit.world = bpy.data.worlds.new("World")
    link(quad("Small", size=2), location=(1, 1, 2))
    first = rendered(lit, tmp_path)
    lit.render.threads_mode, lit.render.threads = "FIXED", 1
    assert np.array_equal(rendered(lit, tmp_path), first)


def glass(scene):
    source = material("Pane")
    surface(source.node_tree, add(source.node_tree, "ShaderNodeBsdfGlass"))
    pane = quad("Pane")
    pane.materials.append(source)
    link(pane, location=(0, 0, 1))


@pytest.fixture
def reports(monkeypatch):
    """What renders report, as (kinds, text)."""
    found = []
    monkeypatch.setattr(engine.GridgatherEngine, "report", lambda _, kinds, text: found.append((kinds, text)), False)
    return found


def test_problems_are_reported_once_and_kept(lit, tmp_path, reports):
    glass(lit)
    rendered(lit, tmp_path)
    ((kinds, text),) = reports
    assert kinds == {"WARNING"} and "Pane" in text and "Glass BSDF" in text
    ((name, problem, count),) = messages.of_scene(lit)
    assert name == "Pane" and "Glass BSDF" in problem and count == 1
    rendered(lit, tmp_path)
    assert len(reports) == 1
    bpy.data.materials["Pane"].node_tree.nodes.remove(bpy.data.materials["Pane"].node_tree.nodes["Glass BSDF"])
    rendered(lit, tmp_path)
    assert messages.of_scene(lit) == []


def test_loading_a_file_forgets(lit, tmp_path):
    glass(lit)
    rendered(lit, tmp_path)
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    assert messages.of_scene(bpy.context.scene) == [] and bpy.context.scene.gridgather_statistics == ""


@pytest.mark.parametrize("after", [0, 1, 2])
def test_cancel_during_export_and_render(lit, monkeypatch, reports, after):
    """test_break() is asked once during the export of this scene, then by the render loop."""
    asked = []
    monkeypatch.setattr(engine.GridgatherEngine, "test_break", lambda _: asked.append(0) or len(asked) > after, False)
    lit.render.resolution_x = lit.render.resolution_y = 4000
    lit.gridgather.samples = 256
    start = time.perf_counter()
    bpy.ops.render.render()
    assert time.perf_counter() - start < 5
    assert [text for kinds, text in reports if "ERROR" in kinds] == []
    assert lit.gridgather_statistics == ""


def test_progress_and_stages_are_shown(lit, tmp_path, monkeypatch):
    fractions, stages = [], []
    monkeypatch.setattr(engine.GridgatherEngine, "update_progress", lambda _, value: fractions.append(value), False)
    monkeypatch.setattr(engine.GridgatherEngine, "update_stats", lambda _, __, text: stages.append(text), False)
    rendered(lit, tmp_path)
    assert fractions == sorted(fractions) and fractions[-1] == 1
    assert stages[0] == "Exporting" and len(stages) > 1 and all(stages)
