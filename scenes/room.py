"""A living room: models of many authors (see README.md), two windows, a hanging lamp and a table lamp.

x to the right, y away from the camera, z up. The walls' inner faces are at x = LEFT, x = RIGHT, y = 0 and y = BACK.
"""
import math
import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from room_pictures import oak_floor, painting, rug, wood
from scene_tools import (add_mesh, area_light, box, camera, diffuse, emitter, extent, furniture, image, join,
                         point_light, quads, reset, save)

LEFT, RIGHT, BACK, HEIGHT, WALL = -2.9, 2.9, 4.8, 2.7, 0.25
SILL, LINTEL = 0.8, 2.3
DAYLIGHT = 150  # watts through one window
WINDOWS = ((0.9, 2.2), (2.9, 4.2))  # y from, y to

reset(700, 350, "Filmic")
white = diffuse("white paint", (0.78, 0.77, 0.74))
sage = diffuse("sage paint", (0.40, 0.47, 0.40))
trim = diffuse("trim", (0.82, 0.81, 0.78))
dark_wood = diffuse("dark wood", image("dark wood", wood(512, (0.42, 0.27, 0.17), 7)))
pale_wood = diffuse("pale wood", image("pale wood", wood(512, (0.78, 0.62, 0.44), 11)))


def shell():
    """Floor, ceiling, four walls (the left one with two openings) and skirting boards."""
    floor = diffuse("oak floor", image("oak floor", oak_floor(2048)))
    quads("floor", [((LEFT, 0, 0), (RIGHT, 0, 0), (RIGHT, BACK, 0), (LEFT, BACK, 0))], floor, tile=2.4)
    quads("ceiling", [((LEFT, 0, HEIGHT), (LEFT, BACK, HEIGHT), (RIGHT, BACK, HEIGHT), (RIGHT, 0, HEIGHT))], white)
    quads("wall back", [((LEFT, BACK, 0), (RIGHT, BACK, 0), (RIGHT, BACK, HEIGHT), (LEFT, BACK, HEIGHT))], sage)
    quads("wall front", [((RIGHT, 0, 0), (LEFT, 0, 0), (LEFT, 0, HEIGHT), (RIGHT, 0, HEIGHT))], white)
    quads("wall right", [((RIGHT, BACK, 0), (RIGHT, 0, 0), (RIGHT, 0, HEIGHT), (RIGHT, BACK, HEIGHT))], white)
    quads("wall left", [((LEFT, a, c), (LEFT, b, c), (LEFT, b, d), (LEFT, a, d)) for a, b, c, d in left_wall_pieces()],
          white)
    boards = [((LEFT, BACK - 0.015, 0), (RIGHT, BACK, 0.09)), ((LEFT, 0, 0), (LEFT + 0.015, BACK, 0.09)),
              ((RIGHT - 0.015, 0, 0), (RIGHT, BACK, 0.09))]
    join("skirting", [box("board", low, high, trim) for low, high in boards])


def left_wall_pieces():
    """The left wall around its windows: (y from, y to, z from, z to)."""
    (a, b), (c, d) = WINDOWS
    columns = [(y0, y1, 0, HEIGHT) for y0, y1 in ((0, a), (b, c), (d, BACK))]
    return columns + [piece for y0, y1 in WINDOWS for piece in ((y0, y1, 0, SILL), (y0, y1, LINTEL, HEIGHT))]


