"""A living room: models of many authors (see README.md), two windows, a hanging lamp and a table lamp.

x to the right, y away from the camera, z up. The walls' inner faces are at x = LEFT, x = RIGHT, y = 0 and y = BACK.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from interior import (
    Opening,
    Wall,
    bookcase,
    books,
    covers,
    curtain,
    framed,
    pierced,
    reveal,
    window_board,
    window_frame,
)
from scene_pictures import oak_floor, painting, rug, wood
from scene_tools import (
    area_light,
    box,
    camera,
    diffuse,
    emitter,
    extent,
    furniture,
    image,
    join,
    point_light,
    quads,
    reset,
    save,
)

LEFT, RIGHT, BACK, HEIGHT, WALL = -2.9, 2.9, 4.8, 2.7, 0.25
SILL, LINTEL = 0.8, 2.3
DAYLIGHT = 150  # watts through one window
WINDOWS = [Opening(0.9, 2.2, SILL, LINTEL), Opening(2.9, 4.2, SILL, LINTEL)]
LEFT_WALL, BACK_WALL = Wall((LEFT, 0), (1, 0)), Wall((LEFT, BACK), (0, -1))

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
    pierced("wall left", LEFT_WALL, BACK, HEIGHT, WINDOWS, white)
    boards = [((LEFT, BACK - 0.015, 0), (RIGHT, BACK, 0.09)), ((LEFT, 0, 0), (LEFT + 0.015, BACK, 0.09)),
              ((RIGHT - 0.015, 0, 0), (RIGHT, BACK, 0.09))]
    join("skirting", [box("board", low, high, trim) for low, high in boards])


def window(number, opening):
    """Reveal, frame with a cross bar, sill, two curtains, and daylight through the opening."""
    reveal(f"reveal {number}", LEFT_WALL, opening, WALL, white)
    window_frame(f"window frame {number}", LEFT_WALL, opening, 0.14, dark_wood)
    window_board(f"sill {number}", LEFT_WALL, opening, pale_wood)
    y0, y1, out = opening.start, opening.end, LEFT - WALL
    linen = diffuse(f"linen {number}", (0.66, 0.60, 0.48))
    join(f"curtains {number}", [curtain(LEFT_WALL, y0 - 0.28, y0 + 0.07, 2.49, linen),
                                curtain(LEFT_WALL, y1 - 0.07, y1 + 0.28, 2.49, linen)])
    box(f"curtain rod {number}", (LEFT + 0.10, y0 - 0.35, 2.47), (LEFT + 0.125, y1 + 0.35, 2.495), dark_wood)
    area_light(f"daylight {number}", (out + 0.02, (y0 + y1) / 2, (SILL + LINTEL) / 2), (1, 0, 0), y1 - y0,
               LINTEL - SILL, DAYLIGHT, (0.86, 0.93, 1.0))
    quads(f"sky {number}", [((out, y0, SILL), (out, y1, SILL), (out, y1, LINTEL), (out, y0, LINTEL))],
          emitter(f"sky {number}", (1.9, 2.3, 2.7)))


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
for index, opening in enumerate(WINDOWS):
    window(index + 1, opening)
CASE = (0.75 - LEFT, 2.05 - LEFT, 0.30, 2.05)  # start and end along the wall, depth, height
bookcase("bookcase", BACK_WALL, *CASE, pale_wood)
books("books", BACK_WALL, *CASE, covers(), seed=5)
framed("large picture", BACK_WALL, -0.95 - LEFT, 0.25 - LEFT, 1.35, 2.10,
       diffuse("painting", image("painting", painting(1024, 640))), dark_wood)
box("rug", (-1.35, 1.65, 0), (0.675, 3.675, 0.012), diffuse("rug", image("rug", rug(1024))), tile=0.675)
table_top = coffee_table(-0.6, 2.75)
seats()
plants()
table_things(-0.6, 2.75, table_top)
dresser()
hanging_lamp(-0.6, 2.75)
camera((0.75, 0.12, 1.45), (0.2, 4.6, 1.15), 84)
save()
