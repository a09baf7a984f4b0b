"""FLIP: how different pictures look that take each other's place [Andersson et al. 2020], by its authors' package.

The package comes from PyPI on first use, into an environment of its own under build/; NumPy is the system's.
"""
import subprocess

import scene_files as files

_PACKAGE = "flip-evaluator==1.7"
_PYTHON = files.BUILD / "flip" / "bin" / "python"
_PROGRAM = """import sys
import flip_evaluator
print(flip_evaluator.evaluate(*sys.argv[1:3], "LDR", applyMagma=False)[1])"""


def mean_flip(reference, test):
    """Mean over pixels, 0..1, of two PNG files of one size, for the package's usual display and distance."""
    if not _PYTHON.exists():
        for command in (["/usr/bin/python3", "-m", "venv", "--system-site-packages", _PYTHON.parents[1]],
                        [_PYTHON, "-m", "pip", "install", "--quiet", _PACKAGE]):
            _run(command)
    return float(_run([_PYTHON, "-c", _PROGRAM, reference, test]).split()[-1])


def _run(command):
    done = subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        raise files.SceneError(f"{' '.join(map(str, command[:4]))} failed:\n{done.stdout}")
    return done.stdout
