"""Parts of the toy room: bunting, building blocks, picture books."""
import math
import random

import bpy
from mathutils import Vector
from scene_tools import box, join

FLAGS = 12  # on one rope


def faces_object(name, vertices, faces, uvs, material):
    """An object from faces of any number of corners; uvs: one pair per vertex."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(v) for v in vertices], [], faces)
    layer = mesh.uv_layers.new()
    for loop in mesh.loops:
        layer.data[loop.index].uv = uvs[loop.vertex_index]
    mesh.materials.append(material)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(made)
    return made


def bunting(name, start, end, sag, materials, string):
    """A rope of triangular flags that hangs between two points."""
    start, end = Vector(start), Vector(end)

    def on_rope(t):
        return start.lerp(end, t) - Vector((0, 0, 4 * sag * t * (1 - t)))

    parts = []
    for i in range(FLAGS):
        a, b = on_rope((i + 0.12) / FLAGS), on_rope((i + 0.88) / FLAGS)
        tip = (a + b) / 2 + Vector((0, 0, -0.21)) + 0.02 * Vector((math.sin(i), math.cos(2 * i), 0))
        parts.append(faces_object("flag", [b, a, tip], [(0, 1, 2)], [(1, 1), (0, 1), (0.5, 0)],
                                  materials[i % len(materials)]))
    for i in range(FLAGS):
        a, b = on_rope(i / FLAGS), on_rope((i + 1) / FLAGS)
        down = Vector((0, 0, 0.006))
        parts.append(faces_object("string", [a - down, b - down, b, a], [(0, 1, 2, 3)], [(0, 0)] * 4, string))
    return join(name, parts)


def blocks(name, places, edge, materials, seed):
    """Cubes with a little play in how they are turned; places: (x, y, z) of the middles of their lower faces."""
    random.seed(seed)
    half = edge / 2
    return join(name, [box("block", (x - half, y - half, z), (x + half, y + half, z + edge),
                           materials[i % len(materials)], turn=random.uniform(-25, 25))
                       for i, (x, y, z) in enumerate(places)])


def standing_books(name, low, length, covers, seed):
    """Upright picture books along x from `low`, their backs to -y."""
    random.seed(seed)
    (x, y, z), end, made = low, low[0] + length, []
    while x < end - 0.03:
        thick, tall, deep = random.uniform(0.008, 0.026), random.uniform(0.22, 0.33), random.uniform(0.20, 0.24)
        made.append(box("book", (x, y - deep, z + 0.0005), (x + thick, y, z + tall), random.choice(covers)))
        x += thick + 0.0015
    return join(name, made)
