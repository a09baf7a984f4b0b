"""A public library's reading hall: models of many authors (see README.md), 14 windows, 60 ceiling lamps, 6 desk lamps.

x to the right, y away from the camera, z up. Along the right wall runs a gallery on columns; daylight comes through
tall windows on the left and high ones behind.
"""
import math
import random
import sys
from pathlib import Path

from mathutils import Matrix

sys.path.insert(0, str(Path(__file__).parent))
from interior import framed
from library_books import Boxes, open_book, table_pile, unit
from library_hall import (
    BACK,
    BACK_WALL,
    GALLERY,
    LEFT,
    RIGHT,
    ceiling_lamps,
    dark_oak,
    gallery,
    oak,
    shell,
    windows,
)
from library_parts import disk, forget, globe, plant_again, turned_solid
from library_pictures import clock_face, earth, paper_edge, portrait_of_a_tree, printed_page, runner, spines
from repeated import again, plant
from scene_pictures import painting
from scene_tools import box, camera, diffuse, furniture, image, join, point_light, save

AISLE = -0.5  # the middle of the carpet and of the door
STACK_X = (1.35, 3.17)
STACK_ROWS = (6.8, 9.1, 11.4, 13.7, 16.0)
TABLE_ROWS = (5.6, 8.7, 11.8, 14.9)
TABLE_TOP = 0.739
DESK_WATTS = 5

brass = diffuse("brass", (0.52, 0.37, 0.14))
paper = [diffuse("backs of books", image("backs of books", spines(1024, 512))),
         diffuse("leaves of books", image("leaves of books", paper_edge(256)))]


def shelves():
    """Shelf units of four kinds, each filled in two or three ways; all are linked duplicates of these."""
    materials = [oak, *paper]
    low = [unit(f"stack kind {k}", 1.8, 1.42, 4, 10 + k, materials, double=True) for k in (1, 2, 3)]
    high = [unit(f"high stack kind {k}", 1.8, 2.05, 6, 20 + k, materials, double=True) for k in (1, 2)]
    wall = [unit(f"wall shelf kind {k}", 2.0, 2.28, 6, 30 + k, materials) for k in (1, 2, 3)]
    bench = [unit(f"low shelf kind {k}", 1.85, 0.78, 2, 40 + k, materials) for k in (1, 2)]
    for line, y in enumerate(STACK_ROWS):
        for side, x in enumerate(STACK_X):
            kinds = low if line < 3 else high
            put(kinds, 2 * line + side, (x, y, 0), 180 * ((line + side) % 2), "stack")
    for k in range(9):
        y = 1.8 + 2.04 * k
        put(wall, k, (RIGHT - 0.003, y, 0), -90, "wall shelf")
        put(wall, k + 1, (RIGHT - 0.003, y, GALLERY), -90, "gallery shelf", 0.9)
    for k in range(10):
        put(bench, k, (LEFT + 0.003, 1.0 + 2.0 * k, 0), 90, "low shelf")
    for k, x in enumerate((-6.56, -4.53, 3.4), 9):
        put(wall, k, (x, BACK - 0.003, 0), 0, "wall shelf")
    forget(*[part for kinds in (low, high, wall, bench) for pair in kinds for part in pair])


def put(kinds, number, location, turn, name, scale=1.0):
    """A unit of one of several kinds: its wood and its books."""
    for part, what in zip(kinds[number % len(kinds)], (name, f"{name} books")):
        again(part, f"{what} {number + 1}", location, turn, scale)


def reading_tables():
    """Two tables in a line and four lines of them; chairs at both sides, lamps and books on top."""
    random.seed(3)
    table = furniture("table", "CC-0", "table", (-2.3, TABLE_ROWS[0], 0))
    for slot in table.material_slots:
        slot.material = oak
    chair = furniture("chair", "CC-0", "chairWithCushion", (0, 0, 0),
                      colours={"Cloth": (0.10, 0.20, 0.24), "ChairWood": (0.33, 0.19, 0.10)})
    lamp = furniture("desk lamp", "CC-0", "desklamp", (0, 0, 0),
                     colours={"Material": (0.50, 0.36, 0.14), "Material.002": (0.06, 0.24, 0.14)})
    volume = open_book("open book", diffuse("open cover", (0.30, 0.07, 0.06)),
                       diffuse("printed page", image("printed page", printed_page(512))))
    piles = [table_pile(f"pile {k}", 60 + k, paper) for k in range(3)]
    bulbs, chairs = 0, 0
    for line, y in enumerate(TABLE_ROWS):
        for side, x in enumerate((-2.3, -4.95)):
            if (line, side) != (0, 0):
                again(table, f"table {2 * line + side + 1}", (x, y, 0))
            again(lamp, f"desk lamp {2 * line + side + 1}", (x, y, TABLE_TOP))
            if bulbs < 6:
                bulbs += 1
                point_light(f"bulb {bulbs}", (x, y, TABLE_TOP + 0.31), 0.03, DESK_WATTS, (1.0, 0.78, 0.5))
            for seat, (dx, turn) in enumerate(((-0.55, 180), (0.55, 180), (-0.55, 0), (0.55, 0))):
                if (line + side + seat) % 4 == 3:
                    continue
                out = random.choice((0.60, 0.66, 0.78)) * (1 if turn == 0 else -1)
                chairs += 1
                again(chair, f"chair {chairs}", (x + dx + random.uniform(-0.06, 0.06), y + out, 0),
                       turn + random.uniform(-14, 14))
                if random.random() < 0.5:
                    again(volume, f"open book {chairs}", (x + dx, y + 0.28 * (1 if turn == 0 else -1), TABLE_TOP),
                           turn + 180 + random.uniform(-12, 12))
            again(piles[(line + side) % 3], f"pile {3 + 2 * line + side}",
                   (x + random.choice((-0.95, 0.95)), y + random.uniform(-0.05, 0.05), TABLE_TOP),
                   random.uniform(0, 360))
    forget(chair, lamp, volume, *piles)


