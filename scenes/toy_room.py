"""A children's room full of toys and of plants with thousands of leaves (models: see README.md), by day with lamps on.

x to the right, y away from the camera, z up. The walls' inner faces are at x = LEFT, x = RIGHT, y = 0 and y = BACK.
"""
import sys
from functools import partial
from pathlib import Path

import bpy

sys.path.insert(0, str(Path(__file__).parent))
from interior import Opening, Wall, curtain, framed, pierced, reveal, window_board, window_frame
from repeated import again, plant
from scene_pictures import wood
from scene_tools import area_light, box, camera, diffuse, emitter, extent, furniture, image, join, quads, reset, save
from toy_room_furniture import cubbies, round_slab, round_table, wall_shelf
from toy_room_parts import blocks, bunting, standing_books
from toy_room_pictures import carpet, child_drawing, parquet

LEFT, RIGHT, BACK, HEIGHT, WALL = -2.5, 2.5, 5.2, 2.6, 0.25
WINDOW = Opening(2.35, 3.55, 0.85, 2.20)
DAYLIGHT, CEILING_LAMP, WALL_LAMP = 180, 33, 100  # watts
LEFT_WALL, BACK_WALL = Wall((LEFT, 0), (1, 0)), Wall((LEFT, BACK), (0, -1))
TABLE, TABLE_TOP = (0.30, 3.35), 0.52

reset(700, 350, "Filmic")
potted = partial(plant, by_pot=True)
white = diffuse("white paint", (0.78, 0.77, 0.74))
blue = diffuse("pale blue paint", (0.34, 0.46, 0.52))
cream = diffuse("cream paint", (0.62, 0.53, 0.38))
trim = diffuse("trim", (0.82, 0.81, 0.78))
metal = diffuse("grey metal", (0.42, 0.42, 0.43))
pale_wood = diffuse("pale wood", image("pale wood", wood(512, (0.80, 0.64, 0.45), 11)))
honey_wood = diffuse("honey wood", image("honey wood", wood(512, (0.70, 0.50, 0.30), 17)))
paints = [diffuse(f"toy paint {i}", colour) for i, colour in enumerate(
    ((0.62, 0.07, 0.05), (0.75, 0.52, 0.07), (0.06, 0.20, 0.48), (0.12, 0.36, 0.12), (0.72, 0.66, 0.54)))]


def shell():
    """Floor, ceiling, four walls (the left one with an opening) and skirting boards."""
    floor = diffuse("parquet", image("parquet", parquet(2048)))
    quads("floor", [((LEFT, 0, 0), (RIGHT, 0, 0), (RIGHT, BACK, 0), (LEFT, BACK, 0))], floor, tile=1.6)
    quads("ceiling", [((LEFT, 0, HEIGHT), (LEFT, BACK, HEIGHT), (RIGHT, BACK, HEIGHT), (RIGHT, 0, HEIGHT))], white)
    quads("wall back", [((LEFT, BACK, 0), (RIGHT, BACK, 0), (RIGHT, BACK, HEIGHT), (LEFT, BACK, HEIGHT))], blue)
    quads("wall right", [((RIGHT, BACK, 0), (RIGHT, 0, 0), (RIGHT, 0, HEIGHT), (RIGHT, BACK, HEIGHT))], cream)
    pierced("wall left", LEFT_WALL, BACK, HEIGHT, [WINDOW], cream)
    quads("wall front", [((RIGHT, 0, 0), (LEFT, 0, 0), (LEFT, 0, HEIGHT), (RIGHT, 0, HEIGHT))], white)
    boards = [((LEFT, BACK - 0.014, 0), (RIGHT, BACK, 0.08)), ((LEFT, 0, 0), (LEFT + 0.014, BACK, 0.08)),
              ((RIGHT - 0.014, 0, 0), (RIGHT, BACK, 0.08))]
    join("skirting", [box("board", low, high, trim) for low, high in boards])


def window():
    """Reveal, frame, sill, curtains, daylight through the opening and the sky behind it."""
    a, b, low, high, out = WINDOW.start, WINDOW.end, WINDOW.low, WINDOW.high, LEFT - WALL
    reveal("reveal", LEFT_WALL, WINDOW, WALL, white)
    window_frame("window frame", LEFT_WALL, WINDOW, 0.14, trim)
    window_board("sill", LEFT_WALL, WINDOW, pale_wood)
    linen = diffuse("linen", (0.55, 0.20, 0.12))
    join("curtains", [curtain(LEFT_WALL, a - 0.30, a + 0.05, 2.41, linen),
                      curtain(LEFT_WALL, b - 0.05, b + 0.30, 2.41, linen)])
    box("curtain rod", (LEFT + 0.10, a - 0.4, 2.41), (LEFT + 0.125, b + 0.4, 2.435), honey_wood)
    area_light("daylight", (out + 0.02, (a + b) / 2, (low + high) / 2), (1, 0, 0), b - a, high - low, DAYLIGHT,
               (0.86, 0.93, 1.0))
    quads("sky", [((out, a, low), (out, b, low), (out, b, high), (out, a, high))], emitter("sky", (1.9, 2.3, 2.7)))


