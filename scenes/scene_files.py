"""Where scenes and their products lie; building a scene's .blend; the kept Cycles pictures that tests compare with.

Everything made lies under build/, named after the scene and a hash of what makes it; only truth_pictures/ is kept.
"""
import hashlib
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

SCENES = Path(__file__).resolve().parent
BUILD = SCENES.parent / "build"
TRUTH_SAMPLES = {"attic": 4096, "cornell_box": 4096, "furnace": 64, "library": 4096, "room": 1024, "startup": 4096,
                 "toy_room": 4096}
FIGURE_SCENES = ("masking", "penumbra")  # that have no truths
TRUTH_PERCENT = 50  # of the scene's own picture size


class SceneError(Exception):
    """Something the user can mend; the message says what."""


def set_up():
    """Install and build what is missing, unless GRIDGATHER_SETUP=done in the environment says that it has been done."""
    if os.environ.get("GRIDGATHER_SETUP") != "done":
        subprocess.run([SCENES / "setup"], check=True, stdout=sys.stderr)


def scene_names():
    """Scenes that have truths."""
    return sorted(TRUTH_SAMPLES)


def all_scene_names():
    return sorted([*TRUTH_SAMPLES, *FIGURE_SCENES])


def sources_hash(name):
    """12 hex digits for a script of this folder and every module of the folder that it comes to import."""
    sources, waiting = set(), [name]
    while waiting:
        source = SCENES / f"{waiting.pop()}.py"
        if source.is_file() and source not in sources:
            sources.add(source)
            waiting += re.findall(r"^(?:from|import) (\w+)", source.read_text(), re.MULTILINE)
    digest = hashlib.sha256()
    for source in sorted(sources, key=lambda source: (source.stem != name, source)):
        digest.update(source.read_bytes())
    return digest.hexdigest()[:12]


def scene_hash(name):
    """The hash of all that builds a scene."""
    if not (SCENES / f"{name}.py").is_file() or name not in all_scene_names():
        raise SceneError(f"no scene {name!r}; there are: {', '.join(all_scene_names())}")
    return sources_hash(name)


def run_blender(arguments, environment=None):
    """Run Blender in the background and return its output; any failure, a script's too, is a SceneError with it."""
    command = ["blender", "-b", "--factory-startup", "--python-exit-code", "3", *map(str, arguments)]
    result = subprocess.run(command, env={**os.environ, **(environment or {})}, stdin=subprocess.DEVNULL, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if result.returncode:
        told = "\n".join(line for line in result.stdout.splitlines() if not line.startswith("Fra:"))
        raise SceneError(f"{told}\nblender ended with code {result.returncode}: {shlex.join(command)}")
    return result.stdout


def scene_file(name):
    """The scene's .blend, built when its sources have changed."""
    return made(BUILD / "scenes" / f"{name}-{scene_hash(name)}.blend", ["--python", SCENES / f"{name}.py"])


def variant_file(name, script):
    """The scene's .blend as a script of this folder changes it: SCRIPT.py is run in it with the path to save to."""
    path = BUILD / "scenes" / f"{name}-{script}-{scene_hash(name)}-{sources_hash(script)}.blend"
    return made(path, [scene_file(name), "--python", SCENES / f"{script}.py"])


def cycles_picture(blend, samples, seed=1):
    """The 32-bit picture by cycles_reference.py of a .blend whose name has its hash, at TRUTH_PERCENT; made once."""
    path = BUILD / "truth" / f"{blend.stem}-{samples}-seed{seed}.exr"
    return made(path, [blend, "--python", SCENES / "cycles_reference.py"], samples, TRUTH_PERCENT, seed)


def made(path, command, *more):
    """`path`; if there is no such file, Blender makes it: its arguments are `command`, `--`, where to write, `more`."""
    if not path.exists():
        path.parent.mkdir(parents=True, exist_ok=True)
        partial = path.with_suffix(f".partial{path.suffix}")
        run_blender([*command, "--", partial, *more])
        partial.rename(path)
    return path


def truth_file(name):
    """Where the kept picture of a scene lies: half-float RGB, TRUTH_PERCENT of the scene's size."""
    return SCENES / "truth_pictures" / f"{name}.exr"


def check_truth(name):
    """Raise SceneError unless the kept truth belongs to the scene as its script now builds it. Returns its path."""
    import OpenImageIO

    path = truth_file(name)
    if not path.exists():
        raise SceneError(f"{name}: no kept truth; make it with scenes/truth {name}")
    spec = OpenImageIO.ImageBuf(str(path)).spec()
    made_for, samples = spec.get_string_attribute("scene_hash"), spec.get_int_attribute("cycles_samples")
    if made_for != scene_hash(name):
        raise SceneError(f"{name}: the kept truth ({samples} samples) is of scene {made_for}, but the scripts now "
                         f"build {scene_hash(name)}; make it anew with scenes/truth {name}")
    return path
