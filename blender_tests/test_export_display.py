"""How the scene is shown: what the library makes of pixels is what Blender saves."""

import json

import bpy
import numpy as np
import pytest
from building import lamp, link, quad
from capture import export
from gridgather import description, messages, session
from gridgather.export import display

SIDE = 32
# view, look, exposure, gamma
SHOWN = [
    ("Standard", "None", 0.0, 1.0),
    ("Standard", "None", -1.5, 1.4),
    ("Standard", "High Contrast", 0.5, 1.0),
    ("Filmic", "None", 0.0, 1.0),
    ("Filmic", "Medium High Contrast", 1.0, 0.8),
    ("AgX", "None", 0.0, 1.0),
    ("AgX", "AgX - Punchy", 0.7, 1.0),
    ("Raw", "None", 0.0, 1.0),
]


def ramp():
    """Scene-linear colours of all hues from black to far beyond white."""
    values = np.exp2(np.linspace(-12, 5, SIDE * SIDE, dtype=np.float32))
    return values[:, None] * np.random.default_rng(7).random((SIDE * SIDE, 3), np.float32)


def saved_by_blender(scene, pixels, path):
    """What Blender saves of scene-linear pixels, 0..1."""
    image = bpy.data.images.new("ramp", SIDE, SIDE, float_buffer=True)
    image.pixels.foreach_set(np.concatenate((pixels, np.ones((len(pixels), 1), np.float32)), 1).ravel())
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "PNG", "RGB", "16"
    image.save_render(str(path), scene=scene)
    saved = bpy.data.images.load(str(path))
    saved.colorspace_settings.name = "Non-Color"
    values = np.empty(SIDE * SIDE * 4, np.float32)
    saved.pixels.foreach_get(values)
    return values.reshape(-1, 4)[:, :3]


def show_as(scene, view, look, exposure, gamma):
    settings = scene.view_settings
    try:
        settings.view_transform = view
        settings.look = look
    except TypeError:
        pytest.skip(f"no {view} with {look}: Blender 3.4 has no AgX, the 4.5 module runs this")
    settings.exposure, settings.gamma = exposure, gamma


@pytest.mark.parametrize("view, look, exposure, gamma", SHOWN)
def test_what_a_display_gets_is_what_blender_saves(scene, tmp_path, view, look, exposure, gamma):
    show_as(scene, view, look, exposure, gamma)
    pixels = ramp()
    ours = session.encode_for_display(display.export_display(scene, description.Scene()), pixels)
    saved = saved_by_blender(scene, pixels, tmp_path / "ramp.png")
    assert np.ptp(saved) > 0.7
    assert np.abs(ours - saved).max() < 1e-4


def test_display_is_that_of_the_scene_and_its_user(scene):
    scene.gridgather.use_perception = True
    scene.gridgather.noticeable, scene.gridgather.use_masking = 0.5, False
    scene.gridgather.display_white, scene.gridgather.display_black = 250, 0.05
    scene.gridgather.viewing_distance, scene.gridgather.display_density = 0.6, 96
    settings = export().settings
    assert (settings.noticeable, settings.use_masking) == (0.5, False)
    assert (settings.display.white, settings.display.black) == pytest.approx((250, 0.05))
    assert settings.display.pixels_per_degree == pytest.approx(39.58, abs=0.01)  # tan(1 degree) * 600 mm / 0.2646 mm
    assert settings.display.look == "" and settings.display.device == scene.display_settings.display_device


def test_masking_is_for_stills(scene):
    own = scene.gridgather
    assert (own.shown_as, export().settings.use_masking) == ("STILL", True)
    own.shown_as = "WALKTHROUGH"
    assert not export().settings.use_masking
    own.shown_as, own.use_masking = "STILL", False
    assert not export().settings.use_masking


def test_paper_is_judged_as_shown(scene):
    scene.gridgather.preset = "PAPER"
    settings = export().settings
    assert settings.display is not None
    assert (settings.noticeable, settings.use_masking) == (1, True)
    scene.gridgather.preset = "FINAL"
    assert export().settings.display is None and export().settings.noticeable == 0.25


def test_nobody_looks_unless_asked_to(scene):
    assert export().settings.display is None


def bend(mapping, curve, *points):
    """New points for one of the mapping's curves, which has two."""
    for point, place in zip(mapping.curves[curve].points, points):
        point.location = place
    for place in points[2:]:
        mapping.curves[curve].points.new(*place)
    mapping.update()


@pytest.mark.parametrize("view, extend", [("Standard", "EXTRAPOLATED"), ("Filmic", "HORIZONTAL")])
def test_curves_are_those_of_the_view(scene, tmp_path, view, extend):
    show_as(scene, view, "None", 0.5, 1.0)
    scene.view_settings.use_curve_mapping = True
    mapping = scene.view_settings.curve_mapping
    mapping.extend = extend
    mapping.black_level, mapping.white_level = (0.02, 0, 0), (0.9, 1, 1.5)
    bend(mapping, 0, (0, 0.1), (1, 0.8), (0.3, 0.5))
    bend(mapping, 2, (0, 0), (1, 0.6))
    bend(mapping, 3, (0, 0), (1, 1), (0.5, 0.4))
    pixels = ramp()
    ours = session.encode_for_display(display.export_display(scene, description.Scene()), pixels)
    saved = saved_by_blender(scene, pixels, tmp_path / "ramp.png")
    assert np.abs(ours - saved).max() < 2e-4
    scene.view_settings.use_curve_mapping = False
    without = session.encode_for_display(display.export_display(scene, description.Scene()), pixels)
    assert np.abs(ours - without).max() > 0.1


def test_white_balance_is_named(scene):
    if not hasattr(scene.view_settings, "use_white_balance"):
        pytest.skip("Blender 3.4 has no white balance, the 4.5 module runs this")
    scene.gridgather.use_perception = True
    scene.view_settings.use_white_balance = True
    assert any("white balance" in text for _, text in export().scene.messages)


def test_configuration_is_the_one_that_blender_reads(monkeypatch, tmp_path):
    own = display.config_path()
    assert own.endswith("config.ocio")
    monkeypatch.setenv("OCIO", str(tmp_path / "gone.ocio"))
    assert display.config_path() == own
    (tmp_path / "studio.ocio").write_text("")
    monkeypatch.setenv("OCIO", str(tmp_path / "studio.ocio"))
    assert display.config_path() == str(tmp_path / "studio.ocio")


def test_a_configuration_that_cannot_be_read_is_an_error():
    with pytest.raises(session.SessionError, match="nowhere"):
        session.encode_for_display(description.Display(config="/nowhere/config.ocio"), ramp())


def test_renders_are_judged_as_shown_and_say_if_they_cannot(scene, monkeypatch):
    link(quad(size=40))
    lamp("POINT").location.z = 3
    scene.gridgather.use_perception = True
    bpy.ops.render.render()
    statistics = json.loads(scene.gridgather_statistics)
    assert "perception" in next(iter(statistics.values()))["stages"]
    assert messages.of_scene(scene) == []
    monkeypatch.setenv("OCIO", __file__)
    bpy.ops.render.render()
    ((name, text, _),) = messages.of_scene(scene)
    assert name == "Color Management" and "sRGB" in text
