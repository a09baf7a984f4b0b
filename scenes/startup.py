"""Blender's own start-up scene with a floor under the cube; the cube's material has no specular reflection."""
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import diffuse, picture, quads, save

bpy.ops.wm.read_factory_settings()
picture(480, 270, "Filmic")
material = bpy.data.objects["Cube"].material_slots[0].material
principled = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED")
specular = "Specular" if "Specular" in principled.inputs else "Specular IOR Level"
principled.inputs[specular].default_value = 0
# Before Blender 4 Cycles' Principled varies with roughness even without specular: 1 to 3 % brighter than a Lambertian
# cube at the start-up file's 0.5; at 0.36 its faces are within 0.5 %.
principled.inputs["Roughness"].default_value = 0.36
quads("floor", [((-20, -20, -1), (20, -20, -1), (20, 20, -1), (-20, 20, -1))], diffuse("floor", (0.6, 0.6, 0.6)))
save()
