"""An attic under a pitched roof: sun and sky come in through a skylight and a gable window, and from nowhere else.

Walls and roof are closed boards 3 to 4 cm thick that reach into one another, so that no light may leak through; a thin
partition shuts off a dark store-room. x to the right, y away from the camera, z up; the ridge runs along y over x = 0.
The inner faces are at x = -HALF, x = HALF, y = 0, y = LENGTH and, of the roof, z = RIDGE - |x|.
"""
import math
import sys
from pathlib import Path

import bpy
from mathutils import Vector

sys.path.insert(0, str(Path(__file__).parent))
from attic_parts import (
    beam,
    carton,
    frame_of_beams,
    grid_slab,
    laid,
    pile_of_books,
    slab,
    solid,
    table,
    trunk,
    turned,
    whole_image,
)
from attic_pictures import boards, cardboard, leather, old_rug
from interior import Wall, covers, framed
from repeated import again, plant
from scene_pictures import painting, wood
from scene_tools import box, camera, diffuse, extent, furniture, image, join, place_light, reset, save

HALF, LENGTH, KNEE, RIDGE = 2.8, 6.6, 1.0, 3.8
THIN, ROOF, PARTITION = 0.03, 0.04, 0.025  # thickness of walls, roof, divider
INTO = 0.015  # how far boards reach into one another
SKYLIGHT = (2.74, 3.66, 0.8, 2.1)  # start and end along y, start and end up the slope from the knee
WINDOW = (-1.7, -0.4, 0.95, 2.02)  # start and end along x, low and high
DOOR = (0.0, 0.72, 2.0)  # start and end along x, height
STORE_X, STORE_Y = -0.1, 4.5  # the store-room lies right of and behind these
RAFTERS = [0.60 + 1.04 * i for i in range(6)]
SUN, SUN_ANGLE, SUN_WAY = 16, 1.2, (1.6, 0.45, -1.0)  # W/m2, degrees, direction of the rays
SKY = (4.2, 5.1, 6.2)  # W/m2/sr
SLOPE = math.sqrt(0.5)

reset(640, 360, "Filmic")
bpy.context.scene.view_settings.exposure = 2.4
planks = diffuse("floor boards", image("floor boards", boards(2048, 1024, 10, (0.70, 0.57, 0.43), 3)))
lining = diffuse("roof boards", image("roof boards", boards(2048, 1024, 9, (0.88, 0.79, 0.66), 14, 0.2)))
painted = diffuse("painted boards", image("painted boards", boards(1024, 1024, 9, (0.90, 0.88, 0.82), 25, 0.08)))
bare = diffuse("partition boards", image("partition boards", boards(1024, 1024, 8, (0.86, 0.80, 0.69), 36, 0.12)))
timber = diffuse("timber", image("timber", wood(512, (0.66, 0.50, 0.35), 7)))
dark_wood = diffuse("dark wood", image("dark wood", wood(512, (0.44, 0.28, 0.18), 17)))
white_paint = diffuse("white paint", (0.76, 0.75, 0.71))
iron = diffuse("iron", (0.06, 0.055, 0.05))
brass = diffuse("brass", (0.48, 0.36, 0.15))
paper = diffuse("paper", (0.74, 0.69, 0.57))
BOARDS = (4.0, 1.4)  # metres that an image of boards covers


def daylight():
    """The sun, and a sky of one colour."""
    data = bpy.data.lights.new("sun", "SUN")
    data.angle = math.radians(SUN_ANGLE)
    place_light("sun", data, (-6, 0, 8), SUN, (1.0, 0.90, 0.74), SUN_WAY)
    world = bpy.context.scene.world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    strength = max(SKY)
    background.inputs["Color"].default_value = (*(c / strength for c in SKY), 1)
    background.inputs["Strength"].default_value = strength


def closed_box(name, low, high, material, grain):
    """A box whose boards run along `grain`."""
    made = box(name, low, high, material)
    points = [v.co.copy() for v in made.data.vertices]
    faces = [tuple(p.vertices) for p in made.data.polygons]
    bpy.data.meshes.remove(made.data)
    return solid(name, points, faces, material, grain, BOARDS)