def lamps():
    """Two disks: under the ceiling, and on the wall behind the camera, which throws plants' shadows on the walls."""
    x, y = -0.45, 2.8
    round_slab("ceiling lamp", (x, y), 0.17, HEIGHT - 0.06, HEIGHT - 0.001, trim)
    area_light("ceiling light", (x, y, HEIGHT - 0.064), (0, 0, -1), 0.30, 0.30, CEILING_LAMP, (1.0, 0.86, 0.68), "DISK")
    x, z = -1.70, 1.90
    box("wall lamp", (x - 0.16, 0.001, z - 0.16), (x + 0.16, 0.08, z + 0.16), metal)
    area_light("wall light", (x, 0.084, z), (0, 1, -0.05), 0.24, 0.24, WALL_LAMP, (1.0, 0.82, 0.60), "DISK")


def big_plants():
    """The palm and the yucca stand opposite the window, so that their shadows spread over the right wall."""
    made = potted("indoor plant", "CC-BY", "mediumIndoorPlant", (-1.34, 2.10, 0.42), ("Material",), scale=1.5, turn=30,
                 colours={"Material.006": (0.16, 0.24, 0.27)})
    round_slab("plant stool", (-1.34, 2.10), 0.26, 0, 0.42, honey_wood, tile=0.8)
    for part in made:
        again(part, part.name.replace("plant", "plant 2"), (1.52, 2.0, 0.22), turn=-75)
    round_slab("low plant stool", (1.52, 2.0), 0.27, 0, 0.22, honey_wood, tile=0.8)
    potted("palm", "CC-0", "plant", (1.82, 3.22, 0), ("grass_shader_1",), scale=1.45, turn=20,
          colours={"pot": (0.50, 0.25, 0.16), "grass_shader_1": (0.12, 0.27, 0.06)})
    potted("schefflera", "CC-BY", "decorativePlant", (-2.12, 4.78, 0), ("Leaf",), scale=2.0)
    potted("yucca", "CC-BY", "yuccaPlant", (1.92, 4.22, 0), ("Material.009", "Material.018"), turn=50)


def play_table():
    x, y = TABLE
    round_table("table", TABLE, 0.56, 0, TABLE_TOP, pale_wood, trim)
    furniture("xylophone", "CC-BY", "xylophone", (x - 0.12, y - 0.20, TABLE_TOP), turn=15)
    furniture("toy train", "CC-BY", "toyTrain", (x + 0.10, y + 0.25, TABLE_TOP), turn=-20, scale=1.3)
    furniture("rubix cube", "CC-BY", "rubix2", (x + 0.34, y - 0.02, TABLE_TOP), turn=25, scale=1.2)
    toy = furniture("wood toy", "CC-0", "woodToy", (x - 0.36, y + 0.14, TABLE_TOP), turn=20, scale=1.3)
    again(toy, "wood toy 2", (x - 0.24, y + 0.30, TABLE_TOP), turn=-25)
    chair = furniture("child chair", "CC-BY", "childChair", (x - 0.72, y + 0.28, 0), turn=75,
                      colours={"Child_chair": (0.55, 0.06, 0.04)})
    again(chair, "child chair 2", (x + 0.78, y + 0.10, 0), turn=-80)


def shelf_unit():
    """Compartments with boxes and toys; more toys and a plant on top."""
    x0, x1, deep, top = -1.55, 0.75, 0.40, 1.0
    lower, upper = cubbies("shelf unit", (x0, BACK - deep, 0), (x1, BACK - 0.002, top), 4, 2, white, honey_wood)
    y = BACK - 0.19
    bin_of = furniture("toy bin", "CC-0", "box", (lower[0][0], y, lower[0][1]), scale=0.48)
    again(bin_of, "toy bin 2", (lower[2][0], y, lower[2][1]))
    again(bin_of, "toy bin 3", (upper[3][0], y, upper[3][1]))
    furniture("soccer ball", "CC-BY", "ballonFoot", (lower[1][0], y, lower[1][1]))
    furniture("wooden car", "CC-BY", "carrito-de-madera", (upper[0][0], y, upper[0][1]), turn=70, scale=1.2)
    furniture("toy boat", "CC-BY", "rowboat", (upper[2][0], y, upper[2][1]), turn=70, scale=0.13)
    standing_books("picture books", (upper[1][0] - 0.24, y + 0.10, upper[1][1]), 0.46, paints, 9)
    furniture("toy horse", "CC-BY", "horse", (lower[3][0], y, lower[3][1]), turn=60, scale=0.15)
    furniture("teddy bear", "CC-0", "teddyBear", (-1.22, y, top), turn=12, scale=1.1)
    potted("spider plant", "CC-BY", "spider_plant", (-0.52, BACK - 0.26, top), ("leaf",), scale=0.9, turn=90,
          colours={"glass": (0.70, 0.66, 0.58)})
    potted("orchids", "CC-0", "orchids", (0.10, y - 0.02, top), ("Flower", "Leaf", "Stalk", "Stem"), turn=30, scale=0.9)
    furniture("gift", "CC-BY", "gift", (0.50, y, top), turn=20, scale=1.1)