def window(number, y0, y1):
    """Reveal, frame with a cross bar, sill, two curtains, and daylight through the opening."""
    out = LEFT - WALL
    quads(f"reveal {number}", [
        ((out, y0, SILL), (out, y1, SILL), (LEFT, y1, SILL), (LEFT, y0, SILL))[::-1],
        ((out, y0, LINTEL), (out, y1, LINTEL), (LEFT, y1, LINTEL), (LEFT, y0, LINTEL)),
        ((out, y0, SILL), (LEFT, y0, SILL), (LEFT, y0, LINTEL), (out, y0, LINTEL))[::-1],
        ((out, y1, SILL), (LEFT, y1, SILL), (LEFT, y1, LINTEL), (out, y1, LINTEL))], white)
    middle, near, far = (y0 + y1) / 2, LEFT - 0.14, LEFT - 0.08
    bars = [((near, y0, SILL), (far, y1, SILL + 0.06)), ((near, y0, LINTEL - 0.06), (far, y1, LINTEL)),
            ((near, y0, SILL + 0.06), (far, y0 + 0.06, LINTEL - 0.06)),
            ((near, y1 - 0.06, SILL + 0.06), (far, y1, LINTEL - 0.06)),
            ((near, middle - 0.035, SILL + 0.06), (far, middle + 0.035, LINTEL - 0.06))]
    join(f"window frame {number}", [box("bar", low, high, dark_wood) for low, high in bars])
    box(f"sill {number}", (LEFT - 0.08, y0 - 0.05, SILL - 0.03), (LEFT + 0.10, y1 + 0.05, SILL + 0.004), pale_wood)
    linen = diffuse(f"linen {number}", (0.66, 0.60, 0.48))
    join(f"curtains {number}", [curtain(y0 - 0.28, y0 + 0.07, linen), curtain(y1 - 0.07, y1 + 0.28, linen)])
    box(f"curtain rod {number}", (LEFT + 0.10, y0 - 0.35, 2.47), (LEFT + 0.125, y1 + 0.35, 2.495), dark_wood)
    area_light(f"daylight {number}", (out + 0.02, middle, (SILL + LINTEL) / 2), (1, 0, 0), LINTEL - SILL, y1 - y0,
               DAYLIGHT, (0.86, 0.93, 1.0))
    quads(f"sky {number}", [((out, y0, SILL), (out, y1, SILL), (out, y1, LINTEL), (out, y0, LINTEL))],
          emitter(f"sky {number}", (1.9, 2.3, 2.7)))


def curtain(y0, y1, material):
    """A pleated sheet from the rod to just above the floor."""
    columns, rows = 96, 12
    vertices = []
    for row in range(rows + 1):
        height = 0.03 + (2.49 - 0.03) * row / rows
        for column in range(columns + 1):
            along = column / columns
            depth = 0.035 * math.sin(along * 9 * math.tau / 1.5) * (1 - 0.35 * row / rows)
            vertices.append((LEFT + 0.11 + depth, y0 + (y1 - y0) * along, height))
    faces = [(i, i + 1, i + columns + 2, i + columns + 1) for row in range(rows)
             for i in range(row * (columns + 1), row * (columns + 1) + columns)]
    sheet = add_mesh("curtain", vertices, faces, material)
    sheet.data.polygons.foreach_set("use_smooth", [True] * len(sheet.data.polygons))
    return sheet


def bookcase(x0, x1, depth, height):
    """Shelves against the back wall, filled with books of many colours."""
    random.seed(5)
    back, front = BACK - 0.02, BACK - 0.02 - depth
    levels = [0.08 + i * (height - 0.12) / 5 for i in range(6)]
    parts = [((x0, front, 0), (x0 + 0.025, back, height)), ((x1 - 0.025, front, 0), (x1, back, height)),
             ((x0 + 0.025, back - 0.01, 0.08), (x1 - 0.025, back, height))]
    parts += [((x0 + 0.025, front + 0.004, z), (x1 - 0.025, back - 0.01, z + 0.025)) for z in levels]
    join("bookcase", [box("shelf", low, high, pale_wood, tile=1.1) for low, high in parts])
    covers = [diffuse(f"cover {i}", c) for i, c in enumerate((
        (0.42, 0.06, 0.05), (0.05, 0.10, 0.26), (0.07, 0.22, 0.12), (0.60, 0.48, 0.26), (0.72, 0.68, 0.58),
        (0.10, 0.08, 0.07), (0.50, 0.22, 0.06), (0.20, 0.33, 0.42), (0.32, 0.14, 0.24)))]
    books = []
    for z in levels[:-1]:
        x = x0 + 0.04
        while x < x1 - 0.10:
            thick, tall, deep = random.uniform(0.016, 0.05), random.uniform(0.19, 0.29), random.uniform(0.14, 0.21)
            books.append(box("book", (x, front + 0.04, z + 0.0255), (x + thick, front + 0.04 + deep, z + tall),
                             random.choice(covers)))
            x += thick + (0.0015 if random.random() > 0.06 else random.uniform(0.06, 0.2))
    join("books", books)


