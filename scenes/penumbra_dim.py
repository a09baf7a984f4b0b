"""The penumbra scene with a lamp of a sixth: blender -b SCENE.blend --python penumbra_dim.py -- OUT.blend

A point of light from the front makes up for what the lamp lacks, so that eyes are used to about the same brightness.
"""
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import point_light, save

bpy.data.objects["lamp"].data.energy /= 6
point_light("fill", (0.2, -3.5, 4.0), 0, 620)
save()
