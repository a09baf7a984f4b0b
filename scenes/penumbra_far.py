"""The penumbra scene from four times as far: blender -b SCENE.blend --python penumbra_far.py -- OUT.blend"""
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import save

bpy.context.scene.camera = bpy.data.objects["far"]
save()
