"""F12: pictures, statistics, messages, cancelling."""

import ctypes
import json
import re
from pathlib import Path
from types import SimpleNamespace

import bpy
import numpy as np
import pytest
from building import add, link, material, quad, surface
from gridgather import engine, interface, messages
from pictures import render_pixels


def test_sun_of_irradiance_pi_on_a_half_grey_floor_is_half(lit):
    pixels = render_pixels(lit, "GRIDGATHER")
    assert pixels.shape == (48, 64, 4)
    assert pixels[..., :3] == pytest.approx(np.full((48, 64, 3), 0.5), rel=0.01)


@pytest.mark.parametrize("surfaces", [True, False])
def test_cells_are_never_smaller_than_four_pixels(lit, surfaces):
    """Parts of a pixel would lie in cells in which nothing else was seen."""
    link(quad("Roof", size=1), location=(0.3, 0.2, 1), rotation_euler=(0.2, 0.1, 0.5))
    bpy.data.objects["Roof"].visible_camera = False
    own = lit.gridgather
    own.use_surface_sites = surfaces
    pictures = []
    for own.cell_size in (4, 29, 60):  # of a picture 350 pixels high: 0.5, 4 and 8 pixels of this one
        pictures.append(render_pixels(lit, "GRIDGATHER"))
    assert (pictures[0] == pictures[1]).all() and (pictures[1] != pictures[2]).any()


def test_statistics_by_view_layer(lit):
    lit.view_layers.new("Second")
    render_pixels(lit, "GRIDGATHER")
    statistics = json.loads(lit.gridgather_statistics)
    assert set(statistics) == {"ViewLayer", "Second"}
    for layer in statistics.values():
        assert {"export", "upload"} < set(layer["stages"]) and layer["counts"]
    assert "gridgather_statistics" not in lit
    with pytest.raises(AttributeError):
        lit.gridgather_statistics = "{}"


@pytest.mark.parametrize(
    ("preset", "height", "shares"), [("FINAL", 350, True), ("FINAL", 100, False), ("PAPER", 350, False)]
)
def test_neighbours_share_light_in_large_pictures_but_not_as_published(lit, preset, height, shares):
    lit.render.resolution_x = lit.render.resolution_y = height
    lit.gridgather.preset = preset
    bpy.ops.render.render()
    (statistics,) = json.loads(lit.gridgather_statistics).values()
    assert (statistics["counts"]["fragments that share soft light"] > 0.5 * height**2) == shares


def test_statistics_are_of_the_last_frame_alone(lit, tmp_path):
    """With persistent data one engine renders all frames of an animation."""
    second = lit.view_layers.new("Second")
    lit.render.use_persistent_data = True
    lit.frame_end = 2
    lit.render.filepath = str(tmp_path / "frame_")

    def only_on_frame_1(scene, _=None):
        scene.view_layers[second.name].use = scene.frame_current == 1

    bpy.app.handlers.frame_change_pre.append(only_on_frame_1)
    try:
        bpy.ops.render.render(animation=True)
    finally:
        bpy.app.handlers.frame_change_pre.remove(only_on_frame_1)
    assert set(json.loads(lit.gridgather_statistics)) == {"ViewLayer"}


def test_statistics_are_in_the_metadata_of_the_file(lit):
    render_pixels(lit, "GRIDGATHER")
    content = Path(lit.render.filepath).read_bytes()
    assert b"gridgather_statistics" in content
    assert lit.gridgather_statistics.encode() in content


@pytest.mark.parametrize("method, tolerance", [("SOLUTION", 0), ("GATHER", 0.02)])  # sites know what is seen alone
@pytest.mark.parametrize("crop", [False, True])
def test_border_is_part_of_the_whole_picture(lit, crop, method, tolerance):
    lit.gridgather.method = method
    lit.world = bpy.data.worlds.new("World")
    link(quad("Small", size=2), location=(1, 1, 2))
    whole = render_pixels(lit, "GRIDGATHER")
    render = lit.render
    render.use_border, render.use_crop_to_border = True, crop
    render.border_min_x, render.border_max_x, render.border_min_y, render.border_max_y = 0.3, 0.72, 0.26, 0.9
    part = render_pixels(lit, "GRIDGATHER")
    inside = (slice(12, 43), slice(19, 46))
    if not crop:
        outside = part.copy()
        outside[inside] = 0
        assert not outside.any()
        part = part[inside]
    assert np.abs(part - whole[inside]).max() <= tolerance * whole[inside].mean()


def test_every_view_of_a_stereo_picture_is_filled(lit, tmp_path):
    lit.render.use_multiview = True
    settings = lit.render.image_settings
    settings.views_format, settings.file_format = "INDIVIDUAL", "PNG"
    lit.render.filepath = str(tmp_path / "stereo")
    bpy.ops.render.render(write_still=True)
    for side in "LR":
        (tmp_path / f"stereo_{side}.png").rename(tmp_path / f"{side}.png")  # else Blender looks for the other one
        assert min(bpy.data.images.load(str(tmp_path / f"{side}.png")).pixels) > 0.4


