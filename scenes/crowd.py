"""A hall for 100 sets of toys, each about 30,000 triangles: how does the cost grow?

blender -b --python crowd.py -- OUT.blend COPIES (unique|instances)
COPIES (1 to 100) sets are spread over the floor; each has a mesh of its own or all share one.
"""
import math
import random
import sys
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from scene_pictures import oak_floor
from scene_tools import area_light, camera, diffuse, extent, furniture, image, join, quads, reset, save

CELLS, CELL, HEIGHT = 10, 1.1, 3.2  # the floor has CELLS x CELLS places, CELL metres apart
SIDE = CELLS * CELL + 1


def shell():
    """A closed room around the origin."""
    white, half = diffuse("white paint", (0.75, 0.74, 0.72)), SIDE / 2
    a, b, c, d = (-half, -half), (half, -half), (half, half), (-half, half)
    quads("floor", [tuple((*corner, 0) for corner in (a, b, c, d))],
          diffuse("oak floor", image("oak floor", oak_floor(1024))), tile=2.4)
    quads("ceiling", [tuple((*corner, HEIGHT) for corner in (a, d, c, b))], white)
    for name, start, end in (("front", a, b), ("right", b, c), ("back", c, d), ("left", d, a)):
        quads(f"wall {name}", [((*end, 0), (*start, 0), (*start, HEIGHT), (*end, HEIGHT))], white)
    for x in (-SIDE / 4, SIDE / 4):
        for y in (-SIDE / 4, SIDE / 4):
            area_light("ceiling light", (x, y, HEIGHT - 0.01), (0, 0, -1), 1.2, 1.2, 160)


def toys():
    """One set as one object: a rocking horse, a chair with a plant on it, a deer and a wooden toy."""
    parts = [furniture("rocking horse", "CC-0", "caballito", (-0.1, 0.2, 0), turn=30),
             furniture("child chair", "CC-BY", "childChair", (0.22, -0.18, 0), turn=-20),
             furniture("plant", "CC-0", "littlePlant", (0.22, -0.18, 0.345), scale=0.8),
             furniture("deer", "CC-0", "deer", (-0.2, -0.3, 0), turn=200, scale=1.6),
             furniture("wood toy", "CC-0", "woodToy", (-0.02, -0.4, 0), turn=75, scale=1.4)]
    bpy.context.view_layer.update()
    for part in parts:
        part.data.transform(part.matrix_world)
        part.matrix_world.identity()
    return join("toys", parts)


def place(first, copies, unique):
    """Spread sets over the floor: one is in the middle, many fill the cells in an order that mixes them."""
    order = [((i * 37 + 55) % CELLS ** 2) for i in range(copies)]
    random.seed(3)
    for index, cell in enumerate(order):
        thing = first
        if index:
            thing = bpy.data.objects.new(f"toys {index}", first.data.copy() if unique else first.data)
            bpy.context.collection.objects.link(thing)
        row, column = divmod(cell, CELLS)
        thing.location = ((column - (CELLS - 1) / 2) * CELL, (row - (CELLS - 1) / 2) * CELL, -extent(first)[0][2])
        thing.rotation_euler = (0, 0, math.radians(random.uniform(0, 360)))


def main():
    copies, kind = int(sys.argv[sys.argv.index("--") + 2]), sys.argv[sys.argv.index("--") + 3]
    reset(640, 360, "Filmic")
    shell()
    place(toys(), copies, kind == "unique")
    camera((0, -SIDE / 2 + 0.3, 2.1), (0, 0.5, 0.6), 75)
    save()


main()