def framed(name, x0, x1, z0, z1, material):
    """A painting on the back wall."""
    y, edge = BACK - 0.03, 0.03
    picture = quads("canvas", [((x0, y, z0), (x1, y, z0), (x1, y, z1), (x0, y, z1))], material)
    for loop, uv in zip(picture.data.uv_layers.active.data, ((0, 0), (1, 0), (1, 1), (0, 1))):
        loop.uv = uv
    sides = [((x0 - edge, z0 - edge), (x1 + edge, z0)), ((x0 - edge, z1), (x1 + edge, z1 + edge)),
             ((x0 - edge, z0), (x0, z1)), ((x1, z0), (x1 + edge, z1))]
    frame = [box("frame", (a, y - 0.015, b), (c, BACK - 0.001, d), dark_wood) for (a, b), (c, d) in sides]
    join(name, [picture, *frame])


def coffee_table(x, y):
    """A low table with two tops; returns its height."""
    top = 0.43
    parts = [box("top", (x - 0.6, y - 0.33, top - 0.035), (x + 0.6, y + 0.33, top), dark_wood, tile=0.9),
             box("tray", (x - 0.52, y - 0.26, 0.15), (x + 0.52, y + 0.26, 0.17), dark_wood, tile=0.9)]
    parts += [box("leg", (x + leg_x - 0.025, y + leg_y - 0.025, 0.012),
                  (x + leg_x + 0.025, y + leg_y + 0.025, top - 0.035), dark_wood)
              for leg_x in (-0.55, 0.55) for leg_y in (-0.28, 0.28)]
    join("coffee table", parts)
    return top


def seats():
    leather = dict.fromkeys(("Buttons", "Back", "Surround", "Sit"), (0.33, 0.075, 0.045))
    furniture("sofa", "CC-0", "winchesterSofa", (-0.52, 4.20, 0), colours=leather)
    furniture("armchair", "CC-0", "armchair2", (-1.95, 2.35, 0), turn=62, colours={"None": (0.66, 0.62, 0.54)})
    furniture("chair", "CC-0", "oakChair", (1.45, 3.15, 0), turn=-62)


def plants():
    furniture("peace lily", "CC-BY", "spatifilum", (-2.22, 4.22, 0), scale=1.25, turn=20)
    furniture("olive tree", "CC-0", "decorativePlant", (2.47, 4.38, 0), scale=1.2)
    furniture("succulent", "CC-BY", "succulentPlant", (LEFT, 3.25, SILL + 0.004), turn=40)


def table_things(x, y, top):
    furniture("chessboard", "CC-BY", "chessboard", (x - 0.34, y + 0.02, top), turn=12)
    furniture("open book", "CC-BY", "book", (x + 0.38, y - 0.08, top), turn=-18)
    furniture("tulips", "CC-BY", "tulip", (x + 0.06, y + 0.10, top), turn=30)


def dresser():
    top, x = 0.81, RIGHT - 0.29
    furniture("dresser", "CC-BY", "dresserWithDrawers", (x, 3.15, 0), turn=-90)
    furniture("table lamp", "CC-BY", "lamp", (x, 3.70, top), scale=1.15, turn=-90,
              colours={"Shade": (0.10, 0.17, 0.16)})
    point_light("bulb", (x, 3.70, top + 0.37), 0.04, 14, (1.0, 0.78, 0.52))
    furniture("radio", "CC-BY", "radio", (x + 0.06, 3.25, top), turn=-70)
    furniture("teddy bear", "CC-0", "teddyBear", (x, 2.85, top), turn=-60)


def hanging_lamp(x, y):
    """A lamp over the coffee table; a disk fills the mouth of its shade."""
    lamp = furniture("hanging lamp", "CC-BY", "hangingLight", (x, y, 0), without=("Main-Bulb",))
    lamp.location.z = HEIGHT - extent(lamp)[1][2]
    area_light("hanging light", (x, y, lamp.location.z + 0.005), (0, 0, -1), 0.3, 0.3, 32, (1.0, 0.82, 0.6), "DISK")


shell()
for index, (start, end) in enumerate(WINDOWS):
    window(index + 1, start, end)
bookcase(0.75, 2.05, 0.30, 2.05)
framed("large picture", -0.95, 0.25, 1.35, 2.10, diffuse("painting", image("painting", painting(1024, 640))))
box("rug", (-1.35, 1.65, 0), (0.675, 3.675, 0.012), diffuse("rug", image("rug", rug(1024))), tile=0.675)
table_top = coffee_table(-0.6, 2.75)
seats()
plants()
table_things(-0.6, 2.75, table_top)
dresser()
hanging_lamp(-0.6, 2.75)
camera((0.75, 0.12, 1.45), (0.2, 4.6, 1.15), 84)
save()
