"""Shelf units full of books, and books by themselves, each kind one mesh for linked duplicates.

Units stand on z = 0, are centred on x and show the backs of their books towards -y.
"""
import math
import random

import bpy
from library_pictures import SPINES
from scene_tools import add_mesh, box, join, quads

FACES = ((0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6))
BOTTOM, TOP, FRONT, RIGHT, BEHIND, LEFT = range(6)
BOARD, PLINTH = 0.025, 0.07
CLEAR = 0.0005  # between a book and what it stands on


class Boxes:
    """Closed boxes gathered into one mesh; far quicker than joining an object for each."""

    def __init__(self):
        self.vertices, self.faces, self.paints, self.uvs = [], [], [], []

    def add(self, low, high, paint, place=None):
        """paint(face, corners): material index and UVs; place: maps a corner to where it goes."""
        corners = [tuple(high[axis] if i >> axis & 1 else low[axis] for axis in range(3)) for i in range(8)]
        for number, face in enumerate(FACES):
            material, uv = paint(number, [corners[i] for i in face])
            self.faces.append(tuple(len(self.vertices) + i for i in face))
            self.paints.append(material)
            self.uvs += uv
        self.vertices += [place(*corner) for corner in corners] if place else corners

    def wood(self, low, high, tile=1.1):
        """A board whose grain runs along its longest edge."""
        size = [b - a for a, b in zip(low, high)]
        shift = random.random()

        def paint(face, corners):
            flat = [axis for axis in range(3) if axis != {BOTTOM: 2, TOP: 2, FRONT: 1, BEHIND: 1}.get(face, 0)]
            along, across = sorted(flat, key=lambda axis: -size[axis])
            return 0, [(c[along] / tile + shift, c[across] / tile + shift) for c in corners]
        self.add(low, high, paint)

    def made(self, name, materials):
        mesh = bpy.data.meshes.new(name)
        mesh.from_pydata(self.vertices, [], self.faces)
        mesh.uv_layers.new().data.foreach_set("uv", [value for uv in self.uvs for value in uv])
        for material in materials:
            mesh.materials.append(material)
        mesh.polygons.foreach_set("material_index", self.paints)
        thing = bpy.data.objects.new(name, mesh)
        bpy.context.collection.objects.link(thing)
        return thing


def book_paint(design, flat=False):
    """Back, covers and leaves of a book that stands, or lies flat with its back towards -y."""
    u0, u1, plain = (design + 0.03) / SPINES, (design + 0.97) / SPINES, (design + 0.5) / SPINES
    leaves = (RIGHT, BEHIND, LEFT) if flat else (TOP, BOTTOM, BEHIND)

    def paint(face, corners):
        if face in leaves:
            return 1, [(0, 0), (1, 0), (1, 0.2), (0, 0.2)]
        if face == FRONT:
            return 0, [(u0, 0), (u0, 1), (u1, 1), (u1, 0)] if flat else [(u0, 0), (u1, 0), (u1, 1), (u0, 1)]
        return 0, [(plain, 0.04), (plain + 0.004, 0.04), (plain + 0.004, 0.06), (plain, 0.06)]
    return paint


def pile(boxes, x, spine, z, room, place=None):
    """Books that lie on each other, the widest below; returns the pile's width."""
    wide = width = random.uniform(0.23, 0.28)
    for _ in range(random.randint(2, 5)):
        thick = random.uniform(0.02, 0.045)
        if z + thick > room:
            break
        start, back = x + random.uniform(0, width - wide), spine + random.uniform(0, 0.02)
        boxes.add((start, back, z + CLEAR), (start + wide, back + wide * 0.72, z + thick),
                  book_paint(random.randrange(SPINES), flat=True), place)
        z += thick
        wide -= random.uniform(0.004, 0.02)
    return width


def leaning(boxes, x, neighbour, spine, z, place):
    """A book that leans to the left on a neighbour of the given height; returns the x where it ends."""
    tall, thick = neighbour * random.uniform(0.85, 1.0), random.uniform(0.016, 0.035)
    angle = math.radians(random.uniform(8, 20))
    sine, cosine = math.sin(angle), math.cos(angle)
    foot = x + tall * sine + 0.001

    def lean(along, y, up):
        return place(foot + along * cosine - up * sine, y, z + CLEAR + along * sine + up * cosine)
    boxes.add((0, spine, 0), (thick, spine + tall * 0.7, tall), book_paint(random.randrange(SPINES)), lean)
    return foot + thick * cosine + 0.001


