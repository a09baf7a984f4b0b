"""pytest inside Blender: blender -b --factory-startup --python run_pytest.py -- PYTEST_ARGUMENTS

or with Blender as a Python module: python3 run_pytest.py -- PYTEST_ARGUMENTS
"""

import os
import sys
from pathlib import Path

import bpy  # before pytest: makes Blender's own modules known
import pytest

FOLDER = Path(__file__).resolve().parent
arguments = [str(FOLDER), "-p", "no:cacheprovider", "--color=no", "-ra"]
if not bpy.app.binary_path:  # these start Blender's program, or need scenes that it has built
    for name in ("capture", "failures", "scenes", "variants"):
        arguments.append(f"--ignore={FOLDER / f'test_{name}.py'}")
arguments += sys.argv[sys.argv.index("--") + 1 :]
code = int(pytest.main(arguments))
sys.stdout.flush()
if bpy.app.binary_path:
    sys.exit(code)
os._exit(code)  # the module's own end prints pages about memory
