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
if not bpy.app.binary_path:  # these start Blender's program
    arguments += [f"--ignore={FOLDER / name}" for name in ("test_failures.py", "test_scenes.py", "test_variants.py")]
arguments += sys.argv[sys.argv.index("--") + 1 :]
code = int(pytest.main(arguments))
sys.stdout.flush()
if bpy.app.binary_path:
    sys.exit(code)
os._exit(code)  # the module's own end prints pages about memory
