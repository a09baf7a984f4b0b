"""The library through ctypes, without Blender's data."""

import ctypes
import re
import subprocess
from pathlib import Path

import numpy as np
import pytest
from gridgather import description, interface, session
from gridgather.upload import upload

INCLUDE = Path(__file__).parents[1] / "native" / "include"


def glowing_square():
    """Two triangles that fill the view, reflect half and emit radiance 0.25 in a black world: 0.25 everywhere."""
    scene = description.Scene()
    gray, glow = description.Color((0.5, 0.5, 0.5)), description.Color((0.25, 0.25, 0.25))
    scene.materials.append(description.Material("glowing", gray, glow))
    positions = np.array([[-9, -9, 0], [9, -9, 0], [9, 9, 0], [-9, 9, 0]], np.float32)
    scene.meshes.append(description.Mesh("square", positions, np.array([[0, 1, 2], [0, 2, 3]], np.uint32)))
    matrix = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0)
    scene.instances.append(description.InstanceGroup((0,), [0], [matrix], [7], [0], ["square"]))
    return scene


def above(distance=1.0):
    matrix = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, distance)
    return description.Camera(description.CAMERA_PERSPECTIVE, matrix, (-1, 1, -1, 1), 0.1, 100)


def rendered(scene, settings, camera=None):
    """(pixels, statistics, messages)"""
    pixels = np.full((settings.crop[3], settings.crop[2], 4), np.nan, np.float32)
    with session.Scene() as native:
        upload(scene, native)
        with native.start(camera or above(), settings) as render:
            progress = render.wait(60)
            assert progress.finished and progress.status == interface.OK, render.error()
            kept = {"Combined": pixels}
            assert render.copy_finished_tiles(kept) and not render.copy_finished_tiles(kept)
            return pixels, render.statistics(), render.messages()


def test_two_triangles():
    pixels, statistics, messages = rendered(glowing_square(), description.Settings(40, 30, (0, 0, 40, 30)))
    assert pixels[..., :3] == pytest.approx(np.full((30, 40, 3), 0.25), rel=1e-3)
    assert pixels[..., 3] == pytest.approx(np.ones((30, 40)))
    assert set(statistics) == {"stages", "counts", "memory"}
    assert messages == []


def test_crop_is_part_of_the_whole():
    scene = glowing_square()
    scene.world = (1, 0, 0)
    far = above(20)
    whole, _, _ = rendered(scene, description.Settings(64, 48, (0, 0, 64, 48)), far)
    scene = glowing_square()
    scene.world = (1, 0, 0)
    part, _, _ = rendered(scene, description.Settings(64, 48, (20, 5, 30, 25)), far)
    assert np.array_equal(part, whole[5:30, 20:50])


def test_every_kind_of_thing_arrives():
    scene = glowing_square()
    square = scene.meshes[0]
    square.triangle_corners = square.triangle_vertices
    square.corner_count = 4
    square.corner_normals = np.tile(np.float32([0, 0, 1]), (4, 1))
    square.corner_uvs = np.zeros((4, 2), np.float32)
    square.triangle_slots = np.array([0, 1], np.uint32)
    scene.images.append(description.Image("image", pixels=np.full((2, 2, 4), 0.5, np.float32), color_space=1))
    scene.materials.append(description.Material("textured", description.Color((0.5, 0.5, 0.5), 0)))
    scene.instances[0].materials = (0, 1)
    matrix = (1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 3)
    scene.lights.append(description.Light("lamp", description.LIGHT_POINT, matrix, (10, 10, 10), 8, radius=0.1))
    scene.say("thing", "was left out")
    pixels, _, messages = rendered(scene, description.Settings(16, 16, (0, 0, 16, 16)))
    assert np.isfinite(pixels).all() and pixels[..., :3].min() > 0
    assert messages == [("thing", "was left out", 1)]
    assert scene.meshes == [] and scene.images == []  # handed over


def test_errors_of_the_library_become_exceptions():
    scene = glowing_square()
    scene.meshes[0].triangle_vertices[0, 0] = 99
    with session.Scene() as native, pytest.raises(session.SessionError, match=r"\w+ \w+"):
        upload(scene, native)
    with session.Scene() as native:
        upload(glowing_square(), native)
        with pytest.raises(session.SessionError):
            native.start(above(), description.Settings(0, 0, (0, 0, 0, 0)))


def test_cancelled_render_finishes_as_cancelled():
    with session.Scene() as native:
        upload(glowing_square(), native)
        settings = description.Settings(4096, 4096, (0, 0, 4096, 4096), samples=64)
        with native.start(above(), settings) as render:
            render.cancel()
            progress = render.wait(10)
            assert progress.finished and progress.status == interface.CANCELLED


