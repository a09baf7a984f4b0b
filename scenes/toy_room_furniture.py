"""Furniture of the toy room that its scripts build: round slabs and a table, shelves."""
import math

from scene_tools import box, join
from toy_room_parts import faces_object


def round_slab(name, centre, radius, low, high, material, tile=1.0, sides=64):
    """A flat cylinder; UV: seen from above, in tiles of `tile` metres."""
    x, y = centre
    ring = [(x + radius * math.cos(math.tau * i / sides), y + radius * math.sin(math.tau * i / sides))
            for i in range(sides)]
    vertices = [(u, v, low) for u, v in ring] + [(u, v, high) for u, v in ring]
    faces = [tuple(range(sides - 1, -1, -1)), tuple(range(sides, 2 * sides))]
    faces += [(i, (i + 1) % sides, sides + (i + 1) % sides, sides + i) for i in range(sides)]
    return faces_object(name, vertices, faces, [(u / tile, v / tile) for u, v, _ in vertices], material)


def round_table(name, centre, radius, foot, top, wood, paint):
    """A round top on four legs that lean outwards."""
    x, y = centre
    parts = [round_slab("top", centre, radius, top - 0.028, top, wood, tile=0.9)]
    for corner in range(4):
        angle = math.tau * (corner + 0.5) / 4
        leg = box("leg", (-0.024, -0.024, 0), (0.024, 0.024, top - 0.028 - foot), paint)
        for vertex in leg.data.vertices:  # the lower end is thinner and farther out
            up = vertex.co.z / (top - 0.028 - foot)
            reach = radius * (0.80 - 0.18 * up)
            vertex.co.x = x + reach * math.cos(angle) + vertex.co.x * (0.7 + 0.3 * up)
            vertex.co.y = y + reach * math.sin(angle) + vertex.co.y * (0.7 + 0.3 * up)
            vertex.co.z += foot
        parts.append(leg)
    return join(name, parts)


def cubbies(name, low, high, columns, rows, carcass, top, board=0.022):
    """An open shelf unit with square compartments that faces -y; returns the corners (x, z) where things may stand."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    wide, tall = (x1 - x0 - board) / columns, (z1 - z0 - 2 * board - 0.05) / rows
    parts = [box("plinth", (x0 + 0.02, y0 + 0.03, z0), (x1 - 0.02, y1, z0 + 0.05), carcass),
             box("back", (x0 + board, y1 - 0.008, z0 + 0.05 + board), (x1 - board, y1, z1 - board), carcass),
             box("top", (x0 - 0.01, y0 - 0.012, z1 - board), (x1 + 0.01, y1, z1), top, tile=0.9)]
    parts += [box("side", (x0 + i * wide, y0 + (0 if i in (0, columns) else 0.004), z0 + 0.05),
                  (x0 + i * wide + board, y1 - (0 if i in (0, columns) else 0.008), z1 - board), carcass)
              for i in range(columns + 1)]
    parts += [box("board", (x0 + i * wide + board, y0 + 0.004, z0 + 0.05 + j * tall),
                  (x0 + (i + 1) * wide, y1 - 0.008, z0 + 0.05 + j * tall + board), carcass)
              for i in range(columns) for j in range(rows)]
    join(name, parts)
    return [[(x0 + (i + 0.5) * wide + board / 2, z0 + 0.05 + j * tall + board) for i in range(columns)]
            for j in range(rows)]


def wall_shelf(name, low, high, wood, brackets):
    """A board on two triangular brackets on the back wall."""
    (x0, y0, z0), (x1, y1, _) = low, high
    parts = [box("board", low, high, wood, tile=0.8)]
    for x in (x0 + 0.12, x1 - 0.14):
        parts += [box("bracket", (x, y0 + 0.05, z0 - 0.02), (x + 0.02, y1, z0), brackets),
                  box("bracket", (x, y1 - 0.02, z0 - 0.15), (x + 0.02, y1, z0 - 0.02), brackets)]
    return join(name, parts)
