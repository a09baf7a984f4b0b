"""The architecture, held against every #include: layers look down only, and each library has one place."""

import re
import subprocess
from pathlib import Path

import gridgather
import pytest

NATIVE = Path(__file__).parents[1] / "native"
# Highest first; include/ is the face that all may see, apps, bench and tests stand outside.
LAYERS = (
    *("api", "render", "gather", "film", "radiosity", "transport"),
    *("trace", "material", "scene", "image", "perception", "core"),
)
# Library -> where alone it may be included.
FENCES = {
    "embree3/": "trace/",
    "embree4/": "trace/",
    "OpenImageIO/": "image/",
    "OpenColorIO/": "image/",
    "tbb/": "core/parallel",
    "oneapi/": "core/parallel",
    "glm/": "core/",
}
_INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def includes():
    """(file, how, what) of every #include of the layers."""
    for layer in LAYERS:
        for path in sorted((NATIVE / layer).rglob("*")):
            if path.suffix in {".h", ".cpp"}:
                for how, what in _INCLUDE.findall(path.read_text()):
                    yield path.relative_to(NATIVE), how, what


def violation(path, how, what):
    """What is wrong with an #include, or None."""
    for library, place in FENCES.items():
        if what.startswith(library):
            return None if str(path).startswith(place) else f"{path} includes {what}: only {place} may"
    if how == "<" or what == "gridgather.h":
        return None
    layer = what.split("/")[0]
    if layer not in LAYERS:
        return f"{path} includes {what}: not a path from native/"
    if LAYERS.index(layer) < LAYERS.index(path.parts[0]):
        return f"{path} includes {what}: points up"
    return None


def test_includes_point_down():
    found = list(includes())
    assert len(found) > 100
    assert [message for message in (violation(*include) for include in found) if message] == []


@pytest.mark.parametrize(
    "path, how, what, wrong",
    [
        ("core/vec.h", "<", "glm/glm.hpp", False),
        ("scene/scene.h", "<", "glm/glm.hpp", True),
        ("trace/embree_api.h", "<", "embree3/rtcore.h", False),
        ("radiosity/solve.cpp", "<", "embree4/rtcore.h", True),
        ("core/random.h", "<", "tbb/parallel_for.h", True),
        ("core/vec.h", '"', "scene/scene.h", True),
        ("scene/scene.h", '"', "core/vec.h", False),
        ("scene/scene.cpp", '"', "scene.h", True),
        ("api/scene.cpp", '"', "gridgather.h", False),
    ],
)
def test_rule_itself(path, how, what, wrong):
    assert bool(violation(Path(path), how, what)) == wrong


def test_library_exports_its_interface_alone():
    library = Path(gridgather.__file__).with_name("libgridgather.so")
    table = subprocess.run(["nm", "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    exported = {line.split()[-1] for line in table.splitlines()}
    header = (NATIVE / "include" / "gridgather.h").read_text()
    assert exported == set(re.findall(r"^GG_API [^;(]*?(gg_\w+)\(", header, re.MULTILINE))