def row(boxes, start, end, spine, z, room, place):
    """Books on one board: runs of one series, single ones, gaps, leaning books and piles."""
    x, tall, run = start, 0.0, 0
    while True:
        chance = random.random()
        if run == 0 and chance < 0.012 and x + 0.3 < end:
            x, tall = x + pile(boxes, x + 0.01, spine, z, z + room, place) + 0.02, 0.0
        elif run == 0 and chance < 0.05 and tall > 0 and x + 0.16 < end:
            x, tall = leaning(boxes, x, tall, spine, z, place), 0.0
            x += random.choice((0, 0, 0.05, 0.14))
        if run == 0:
            design, thick = random.randrange(SPINES), random.uniform(0.014, 0.046)
            tall = random.uniform(0.62, 1.0) * min(room - 0.015, 0.31)
            run = random.randint(4, 9) if random.random() < 0.16 else 1
            back = spine + random.uniform(0, 0.018)
        if x + thick > end:
            return
        shift = random.uniform(0, 0.003)
        boxes.add((x, back + shift, z + CLEAR), (x + thick, back + shift + min(tall * 0.72, 0.2), z + tall),
                  book_paint(design), place)
        x, run = x + thick + 0.0012, run - 1


def levels(height, count):
    """Upper faces of the boards on which books stand."""
    return [PLINTH + BOARD + i * (height - PLINTH - BOARD) / count for i in range(count)]


def unit(name, length, height, count, seed, materials, double=False):
    """A shelf unit with books on one side, or on both: (wood, books). materials: wood, backs of books, leaves."""
    random.seed(seed)
    half, depth, side, (wood, *paper) = length / 2, 0.30, 0.03, materials
    front, back = -depth, depth if double else 0.0
    shelf, filled = Boxes(), Boxes()
    shelf.wood((-half, front, 0), (-half + side, back, height))
    shelf.wood((half - side, front, 0), (half, back, height))
    inner = half - side
    shelf.wood((-inner - 0.002, front + 0.03, 0), (inner + 0.002, back - (0.03 if double else 0.001), PLINTH + 0.002))
    for z in [*levels(height, count), height + 0.02]:
        top = z > height
        low, high = (-half - 0.008, front - 0.008), (half + 0.008, back + 0.008 * double)
        if not top:
            low, high = (-inner - 0.003, front + 0.006), (inner + 0.003, back - 0.006 * double)
        shelf.wood((*low, z - BOARD), (*high, z))
    room = (height - PLINTH - BOARD) / count - BOARD
    for z in levels(height, count):
        shelf.wood((-inner - 0.004, -0.012, z - 0.004), (inner + 0.004, 0.012 * double - 0.002, z + room + 0.0205))
        for turned in range(1 + double):
            sign = -1 if turned else 1
            row(filled, -inner + 0.006, inner - random.choice((0.01, 0.05, 0.3)), front + 0.03, z, room,
                lambda x, y, up, sign=sign: (sign * x, sign * y, up))
    return shelf.made(name, [wood]), filled.made(f"{name} books", paper)


def table_pile(name, seed, materials):
    """A pile of books of its own, centred."""
    random.seed(seed)
    boxes = Boxes()
    pile(boxes, -0.13, -0.09, 0, 1)
    return boxes.made(name, materials)


def open_book(name, cover, page):
    """A book that lies open: two bulging blocks of leaves on a flat cover."""
    half, deep, thin, strips = 0.16, 0.115, 0.004, 10
    parts = [box("cover", (-half - 0.005, -deep - 0.005, 0.0005), (half + 0.005, deep + 0.005, thin), cover)]
    for sign in (-1, 1):
        profile = [(sign * half * i / strips, 0.006 + 0.02 * math.sin(math.pi * (i / strips) ** 0.6) ** 0.8)
                   for i in range(strips + 1)]
        profile = [(x, z + 0.008 * (1 - abs(x) / half)) for x, z in profile]
        vertices = [(x, y, z) for y in (-deep, deep) for x, z in profile]
        faces = [(i, i + 1, i + strips + 2, i + strips + 1) for i in range(strips)]
        if sign < 0:
            faces = [face[::-1] for face in faces]
        sheet = add_mesh("leaves", vertices, faces, page)
        for loop in sheet.data.loops:
            x, y, _ = sheet.data.vertices[loop.vertex_index].co
            sheet.data.uv_layers.active.data[loop.index].uv = (abs(x) / half if sign > 0 else 1 - abs(x) / half,
                                                               (y + deep) / (2 * deep))
        rims = [((x0, y, thin), (x1, y, thin), (x1, y, z1), (x0, y, z0)) for y in (-deep, deep)
                for (x0, z0), (x1, z1) in zip(profile, profile[1:])]
        x, z = profile[-1]
        rims.append(((x, -deep, thin), (x, deep, thin), (x, deep, z), (x, -deep, z)))
        parts += [sheet, quads("rim", rims, page, tile=9)]
    return join(name, parts)
