"""Parts of rooms that several scenes share: walls with windows, curtains, shelves of books, framed pictures.

Points of a part are (u to the right along the wall as seen from inside, d inward from its face, z up).
"""
import math
import random
from dataclasses import dataclass

from scene_tools import add_mesh, box, diffuse, join, quads


@dataclass(frozen=True)
class Wall:
    """A wall parallel to an axis, which starts at `origin` and faces `inward`, a unit vector: (x, y) both."""
    origin: tuple
    inward: tuple

    def at(self, u, d, z):
        (x, y), (dx, dy) = self.origin, self.inward
        return (x - dy * u + dx * d, y + dx * u + dy * d, z)

    def box(self, name, low, high, material, tile=1.0):
        """A box between two corners (u, d, z)."""
        a, b = self.at(*low), self.at(*high)
        return box(name, tuple(map(min, a, b)), tuple(map(max, a, b)), material, tile)

    def quads(self, name, corners, material, tile=1.0):
        """Quads of corners (u, d, z), counter-clockwise seen from where they face."""
        return quads(name, [tuple(self.at(*corner) for corner in quad) for quad in corners], material, tile)


@dataclass(frozen=True)
class Opening:
    """A rectangle cut out of a wall."""
    start: float
    end: float
    low: float
    high: float


def pierced(name, wall, length, height, openings, material):
    """The face of a wall around openings, which lie side by side in the order of their starts."""
    pieces, start = [], 0.0
    for opening in openings:
        pieces += [(start, opening.start, 0, height), (opening.start, opening.end, 0, opening.low),
                   (opening.start, opening.end, opening.high, height)]
        start = opening.end
    pieces.append((start, length, 0, height))
    return wall.quads(name, [((a, 0, c), (b, 0, c), (b, 0, d), (a, 0, d)) for a, b, c, d in pieces if d > c and b > a],
                      material)


def reveal(name, wall, opening, thickness, material):
    """The four faces of the wall's thickness inside an opening."""
    a, b, low, high, out = opening.start, opening.end, opening.low, opening.high, -thickness
    return wall.quads(name, [((a, 0, low), (b, 0, low), (b, out, low), (a, out, low)),
                             ((a, out, high), (b, out, high), (b, 0, high), (a, 0, high)),
                             ((a, out, low), (a, out, high), (a, 0, high), (a, 0, low)),
                             ((b, 0, low), (b, 0, high), (b, out, high), (b, out, low))], material)


def window_frame(name, wall, opening, depth, material, bars=1):
    """A frame 6 cm wide in an opening, from d = -depth to 6 cm nearer, with upright bars at even distances."""
    a, b, low, high = opening.start, opening.end, opening.low, opening.high
    near, far, wide = -depth, 0.06 - depth, 0.06
    parts = [((a, near, low), (b, far, low + wide)), ((a, near, high - wide), (b, far, high)),
             ((a, near, low + wide), (a + wide, far, high - wide)),
             ((b - wide, near, low + wide), (b, far, high - wide))]
    for bar in range(bars):
        middle = a + (b - a) * (bar + 1) / (bars + 1)
        parts.append(((middle - 0.035, near, low + wide), (middle + 0.035, far, high - wide)))
    return join(name, [wall.box("bar", *corners, material) for corners in parts])


def window_board(name, wall, opening, material):
    """A sill that stands out by 10 cm."""
    return wall.box(name, (opening.start - 0.05, -0.08, opening.low - 0.03),
                    (opening.end + 0.05, 0.10, opening.low + 0.004), material)


def curtain(wall, start, end, height, material):
    """A pleated sheet from `height` to 3 cm above the floor."""
    columns, rows, foot = 96, 12, 0.03
    vertices = []
    for row in range(rows + 1):
        for column in range(columns + 1):
            along = column / columns
            depth = 0.035 * math.sin(along * 9 * math.tau / 1.5) * (1 - 0.35 * row / rows)
            vertices.append(wall.at(start + (end - start) * along, 0.11 + depth, foot + (height - foot) * row / rows))
    faces = [(i, i + 1, i + columns + 2, i + columns + 1) for row in range(rows)
             for i in range(row * (columns + 1), row * (columns + 1) + columns)]
    sheet = add_mesh("curtain", vertices, faces, material)
    sheet.data.polygons.foreach_set("use_smooth", [True] * len(sheet.data.polygons))
    return sheet


COVERS = ((0.42, 0.06, 0.05), (0.05, 0.10, 0.26), (0.07, 0.22, 0.12), (0.60, 0.48, 0.26), (0.72, 0.68, 0.58),
          (0.10, 0.08, 0.07), (0.50, 0.22, 0.06), (0.20, 0.33, 0.42), (0.32, 0.14, 0.24))


def covers():
    """One material a colour of books."""
    return [diffuse(f"cover {i}", colour) for i, colour in enumerate(COVERS)]


def shelf_levels(height, shelves):
    """Heights of the boards of a bookcase; the last is its top."""
    return [0.08 + i * (height - 0.12) / shelves for i in range(shelves + 1)]


def bookcase(name, wall, start, end, depth, height, material, shelves=5):
    """Sides, back and boards of a case 2 cm off the wall."""
    back, front = 0.02, 0.02 + depth
    parts = [((start, back, 0), (start + 0.025, front, height)), ((end - 0.025, back, 0), (end, front, height)),
             ((start + 0.025, back, 0.08), (end - 0.025, back + 0.01, height))]
    parts += [((start + 0.025, back + 0.01, z), (end - 0.025, front - 0.004, z + 0.025))
              for z in shelf_levels(height, shelves)]
    return join(name, [wall.box("shelf", *corners, material, tile=1.1) for corners in parts])


def books(name, wall, start, end, depth, height, materials, seed, shelves=5):
    """Books for a bookcase of the same measures: closed boxes in rows with gaps."""
    random.seed(seed)
    spine, made = 0.02 + depth - 0.04, []
    for z in shelf_levels(height, shelves)[:-1]:
        u = start + 0.04
        while u < end - 0.10:
            thick, tall, deep = random.uniform(0.016, 0.05), random.uniform(0.19, 0.29), random.uniform(0.14, 0.21)
            made.append(wall.box("book", (u, spine - deep, z + 0.0255), (u + thick, spine, z + tall),
                                 random.choice(materials)))
            u += thick + (0.0015 if random.random() > 0.06 else random.uniform(0.06, 0.2))
    return join(name, made)


def framed(name, wall, start, end, low, high, canvas, frame):
    """A picture 3 cm off the wall in a frame 3 cm wide."""
    d, edge = 0.03, 0.03
    picture = wall.quads("canvas", [((start, d, low), (end, d, low), (end, d, high), (start, d, high))], canvas)
    for loop, uv in zip(picture.data.uv_layers.active.data, ((0, 0), (1, 0), (1, 1), (0, 1))):
        loop.uv = uv
    sides = [((start - edge, low - edge), (end + edge, low)), ((start - edge, high), (end + edge, high + edge)),
             ((start - edge, low), (start, high)), ((end, low), (end + edge, high))]
    bars = [wall.box("frame", (a, 0.001, b), (c, d + 0.015, e), frame) for (a, b), (c, e) in sides]
    return join(name, [picture, *bars])