def test_handles_close_twice_without_harm():
    with session.Scene() as native:
        upload(glowing_square(), native)
        render = native.start(above(), description.Settings(8, 8, (0, 0, 8, 8)))
        render.close()
        render.close()
    native.close()
    assert not native.pointer and not render.pointer


def test_structs_are_those_of_the_header(tmp_path):
    structs = {
        "gg_image": interface.Image,
        "gg_color_input": interface.ColorInput,
        "gg_material": interface.Material,
        "gg_mesh": interface.Mesh,
        "gg_instances": interface.Instances,
        "gg_light": interface.Light,
        "gg_camera": interface.Camera,
        "gg_settings": interface.Settings,
        "gg_progress": interface.Progress,
        "gg_tile": interface.Tile,
        "gg_message": interface.Message,
    }
    lines, expected = [], []
    for name, struct in structs.items():
        lines.append(f'printf("{name} %zu\\n", sizeof({name}));')
        expected.append(f"{name} {ctypes.sizeof(struct)}")
        for field, *_ in struct._fields_:
            lines.append(f'printf("{name}.{field} %zu\\n", offsetof({name}, {field}));')
            expected.append(f"{name}.{field} {getattr(struct, field).offset}")
    source = tmp_path / "layout.c"
    includes = '#include <stddef.h>\n#include <stdio.h>\n#include "gridgather.h"\n'
    source.write_text(includes + "int main(void) {\n" + "\n".join(lines) + "\nreturn 0; }\n")
    subprocess.run(["cc", "-I", INCLUDE, source, "-o", tmp_path / "layout"], check=True)
    output = subprocess.run([tmp_path / "layout"], capture_output=True, text=True, check=True).stdout
    assert output.splitlines() == expected


def test_constants_are_those_of_the_header():
    header = (INCLUDE / "gridgather.h").read_text()
    values = {name: int(value, 0) for name, value in re.findall(r"\bGG_(\w+) = (\d+)", header)}
    for name in ("COLOR_SRGB", "COLOR_LINEAR", "FILTER_CLOSEST", "HIDDEN_FROM_CAMERA", "HIDDEN_FROM_LIGHT"):
        assert values[name] == getattr(description, name)
    for name in ("EXTENSION_EXTEND", "EXTENSION_CLIP", "EXTENSION_MIRROR", "LIGHT_SPOT", "LIGHT_SUN", "LIGHT_AREA"):
        assert values[name] == getattr(description, name)
    for name in ("AREA_ELLIPSE", "CAMERA_ORTHOGRAPHIC", "METHOD_SOLUTION"):
        assert values[name] == getattr(description, name)
    assert (values["OK"], values["CANCELLED"]) == (interface.OK, interface.CANCELLED)
    assert f"#define GG_INTERFACE_VERSION {interface.INTERFACE_VERSION}\n" in header


def test_functions_are_those_of_the_header():
    header = (INCLUDE / "gridgather.h").read_text()
    declared = {}
    for name, arguments in re.findall(r"^GG_API [^;(]*?(gg_\w+)\(([^)]*)\)", header, re.MULTILINE):
        declared[name] = 0 if arguments == "void" else arguments.count(",") + 1
    assert declared == {name: len(arguments) for name, (_, arguments) in interface._SIGNATURES.items()}


def library_of(tmp_path, source):
    """Compiles a library and makes it the one that the add-on loads."""
    (tmp_path / "other.c").write_text(source)
    library = tmp_path / "libgridgather.so"
    subprocess.run(["cc", "-shared", "-fPIC", "-o", library, tmp_path / "other.c"], check=True)
    return str(library)


BROKEN = {
    "missing": (None, "No such file"),
    "without symbols": ("int unrelated(void) { return 0; }", "undefined symbol"),
    "other version": (
        "int gg_processor_supported(void) { return 1; } unsigned gg_interface_version(void) { return 99; }",
        "interface version 99, the add-on needs",
    ),
    "other processor": (
        "int gg_processor_supported(void) { return 0; } unsigned gg_interface_version(void) { return 1; }",
        "processor",
    ),
}


@pytest.mark.parametrize("case", BROKEN)
def test_unusable_library_says_why(tmp_path, monkeypatch, case):
    source, reason = BROKEN[case]
    path = library_of(tmp_path, source) if source else str(tmp_path / "libgridgather.so")
    monkeypatch.setattr(interface, "LIBRARY_PATH", path)
    assert reason in interface.failure()
    with pytest.raises(interface.LibraryError, match=reason):
        session.Scene()
