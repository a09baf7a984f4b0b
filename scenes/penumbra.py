"""After figure 6 of the paper: a board leans over a floor; its shadow is sharp at one end and blurred at the other.

Cameras "near" (the scene's own) and "far", four times as far off; penumbra_far.py and penumbra_dim.py change to that,
and to a lamp of a sixth.
"""
import math
import sys
from pathlib import Path

import bpy
from mathutils import Matrix

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import area_light, box, camera, diffuse, quads, reset, save

TARGET, EYE = (0.1, 0.2, 0.15), (0.3, -2.6, 1.7)

reset(400, 300)
quads("floor", [((-12, -12, 0), (12, -12, 0), (12, 12, 0), (-12, 12, 0))], diffuse("floor", (0.6, 0.58, 0.55)))
board = box("board", (0, -0.22, 0), (1.5, 0.22, 0.03), diffuse("board", (0.35, 0.2, 0.1)))
board.data.transform(Matrix.Translation((-0.75, 0.25, 0.02)) @ Matrix.Rotation(-math.radians(28), 4, "Y"))
area_light("lamp", (0.4, 0.6, 4.2), (-0.1, -0.1, -1), 0.8, 0.8, 260, (1.0, 0.94, 0.86))
far = tuple(t + 4 * (e - t) for e, t in zip(EYE, TARGET))
camera(far, TARGET, 42)
bpy.data.objects["Camera"].name = "far"
camera(EYE, TARGET, 42)
bpy.data.objects["Camera"].name = "near"
save()
