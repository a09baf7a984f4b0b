"""pytest inside Blender: blender -b --factory-startup --python run_pytest.py -- PYTEST_ARGUMENTS"""

import sys
from pathlib import Path

import pytest

arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
folder = str(Path(__file__).parent)
code = pytest.main([folder, "-p", "no:cacheprovider", "--color=no", "-ra", *arguments])
sys.stdout.flush()
sys.exit(int(code))