def shell():
    """Floor, knee walls, gables and roof; each reaches into its neighbours."""
    side, end = HALF + INTO, LENGTH + INTO
    closed_box("floor", (-side, -INTO, -ROOF), (side, end, 0), planks, (0, 1, 0))
    for name, sign in (("wall left", -1), ("wall right", 1)):
        low, high = sorted((sign * HALF, sign * (HALF + THIN)))
        closed_box(name, (low, -INTO, -INTO), (high, end, KNEE + 0.01), painted, (0, 1, 0))
    rise = math.hypot(HALF, RIDGE - KNEE)
    eaves = 0.2
    foot = [-eaves, rise + 0.02]  # beyond the ridge into the other slope
    start, stop, low, high = SKYLIGHT
    for name, x, y, u, v, cut in (("roof left", -HALF, -INTO, 1, 1, True), ("roof right", HALF, end, -1, -1, False)):
        frame = ((x, y, KNEE), (0, u, 0), (v * SLOPE, 0, SLOPE))
        us = [0, start + INTO, stop + INTO, end + INTO] if cut else [0, end + INTO]
        vs = [foot[0], low, high, foot[1]] if cut else foot
        grid_slab(name, frame, us, vs, (1, 1) if cut else None, ROOF, lining, (0, 1, 0), BOARDS)
    gable("wall front", (0, 0, 0), (-1, 0, 0), None)
    gable("wall back", (0, LENGTH, 0), (1, 0, 0), WINDOW)


def gable(name, origin, u, window):
    """A wall up to the roof, a little higher than its inside; window: left, right, low, high."""
    frame = (origin, u, (0, 0, 1))
    half, up = HALF + THIN - 0.005, RIDGE + 0.02
    outline = [(-half, -INTO), (half, -INTO), (half, up - half), (0, up), (-half, up - half)]
    faces = [[0, 1, 2, 3, 4]]
    if window:
        a, b, low, high = window
        outline += [(a, -INTO), (b, -INTO), (b, up + b), (a, up + a), (a, low), (b, low), (b, high), (a, high)]
        faces = [[5, 6, 10, 9], [12, 11, 7, 8]]  # above and below the window; fans of triangles beside it
        faces += [[4, *pair] for pair in ((0, 5), (5, 9), (9, 12), (12, 8))]
        faces += [[2, *pair] for pair in ((3, 7), (7, 11), (11, 10), (10, 6), (6, 1))]
    slab(name, frame, outline, faces, THIN, painted, (0, 0, 1), BOARDS)


def divider():
    """A partition of boards with a doorway, and one at right angles to it: they shut off the store-room."""
    a, b, top = DOOR
    left, right, up = STORE_X - PARTITION / 2, HALF + INTO, RIDGE + 0.025
    outline = [(left, -INTO), (a, -INTO), (a, top), (b, top), (b, -INTO), (right, -INTO), (right, up - right), (0, up),
               (left, up + left), (b, up - b)]
    faces = [[8, 0, 1], [8, 1, 2], [8, 2, 7], [2, 3, 9, 7], [6, 9, 3], [6, 3, 4], [6, 4, 5]]
    front = slab("front", ((0, STORE_Y, 0), (1, 0, 0), (0, 0, 1)), outline, faces, PARTITION, bare, (0, 0, 1), BOARDS)
    side = closed_box("side", (left + 0.001, STORE_Y + 0.01, -INTO),
                      (left + PARTITION - 0.001, LENGTH + INTO, RIDGE + STORE_X + 0.02), bare, (0, 0, 1))
    join("divider", [front, side])
    wide, thick, y = 0.08, 0.016, STORE_Y - 0.006
    join("door frame", [
        beam("post", (a - wide / 2, y, 0.001), (a - wide / 2, y, top + wide), (1, 0, 0), wide, thick, timber),
        beam("post", (b + wide / 2, y, 0.001), (b + wide / 2, y, top + wide), (1, 0, 0), wide, thick, timber),
        beam("head", (a, y, top + wide / 2), (b, y, top + wide / 2), (0, 0, 1), wide, thick, timber)])


