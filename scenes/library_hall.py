"""The library's hall: floor, walls, windows, ceiling lamps, gallery. Importing it begins the scene.

The walls' inner faces are at x = LEFT, x = RIGHT, y = 0 and y = BACK.
"""
from interior import Opening, Wall, pierced, reveal, window_board, window_frame
from library_books import Boxes
from library_parts import column
from library_pictures import stone_floor
from repeated import again
from scene_pictures import wood
from scene_tools import area_light, box, diffuse, emitter, image, join, quads, reset

LEFT, RIGHT, BACK, HEIGHT, WALL = -7.6, 7.0, 20.0, 5.2, 0.35
GALLERY, EDGE, SLAB = 2.85, 4.5, 0.25  # height of its floor, where it ends, thickness
SIDE_DAYLIGHT, BACK_DAYLIGHT, CEILING_WATTS = 200, 80, 5  # one window, one window, one lamp
SKY, LAMP_GLOW = (2.2, 2.6, 3.0), (2.6, 2.3, 1.9)
SIDE_WINDOWS = [Opening(y + 0.28, y + 1.72, 1.05, 4.45) for y in range(0, 20, 2)]
BACK_WINDOWS = [Opening(u, u + 1.6, 2.95, 4.55) for u in (0.9, 3.5, 7.5, 10.1)]
LEFT_WALL, BACK_WALL = Wall((LEFT, 0), (1, 0)), Wall((LEFT, BACK), (0, -1))
BEAMS = (4, 8, 12, 16)

reset(630, 350, "Filmic")
plaster = diffuse("plaster", (0.76, 0.73, 0.66))
white = diffuse("white paint", (0.80, 0.79, 0.76))
green = diffuse("green plaster", (0.40, 0.46, 0.38))
iron = diffuse("iron", (0.055, 0.06, 0.065))
oak = diffuse("oak", image("oak", wood(512, (0.60, 0.42, 0.26), 7)))
dark_oak = diffuse("dark oak", image("dark oak", wood(512, (0.42, 0.27, 0.17), 11)))
sky = emitter("sky", SKY)
shared_light = {}


def shell():
    """Floor, ceiling, four walls, two of them with windows."""
    floor = diffuse("stone floor", image("stone floor", stone_floor(2048)))
    quads("floor", [((LEFT, 0, 0), (RIGHT, 0, 0), (RIGHT, BACK, 0), (LEFT, BACK, 0))], floor, tile=5.6)
    quads("ceiling", [((LEFT, 0, HEIGHT), (LEFT, BACK, HEIGHT), (RIGHT, BACK, HEIGHT), (RIGHT, 0, HEIGHT))], white)
    quads("wall front", [((RIGHT, 0, 0), (LEFT, 0, 0), (LEFT, 0, HEIGHT), (RIGHT, 0, HEIGHT))], plaster)
    quads("wall right", [((RIGHT, BACK, 0), (RIGHT, 0, 0), (RIGHT, 0, HEIGHT), (RIGHT, BACK, HEIGHT))], plaster)
    pierced("wall left", LEFT_WALL, BACK, HEIGHT, SIDE_WINDOWS, plaster)
    pierced("wall back", BACK_WALL, RIGHT - LEFT, HEIGHT, BACK_WINDOWS, green)
    beams = [box("beam", (LEFT - 0.05, y - 0.16, HEIGHT - 0.34), (RIGHT + 0.05, y + 0.16, HEIGHT + 0.05), white)
             for y in BEAMS]
    join("beams", beams)


def window(name, wall, opening, inward, light):
    """Reveal, frame with bars, sill, and daylight through the opening."""
    a, b, low, high = opening.start, opening.end, opening.low, opening.high
    reveal(f"reveal {name}", wall, opening, WALL, white)
    frame = window_frame(f"window frame {name}", wall, opening, 0.22, white)
    rails = [wall.box("rail", (a + 0.055, -0.212, z), (b - 0.055, -0.168, z + 0.045), white)
             for z in (low + (high - low) * k / 4 for k in ((1, 2, 3) if high - low > 2 else (2,)))]
    join(f"window frame {name}", [frame, *rails])
    window_board(f"sill {name}", wall, opening, oak)
    wall.quads(f"sky {name}", [((a, -WALL, low), (b, -WALL, low), (b, -WALL, high), (a, -WALL, high))], sky)
    middle = wall.at((a + b) / 2, 0.02 - WALL, (low + high) / 2)
    watts = SIDE_DAYLIGHT if light == "side daylight" else BACK_DAYLIGHT
    lamps(light, f"daylight {name}", middle, (*inward, 0), b - a, high - low, watts, (0.86, 0.93, 1.0))