def high_shelf():
    low, high = (-1.75, BACK - 0.30, 1.60), (-0.08, BACK - 0.001, 1.625)
    wall_shelf("wall shelf", low, high, honey_wood, trim)
    y, top = BACK - 0.16, high[2]
    furniture("deer", "CC-0", "deer", (-1.40, y, top), turn=60, scale=1.9, colours={"Material": (0.46, 0.30, 0.17)})
    potted("bamboo", "CC-BY", "luckyBamboo", (-1.02, y, top), ("bamboo",), colours={"Flints": (0.5, 0.48, 0.45)})
    toy = bpy.data.objects["wood toy"]
    for number, x in ((3, -0.80), (4, -0.67)):
        again(toy, f"wood toy {number}", (x, y - 0.02, top), turn=100 * number)
    potted("pothos", "CC-0", "augalas", (-0.36, y - 0.015, top), ("Leaf", "Stem"), turn=0)


def chest():
    x, y = 1.72, BACK - 0.285
    drawers = furniture("chest", "CC-BY", "chest", (x, y, 0))
    top = extent(drawers)[1][2]
    again(bpy.data.objects["gift"], "gift 2", (x + 0.28, y - 0.02, top), turn=-30)
    again(bpy.data.objects["teddy bear"], "teddy bear 2", (x - 0.42, y, top), turn=15)
    furniture("red gift", "CC-BY", "gift", (1.62, 4.02, 0), turn=20, scale=0.9,
              colours={"gift5": (0.70, 0.55, 0.15), "Material": (0.55, 0.06, 0.06),
                       "Material.003": (0.55, 0.06, 0.06)})


def floor_toys():
    furniture("rocking horse", "CC-0", "caballito", (-1.20, 3.75, 0.012), turn=-25, scale=1.3)
    again(bpy.data.objects["toy train"], "toy train 2", (-0.98, 3.22, 0.012), turn=24)
    box("carpet", (-2.25, 3.05, 0), (-0.65, 4.25, 0.012),
        diffuse("carpet", image("carpet", carpet(1024, 768))))
    places = [(0.98, 3.05), (1.10, 3.16), (1.03, 3.29), (1.30, 3.30), (0.85, 2.90), (1.24, 2.98)]
    blocks("blocks", [(x, y, 0) for x, y in places] + [(1.085, 3.145, 0.07)], 0.07, paints, 3)
    furniture("basketball", "CC-0", "basketball", (1.22, 3.98, 0), turn=35)
    furniture("puzzle", "CC-0", "housePuzzle", (0.42, 2.72, 0), turn=-35, scale=1.3)
    furniture("toy motorbike", "CC-0", "motorbike", (-0.25, 2.75, 0), scale=0.3, turn=30)


def flying():
    """A biplane on a thread."""
    x, y, z = 1.18, 4.10, 1.72
    biplane = furniture("biplane", "CC-0", "cartoon_biplane", (x, y, z), turn=-40, scale=4,
                        colours={"Wing": (0.62, 0.09, 0.06), "PlaneBody": (0.08, 0.22, 0.45)})
    top = z + extent(biplane)[1][2]
    box("thread", (x - 0.002, y - 0.002, top - 0.03), (x + 0.002, y + 0.002, HEIGHT - 0.001), metal)


def decoration():
    paper = diffuse("drawing", image("drawing", child_drawing(600, 440, (0.75, 0.22, 0.15), 3)))
    framed("drawing", BACK_WALL, 0.34 - LEFT, 0.94 - LEFT, 1.35, 1.79, paper, honey_wood)
    bunting("bunting", (-2.3, BACK - 0.05, 2.42), (2.3, BACK - 0.05, 2.42), 0.2, paints, trim)


shell()
window()
lamps()
big_plants()
play_table()
shelf_unit()
high_shelf()
chest()
floor_toys()
flying()
decoration()
camera((0.12, 0.10, 1.55), (0.05, 4.6, 0.90), 82)
save()