def test_transparent_film(scene):
    scene.world = bpy.data.worlds.new("World")
    scene.world.use_nodes, scene.world.color = False, (0.5, 0.5, 0.5)
    link(quad(size=1))
    opaque = render_pixels(scene, "GRIDGATHER")
    scene.render.film_transparent = True
    clear = render_pixels(scene, "GRIDGATHER")
    assert opaque[0, 0, 3] == 1 and clear[0, 0].tolist() == [0, 0, 0, 0]
    assert clear[24, 32, 3] == pytest.approx(1) and clear[24, 32, 0] == pytest.approx(opaque[24, 32, 0], rel=1e-3)


def test_same_scene_gives_the_same_pixels(lit):
    lit.world = bpy.data.worlds.new("World")
    link(quad("Small", size=2), location=(1, 1, 2))
    first = render_pixels(lit, "GRIDGATHER")
    lit.render.threads_mode, lit.render.threads = "FIXED", 1
    assert np.array_equal(render_pixels(lit, "GRIDGATHER"), first)


def glass(scene):
    source = material("Pane")
    surface(source.node_tree, add(source.node_tree, "ShaderNodeBsdfGlass"))
    pane = quad("Pane")
    pane.materials.append(source)
    link(pane, location=(0, 0, 1))


@pytest.fixture
def printed(capfd):
    """A function: what Blender itself wrote since the last call."""

    def read():
        ctypes.CDLL(None).fflush(None)
        return capfd.readouterr().out

    return read


def test_problems_are_reported_once_and_kept(lit, printed):
    glass(lit)
    render_pixels(lit, "GRIDGATHER")
    assert printed().count("Pane: node Glass BSDF") == 1
    ((name, problem, count),) = messages.of_scene(lit)
    assert name == "Pane" and "Glass BSDF" in problem and count == 1
    render_pixels(lit, "GRIDGATHER")
    assert "Pane" not in printed()
    nodes = bpy.data.materials["Pane"].node_tree.nodes
    nodes.remove(nodes["Glass BSDF"])
    render_pixels(lit, "GRIDGATHER")
    assert messages.of_scene(lit) == []


def test_loading_a_file_forgets(lit):
    glass(lit)
    render_pixels(lit, "GRIDGATHER")
    bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
    assert messages.of_scene(bpy.context.scene) == [] and bpy.context.scene.gridgather_statistics == ""


def test_stages_are_shown(lit, printed):
    render_pixels(lit, "GRIDGATHER")
    stages = re.findall(r"Time:\S+ \| (.+)", printed())
    assert stages[0] == "Exporting" and any("Memory" in stage for stage in stages[1:])


class FakeEngine:
    """What GridgatherEngine._wait asks of Blender."""

    def __init__(self, breaks_after=10**9):
        self.fractions, self.stages, self.updates, self.breaks_after = [], [], 0, breaks_after

    def test_break(self):
        self.breaks_after -= 1
        return self.breaks_after < 0

    def update_progress(self, fraction):
        self.fractions.append(fraction)

    def update_stats(self, _, text):
        self.stages.append(text)

    def update_memory_stats(self, memory_used, memory_peak):
        assert 0 <= memory_used <= memory_peak

    def update_result(self, result):
        self.updates += 1


class FakeRender:
    """A render that finishes one of its four rows a call, or when cancelled."""

    def __init__(self):
        self.rows, self.cancelled = 0, False

    def wait(self, seconds):
        assert 0.02 <= seconds <= 0.05
        self.rows += not self.cancelled
        status = interface.CANCELLED if self.cancelled else interface.OK
        done = self.cancelled or self.rows == 4
        return interface.Progress(
            finished=done, status=status, fraction=self.rows / 4, stage=f"Row {self.rows}".encode()
        )

    def cancel(self):
        self.cancelled = True

    def copy_finished_tiles(self, pixels):
        pixels["Combined"][: self.rows] = 1
        return True


def waited(monkeypatch, fake, render):
    """(status, pixels that Blender got) of the engine's loop."""
    got = []
    monkeypatch.setattr(engine, "write_pixels", lambda _, pixels: got.append(pixels.copy()))
    result = SimpleNamespace(layers=[SimpleNamespace(passes=[SimpleNamespace(name="Combined")])])
    status = engine.GridgatherEngine._wait(fake, render, result, {"Combined": np.zeros((4, 2, 4), np.float32)})
    return status, got


def test_loop_shows_progress_and_ends_with_the_whole_picture(monkeypatch):
    fake = FakeEngine()
    status, got = waited(monkeypatch, fake, FakeRender())
    assert status == interface.OK and got[-1].all()
    assert fake.fractions == [0.25, 0.5, 0.75, 1.0] and fake.updates == len(got)
    assert [stage.split(" | ")[0] for stage in fake.stages] == ["Row 1", "Row 2", "Row 3", "Row 4"]


def test_loop_copies_seldom_while_it_runs(monkeypatch):
    _, got = waited(monkeypatch, FakeEngine(), FakeRender())
    assert len(got) == 1
    monkeypatch.setattr(engine, "_REDRAW_SECONDS", -1.0)
    _, got = waited(monkeypatch, FakeEngine(), FakeRender())
    assert [pixels[:, 0, 0].sum() for pixels in got] == [1, 2, 3, 4]


def test_loop_passes_a_cancel_on_and_keeps_what_is_done(monkeypatch):
    render = FakeRender()
    status, got = waited(monkeypatch, FakeEngine(breaks_after=1), render)
    assert render.cancelled and status == interface.CANCELLED
    assert got[-1][:, 0, 0].tolist() == [1, 1, 0, 0]