def lamps(kind, name, location, direction, width, height, watts, colour):
    """An area light; all of one kind share their data."""
    light = area_light(name, location, direction, width, height, watts, colour)
    light.data = shared_light.setdefault(kind, light.data)


def windows():
    for number, opening in enumerate(SIDE_WINDOWS, 1):
        window(f"side {number}", LEFT_WALL, opening, (1, 0), "side daylight")
    for number, opening in enumerate(BACK_WINDOWS, 1):
        window(f"back {number}", BACK_WALL, opening, (0, -1), "back daylight")


def ceiling_lamps():
    """Square lamps: fifty on the ceiling, ten below the gallery."""
    places = [(x, y, HEIGHT) for x in (-6.2, -3.7, -1.2, 1.3, 3.8) for y in range(1, 20, 2)]
    places += [((EDGE + RIGHT) / 2, y, GALLERY - SLAB) for y in range(1, 20, 2)]
    cases, panes, half, rim = Boxes(), [], 0.30, 0.33
    for number, (x, y, z) in enumerate(places, 1):
        cases.add((x - rim + 0.004, y - rim + 0.004, z - 0.05), (x + rim - 0.004, y + rim - 0.004, z + 0.01), plain)
        for a, b, c, d in ((-rim, -rim, rim, -half), (-rim, half, rim, rim), (-rim, -half, -half, half),
                           (half, -half, rim, half)):
            cases.add((x + a, y + b, z - 0.08), (x + c, y + d, z - 0.045), plain)
        panes.append(tuple((x + a * half, y + b * half, z - 0.06) for a, b in ((-1, -1), (-1, 1), (1, 1), (1, -1))))
        lamps("ceiling", f"ceiling light {number}", (x, y, z - 0.065), (0, 0, -1), 2 * half, 2 * half, CEILING_WATTS,
              (1.0, 0.88, 0.72))
    cases.made("lamp cases", [white])
    quads("lamp panes", panes, emitter("lamp glow", LAMP_GLOW))


def gallery():
    """A slab along the right wall with an oak edge, columns through both storeys and a railing."""
    box("gallery", (EDGE + 0.03, -0.05, GALLERY - SLAB), (RIGHT + 0.05, BACK + 0.05, GALLERY), white)
    box("gallery edge", (EDGE - 0.03, -0.05, GALLERY - SLAB - 0.03), (EDGE + 0.032, BACK + 0.05, GALLERY + 0.06), oak,
        tile=2.4)
    lower = column("column 1", 0.19, GALLERY - SLAB + 0.002, plaster)
    upper = column("upper column 1", 0.15, HEIGHT - 0.34 - GALLERY + 0.002, plaster)
    lower.location, upper.location = (EDGE + 0.36, BEAMS[0], 0), (EDGE + 0.36, BEAMS[0], GALLERY)
    for number, y in enumerate(BEAMS[1:], 2):
        again(lower, f"column {number}", (EDGE + 0.36, y, 0))
        again(upper, f"upper column {number}", (EDGE + 0.36, y, GALLERY))
    bars, foot, top = Boxes(), GALLERY + 0.05, GALLERY + 0.98
    for k in range(1, 167):
        y, half = k * 0.12, 0.02 if k % 10 == 0 else 0.007
        bars.add((EDGE - half, y - half, foot), (EDGE + half, y + half, top + 0.01), plain)
    for z in (GALLERY + 0.15, top - 0.12):
        bars.add((EDGE - 0.01, -0.02, z), (EDGE + 0.01, BACK + 0.02, z + 0.02), plain)
    bars.made("railing", [iron])
    box("handrail", (EDGE - 0.04, -0.02, top), (EDGE + 0.04, BACK + 0.02, top + 0.05), dark_oak)


def plain(face, corners):
    """How Boxes paints what has one colour."""
    return 0, [(0, 0)] * 4
