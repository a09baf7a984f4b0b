"""Whatever goes wrong, a farm sees it: exit code 1, no picture, a reason, and never a crash of Blender."""

import os
import shutil
import subprocess
from pathlib import Path

import bpy
import gridgather
import pytest

FLOOR = """
import bpy
bpy.ops.mesh.primitive_plane_add()
bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 32
"""


class Blender:
    """Runs `blender -b --addons gridgather -E GRIDGATHER -o OUT -f 1` on the start-up scene."""

    def __init__(self, folder):
        self.folder = folder
        self.scripts = Path(gridgather.__file__).parents[2]

    def __call__(self, script="", file_format="PNG"):
        self.folder.mkdir(exist_ok=True)
        (self.folder / "script.py").write_text(FLOOR + script)
        command = [bpy.app.binary_path, "-b", "--factory-startup", "--addons", "gridgather", "--python-exit-code", "7"]
        command += ["--python", str(self.folder / "script.py"), "-E", "GRIDGATHER", "-o", str(self.folder / "out_#")]
        command += ["-F", file_format, "-f", "1"]
        environment = {**os.environ, "BLENDER_USER_SCRIPTS": str(self.scripts)}
        done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=120)
        self.output = done.stdout + done.stderr
        return done.returncode

    @property
    def pictures(self):
        return [path.name for path in self.folder.glob("out_*")]


@pytest.fixture
def blender(tmp_path):
    return Blender(tmp_path / "run")


def test_good_scene_exits_0_with_a_picture(blender):
    assert blender() == 0, blender.output
    assert blender.pictures == ["out_1.png"]
    assert "could not convert" not in blender.output


def test_problems_that_do_not_stop_exit_0_with_a_picture(blender):
    script = "bpy.context.object.is_holdout = True"
    assert blender(script) == 0
    assert blender.pictures == ["out_1.png"]
    assert blender.output.count("Plane: Holdout is ignored") == 1


def test_no_camera(blender):
    assert blender("bpy.context.scene.camera = None") == 1
    assert blender.pictures == []
    assert "camera" in blender.output


def test_panoramic_camera(blender):
    assert blender("bpy.context.scene.camera.data.type = 'PANO'") == 1
    assert blender.pictures == []
    assert "neither perspective nor orthographic" in blender.output


@pytest.mark.parametrize("file_format", ["PNG", "OPEN_EXR", "OPEN_EXR_MULTILAYER"])
@pytest.mark.parametrize(
    "broken",
    [
        "engine.export_frame",  # in update()
        "engine.upload",  # in render(), before the library runs
        "session.Render.wait",  # while it runs
        "session.Render.statistics",  # after it
        "engine.write_pixels",  # while its tiles are shown
        "messages.keep",  # in the last clean-up
    ],
)
def test_exception_in_a_callback(blender, broken, file_format):
    owner, name = broken.rsplit(".", 1)
    script = f"""
import gridgather
from gridgather import engine, messages, session
def broken(*args, **kwargs):
    raise ValueError("broken on purpose")
setattr({owner}, "{name}", broken)
"""
    assert blender(script, file_format) == 1, blender.output
    assert blender.pictures == []
    assert "Gridgather failed: ValueError: broken on purpose" in blender.output


@pytest.mark.parametrize("where", ["engine.export_frame", "session.Scene.start", "session.Render.wait"])
def test_break_event_ends_the_render_soon(blender, where):
    """Blender in the background takes the first interrupt for the Esc key."""
    owner, name = where.rsplit(".", 1)
    script = f"""
import os, signal, time
import gridgather
from gridgather import engine, session
original = {where}
def interrupted(*args, **kwargs):
    setattr({owner}, "{name}", original)
    os.kill(os.getpid(), signal.SIGINT)
    return original(*args, **kwargs)
setattr({owner}, "{name}", interrupted)
bpy.context.scene.render.resolution_x = bpy.context.scene.render.resolution_y = 4000
bpy.context.scene.gridgather.samples = 256
start = time.perf_counter()
bpy.app.handlers.render_cancel.append(lambda *_: print("CANCELLED AFTER", time.perf_counter() - start))
"""
    blender(script)
    assert "Error" not in blender.output and "Traceback" not in blender.output
    seconds = float(blender.output.split("CANCELLED AFTER")[1].split()[0])
    assert seconds < 5


def test_script_that_renders_gets_an_exception(blender):
    script = """
bpy.context.scene.render.engine = "GRIDGATHER"
bpy.context.scene.camera.data.type = "PANO"
try:
    bpy.ops.render.render()
except RuntimeError as error:
    print("CAUGHT", error)
"""
    blender(script)
    assert "CAUGHT" in blender.output and "neither perspective nor orthographic" in blender.output


def copy_addon(blender, library=None):
    """The add-on without its library, or with another file in its place."""
    folder = blender.folder / "scripts" / "addons" / "gridgather"
    shutil.copytree(Path(gridgather.__file__).parent, folder, ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    if library:
        (folder / "libgridgather.so").write_text(library)
    blender.scripts = blender.folder / "scripts"


@pytest.mark.parametrize("library", [None, "not a library"])
def test_library_that_does_not_load(blender, library):
    copy_addon(blender, library)
    assert blender("print('PRESET', bpy.context.scene.gridgather.preset)", "OPEN_EXR") == 1
    assert "PRESET FINAL" in blender.output  # registered all the same
    assert "Gridgather's library cannot be loaded" in blender.output
    assert blender.pictures == []
