"""The penumbra scene with a lamp of a sixth: blender -b SCENE.blend --python penumbra_dim.py -- OUT.blend

What it lacks comes from a lamp without shadows to speak of, so that the floor stays as bright.
"""
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import area_light, save

lamp = bpy.data.objects["lamp"]
lamp.data.energy /= 6
area_light("sky", (0.4, 0.6, 8), (0, 0, -1), 14, 14, 2600)
save()