def plants():
    yucca = plant("yucca 1", "CC-BY", "yuccaPlant", (-3.63, 7.15, 0), ("Material.018", "Material.009"), scale=1.05)
    plant_again(yucca, "yucca 2", (-3.63, 13.35, 0), 130)
    plant_again(yucca, "yucca 3", (4.05, 10.25, 0), 70)
    broad = plant("aspidistra 1", "CC-BY", "mediumIndoorPlant", (LEFT + 0.24, 9.0, 0.80), ("Material",), scale=0.6,
                  colours={"Material.006": (0.62, 0.60, 0.55)})
    plant_again(broad, "aspidistra 2", (LEFT + 0.24, 11.9, 0.80), 150)
    palm = plant("palm 1", "CC-0", "plant", (-3.15, 19.05, 0), ("grass_shader_1",), scale=1.35,
                 colours={"pot": (0.30, 0.28, 0.26)})
    plant_again(palm, "palm 2", (1.9, 19.0, 0), 80)
    plant("peace lily", "CC-BY", "spatifilum", (3.7, 5.75, 0), ("Leaf",), turn=20, scale=1.15)


def back_wall_things():
    """A double door with a clock above it and a picture at each side."""
    middle = AISLE - LEFT
    leaf = Boxes()
    for sign in (-1, 1):
        a, b = sorted((middle + sign * 0.01, middle + sign * 0.92))
        leaf.wood((a + LEFT, BACK - 0.03, 0.005), (b + LEFT, BACK + 0.02, 2.25), 1.6)
        for z0, z1 in ((0.2, 0.95), (1.1, 2.1)):
            leaf.wood((a + LEFT + 0.14, BACK - 0.05, z0), (b + LEFT - 0.14, BACK - 0.029, z1), 1.6)
    for a, b, low, high in ((-1.04, -0.93, 0, 2.37), (0.93, 1.04, 0, 2.37), (-0.93, 0.93, 2.26, 2.37)):
        leaf.wood((AISLE + a, BACK - 0.06, low), (AISLE + b, BACK + 0.03, high), 1.6)
    leaf.made("door", [dark_oak])
    handle = [box("handle", (AISLE + x - 0.012, BACK - 0.10, 0.95), (AISLE + x + 0.012, BACK - 0.028, 1.2), brass)
              for x in (-0.07, 0.07)]
    join("door handles", handle)
    framed("picture left", BACK_WALL, middle - 2.0, middle - 1.35, 1.2, 2.05,
           diffuse("tree", image("tree", portrait_of_a_tree(480, 640))), dark_oak)
    framed("picture right", BACK_WALL, middle + 1.18, middle + 1.95, 1.3, 1.9,
           diffuse("painting", image("painting", painting(640, 480))), dark_oak)
    clock(BACK - 0.001, AISLE, 3.7, 0.42)


def clock(y, x, z, radius):
    """A round dial in a wooden rim, on the wall behind."""
    rim = turned_solid("rim", [(radius + 0.05, 0), (radius + 0.05, 0.05), (radius + 0.02, 0.07), (radius, 0.07),
                               (radius - 0.002, 0.045)], dark_oak, 64)
    dial = disk("dial", radius - 0.001, 0.05, diffuse("dial", image("dial", clock_face(512))))
    made = join("clock", [rim, dial])
    made.data.transform(Matrix.Rotation(math.pi / 2, 4, "X"))
    made.location = (x, y, z)


def things():
    """The carpet of the aisle, a globe and an armchair."""
    length = 17.0
    carpet = diffuse("carpet", image("carpet", runner(256, 1024)))
    strip = box("carpet", (AISLE - 0.5, 1.2, 0.0), (AISLE + 0.5, 1.2 + length, 0.008), carpet)
    for polygon in strip.data.polygons:
        for loop, vertex in zip(polygon.loop_indices, polygon.vertices):
            x, y, _ = strip.data.vertices[vertex].co
            strip.data.uv_layers.active.data[loop].uv = (x - AISLE + 0.5, (y - 1.2) / 4)
    globe("globe", (0.8, 5.7, 0), diffuse("map", image("map", earth(1024, 512))), dark_oak, brass)
    leather = dict.fromkeys(("Buttons", "Back", "Surround", "Sit"), (0.30, 0.09, 0.05))
    furniture("armchair", "CC-0", "winchesterArmchair", (2.3, 5.5, 0), turn=-32, colours=leather)


shell()
windows()
ceiling_lamps()
gallery()
shelves()
reading_tables()
plants()
back_wall_things()
things()
camera((1.5, 0.4, 2.25), (-1.2, 14, 1.0), 73)
save()
