"""Where scenes and their products lie; building a scene's .blend; the kept Cycles pictures that tests compare with.

Everything made lies under build/, named after the scene and a hash of what makes it; only truth_pictures/ is kept.
"""
import hashlib
import os
import re
import shlex
import subprocess
from pathlib import Path

SCENES = Path(__file__).resolve().parent
BUILD = SCENES.parent / "build"
TRUTH_SAMPLES = {"attic": 4096, "cornell_box": 4096, "furnace": 64, "library": 4096, "room": 1024, "startup": 4096,
                 "toy_room": 4096}
TRUTH_PERCENT = 50  # of the scene's own picture size


class SceneError(Exception):
    """Something the user can mend; the message says what."""


def scene_names():
    return sorted(TRUTH_SAMPLES)


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
    if not (SCENES / f"{name}.py").is_file() or name not in TRUTH_SAMPLES:
        raise SceneError(f"no scene {name!r}; there are: {', '.join(scene_names())}")
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
    path = BUILD / "scenes" / f"{name}-{scene_hash(name)}.blend"
    if not path.exists():
        partial = path.with_suffix(".partial.blend")
        run_blender(["--python", SCENES / f"{name}.py", "--", partial])
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
