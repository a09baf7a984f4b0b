"""A furnace: everything reflects half and emits the same, so every radiance is EMISSION / (1 - ALBEDO)."""
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import box, camera, diffuse, reset, save

ALBEDO, EMISSION = 0.5, 0.25

reset(320, 180)
glowing = diffuse("glowing", (ALBEDO,) * 3, (EMISSION,) * 3)
room = box("room", (-3, -3, 0), (3, 3, 3), glowing)
room.data.flip_normals()
box("cube", (0.5, -0.2, 0), (1.7, 1.0, 1.2), glowing, turn=30)
box("plate", (-1.9, 0.9, 1.4), (0.1, 1.7, 1.45), glowing, turn=-15)
bpy.ops.mesh.primitive_uv_sphere_add(segments=48, ring_count=24, radius=0.7, location=(-1.0, 0, 0.7))
sphere = bpy.context.object
sphere.name = "sphere"
sphere.data.materials.append(glowing)
bpy.ops.object.shade_smooth()
camera((0, -2.8, 1.6), (0, 0, 1.1), 65)
save()
