"""Which images go by file and which by pixels, and in which colour space."""

import bpy
import numpy as np
import pytest
from gridgather import description
from gridgather.export.image import export_image


@pytest.fixture
def result():
    return description.Scene()


def ramp(name="Ramp", width=3, height=2, **options):
    """A generated image whose red counts pixels from the lower left in steps of 1/8."""
    image = bpy.data.images.new(name, width, height, **options)
    pixels = np.ones((height * width, 4), np.float32)
    pixels[:, 0] = np.arange(height * width) / 8
    image.pixels.foreach_set(pixels.ravel())
    image.update()
    return image


def saved(tmp_path, name="picture.png"):
    image = ramp()
    image.filepath_raw, image.file_format = str(tmp_path / name), "PNG"
    image.save()
    return bpy.data.images.load(str(tmp_path / name))


def check_ramp(exported):
    assert exported.path is None and exported.pixels.shape == (2, 3, 4) and exported.pixels.dtype == np.float32
    assert exported.pixels[..., 0] == pytest.approx(np.arange(6).reshape(2, 3) / 8, abs=1 / 255)


def test_file_goes_by_path(tmp_path, result):
    exported = export_image(saved(tmp_path), result)
    assert exported.path == str(tmp_path / "picture.png") and exported.pixels is None
    assert exported.color_space == description.COLOR_SRGB
    assert result.messages == []


def test_relative_path_is_made_absolute(tmp_path, result):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "file.blend"))
    saved(tmp_path)
    exported = export_image(bpy.data.images.load("//picture.png"), result)
    assert exported.path == str(tmp_path / "picture.png")


def test_missing_file_is_left_to_the_library(tmp_path, result):
    image = saved(tmp_path)
    image.filepath = str(tmp_path / "gone.png")
    assert export_image(image, result).path == str(tmp_path / "gone.png")


def test_packed_image_goes_by_pixels(tmp_path, result):
    image = saved(tmp_path)
    image.pack()
    exported = export_image(image, result)
    check_ramp(exported)
    assert exported.color_space == description.COLOR_SRGB


def test_painted_image_goes_by_pixels(tmp_path, result):
    image = saved(tmp_path)
    image.pixels[0] = 1.0
    assert image.is_dirty
    exported = export_image(image, result)
    assert exported.path is None and exported.pixels[0, 0, 0] == 1


def test_generated_image_goes_by_pixels(result):
    check_ramp(export_image(ramp(), result))


def test_float_pixels_are_linear_already(result):
    image = ramp(float_buffer=True)
    image.colorspace_settings.name = "sRGB"
    assert export_image(image, result).color_space == description.COLOR_LINEAR


@pytest.mark.parametrize("name", ["Non-Color", "Linear" if bpy.app.version < (4, 0, 0) else "Linear Rec.709"])
def test_data_is_linear(result, name):
    image = ramp()
    image.colorspace_settings.name = name
    assert export_image(image, result).color_space == description.COLOR_LINEAR
    assert result.messages == []


def test_other_colour_spaces_are_reported(result):
    image = ramp()
    image.colorspace_settings.name = "Filmic Log" if bpy.app.version < (4, 0, 0) else "AgX Log"
    assert export_image(image, result).color_space == description.COLOR_SRGB
    ((name, text),) = result.messages
    assert name == "Ramp" and "Log" in text


def test_tiled_image_gives_its_first_tile(tmp_path, result):
    for number in (1001, 1002):
        saved(tmp_path, f"tile.{number}.png")
    image = bpy.data.images.load(str(tmp_path / "tile.1001.png"))
    image.source = "TILED"
    exported = export_image(image, result)
    assert exported.path == str(tmp_path / "tile.1001.png")
    assert "first tile" in result.messages[0][1]


def test_sequence_gives_one_frame(tmp_path, result):
    image = saved(tmp_path, "frame_0001.png")
    image.source = "SEQUENCE"
    assert export_image(image, result).path == str(tmp_path / "frame_0001.png")
    assert "one frame" in result.messages[0][1]


def test_image_without_pixels_is_magenta(result):
    image = ramp()
    image.source = "MOVIE"
    exported = export_image(image, result)
    assert exported.pixels.tolist() == [[[1, 0, 1, 1]]]
    assert "magenta" in result.messages[-1][1]