def roof_timbers():
    """Rafters in pairs, collar beams beside them, the ridge beam, and a plate along each knee wall."""
    width, depth = 0.07, 0.12
    for name, sign in (("rafters left", -1), ("rafters right", 1)):
        inner = Vector((-sign * SLOPE, 0, -SLOPE)) * (depth / 2 - 0.005)
        join(name, [beam("rafter", Vector((sign * (HALF + 0.09), y, RIDGE - HALF - 0.09)) + inner,
                         Vector((sign * 0.02, y, RIDGE - 0.02)) + inner, (0, 1, 0), width, depth, timber)
                    for y in RAFTERS])
    join("collar beams", [beam("collar", (-1.2, y + 0.055, 2.55), (1.2, y + 0.055, 2.55), (0, 0, 1), 0.14, 0.04, timber)
                          for y in RAFTERS])
    beam("ridge beam", (0, 0.002, RIDGE - 0.19), (0, LENGTH - 0.002, RIDGE - 0.19), (1, 0, 0), 0.08, 0.16, timber)
    join("skirting", [beam("board", (sign * (HALF - 0.008), 0.002, 0.055), (sign * (HALF - 0.008), LENGTH - 0.002,
                           0.055), (0, 0, 1), 0.11, 0.02, timber) for sign in (-1, 1)])


def window_frames():
    a, b, low, high = WINDOW
    frame_of_beams("gable frame", (0, LENGTH + THIN / 2, 0), (1, 0, 0), (0, 0, 1), (a - 0.01, low - 0.01),
                   (b + 0.01, high + 0.01), 0.06, 0.06, white_paint)
    box("sill", (a - 0.06, LENGTH - 0.12, low - 0.02), (b + 0.06, LENGTH + 0.01, low + 0.006), white_paint)
    start, stop, foot, head = SKYLIGHT
    middle = Vector((-HALF, 0, KNEE)) - Vector((SLOPE, 0, -SLOPE)) * (ROOF / 2)
    frame_of_beams("skylight frame", middle, (0, 1, 0), (SLOPE, 0, SLOPE), (start - 0.01, foot - 0.01),
                   (stop + 0.01, head + 0.01), 0.05, 0.09, timber, bars=(1, 0))


def under_the_skylight(x, y):
    """The table and what stands on it, with a chair."""
    top = table("table", x, y, 4, dark_wood)
    furniture("table lamp", "CC-BY", "lamp", (x - 0.05, y + 0.40, top), turn=-20, colours={"Shade": (0.62, 0.52, 0.36)})
    furniture("open book", "CC-BY", "book", (x + 0.10, y - 0.10, top), turn=-75)
    pile_of_books("books on the table", x - 0.16, y - 0.42, top, 6, BOOKS, paper, 3)
    furniture("toy car", "CC-BY", "carrito-de-madera", (x + 0.20, y - 0.42, top), turn=60,
              colours={"Material": (0.30, 0.09, 0.06), "Material.001": (0.50, 0.36, 0.20),
                       "Material.003": (0.08, 0.06, 0.05)})
    furniture("chair", "CC-0", "chairWithCushion", (x + 0.66, y - 0.12, 0), turn=-112,
              colours={"Cloth": (0.28, 0.10, 0.07), "ChairWood": (0.30, 0.17, 0.09)})


def under_the_window():
    """A chest of drawers with a trailing plant, a clock and a bear."""
    x, y, top = -1.05, LENGTH - 0.30, 0.82
    furniture("chest of drawers", "CC-BY", "chest", (x, y, 0))
    plant("trailing plant", "CC-0", "augalas", (x + 0.42, y - 0.07, top), ("Leaf",), turn=200)
    pile_of_books("books on the chest", x - 0.02, y + 0.02, top, 4, BOOKS, paper, 8)
    furniture("teddy bear", "CC-0", "teddyBear", (x - 0.40, y, top), turn=15)


def in_the_sun():
    """A palm, toys and an armchair, where the sun falls and beside it."""
    plant("palm", "CC-0", "plant", (1.05, 4.08, 0), ("grass_shader_1",), scale=0.82, turn=40,
                colours={"grass_shader_1": (0.11, 0.25, 0.05), "pot": (0.42, 0.19, 0.11)})
    furniture("toy train", "CC-BY", "toyTrain", (0.40, 3.68, 0.0095), scale=1.3, turn=-35)
    furniture("rocking horse", "CC-0", "caballito", (1.62, 3.70, 0), scale=1.35, turn=25,
              colours={"Madera": (0.50, 0.27, 0.12), "Madera.001": (0.46, 0.11, 0.07),
                       "Madera.002": (0.44, 0.26, 0.12), "C3": (0.60, 0.47, 0.26)})
    furniture("armchair", "CC-0", "winchesterArmchair", (1.90, 2.78, 0), turn=-50, colours=dict.fromkeys(
        ("Buttons", "Back", "Surround", "Sit"), (0.20, 0.30, 0.22)))


def along_the_left():
    """Trunk, boxes, suitcases and a cradle under the slope."""
    hide = diffuse("hide", image("hide", leather(512)))
    turned(trunk("trunk", 0.95, 0.52, 0.50, hide, timber, brass), -0.85, 4.85, 0, 14)
    case = furniture("suitcase", "CC-BY", "suitcase", (0, 0, 0), scale=0.62,
                     colours={"Coque": (0.34, 0.16, 0.08), "Ceinture": (0.20, 0.11, 0.06)})
    laid(case, -0.83, 4.86, 0.5125, 20)
    laid(again(case, "suitcase 2", (0, 0, 0)), 0.38, 5.15, 0.0, 80)
    laid(again(case, "suitcase 3", (0, 0, 0)), 0.36, 5.18, 0.1965, 97)
    furniture("cradle", "CC-0", "babyRockingBed", (-2.15, 5.3, 0), turn=80)
    furniture("barrel", "CC-0", "barrel", (-2.3, 4.4, 0), scale=0.75)
    brown = diffuse("cardboard", image("cardboard", cardboard(512)))
    box_a = turned(carton("carton 1", 0.48, 0.38, 0.34, brown), 0.35, 5.9, 0, 10)
    again(box_a, "carton 2", (0.42, 5.95, 0.3405), -8)
    again(box_a, "carton 3", (1.0, 5.4, 0), 24)


def store_room():
    furniture("wardrobe", "CC-BY", "wardrobe", (1.15, 6.2, 0))


def on_the_partition():
    """A picture, and a chandelier without light that hangs from a collar beam."""
    framed("picture", Wall((0, STORE_Y), (0, -1)), 1.12, 1.72, 1.28, 1.70,
           diffuse("painting", image("painting", painting(512, 360))), brass)
    lamp = furniture("chandelier", "CC-0", "lamp2", (0.55, RAFTERS[3] + 0.055, 0), scale=0.9,
                     colours={"Chandelier": (0.10, 0.08, 0.05), "Lamp": (0.5, 0.47, 0.4), "Glass": (0.6, 0.57, 0.5)})
    lamp.location.z = 2.481 - extent(lamp)[1][2]


def rug():
    woven = diffuse("rug", image("rug", old_rug(1024, 1536)))
    whole_image(box("rug", (-0.7, 2.0, 0.001), (0.7, 4.1, 0.009), woven))


BOOKS = covers()
daylight()
shell()
divider()
roof_timbers()
window_frames()
under_the_skylight(-1.75, 3.25)
under_the_window()
in_the_sun()
along_the_left()
store_room()
on_the_partition()
pile_of_books("books by the armchair", 1.02, 2.95, 0, 7, BOOKS, paper, 12)
rug()
camera((-0.5, 0.25, 1.5), (0.12, 4.5, 1.30), 82)
save()
