"""Parts of the attic that are made of boards: thin closed slabs with holes, beams, and what lies about in an attic."""
import math
import random

import bpy
from mathutils import Matrix, Vector
from scene_tools import box, extent, join


def solid(name, points, faces, material, grain, tile=(1.0, 1.0)):
    """An object from faces of any number of corners. UV: metres along `grain` and across it, in tiles."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(p) for p in points], [], faces)
    layer, grain = mesh.uv_layers.new(), Vector(grain).normalized()
    for polygon in mesh.polygons:
        normal = polygon.normal
        along = grain - normal * grain.dot(normal)
        along = along.normalized() if along.length > 0.1 else normal.orthogonal().normalized()
        across = normal.cross(along)
        for loop in polygon.loop_indices:
            point = mesh.vertices[mesh.loops[loop].vertex_index].co
            layer.data[loop].uv = (point.dot(along) / tile[0], point.dot(across) / tile[1])
    mesh.materials.append(material)
    added = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(added)
    return added


def slab(name, frame, outline, faces, thickness, material, grain, tile):
    """A closed board: flat faces of the points `outline` (u, v), counter-clockwise as seen from inside, and a second
    layer `thickness` behind them; every edge that only one face has gets a side. frame: (origin, u axis, v axis)."""
    origin, u, v = (Vector(part) for part in frame)
    inward = u.cross(v).normalized()
    near = [origin + u * a + v * b for a, b in outline]
    count = len(near)
    points = near + [point - inward * thickness for point in near]
    edges = {(a, b) for face in faces for a, b in zip(face, face[1:] + face[:1])}
    sides = [(b, a, a + count, b + count) for a, b in sorted(edges) if (b, a) not in edges]
    behind = [tuple(corner + count for corner in reversed(face)) for face in faces]
    return solid(name, points, [*map(tuple, faces), *behind, *sides], material, grain, tile)


def grid_slab(name, frame, us, vs, hole, thickness, material, grain, tile):
    """A rectangular slab cut into a grid at us and vs; hole: (column, row) of the cell left open, or None."""
    wide = len(us)
    outline = [(u, v) for v in vs for u in us]
    faces = [[row * wide + column, row * wide + column + 1, (row + 1) * wide + column + 1, (row + 1) * wide + column]
             for row in range(len(vs) - 1) for column in range(wide - 1) if (column, row) != hole]
    return slab(name, frame, outline, faces, thickness, material, grain, tile)


def beam(name, start, end, side, width, depth, material, tile=(2.0, 0.5)):
    """A squared timber from start to end; `width` along the direction `side`, `depth` across."""
    start, end = Vector(start), Vector(end)
    along = (end - start).normalized()
    side = (Vector(side) - along * along.dot(Vector(side))).normalized()
    other = along.cross(side)
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    points = [point + side * (a * width / 2) + other * (b * depth / 2) for point in (start, end) for a, b in corners]
    faces = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    made = solid(name, points, faces, material, along, tile)
    shift = random.Random(name + str(tuple(start))).random()
    for loop in made.data.uv_layers.active.data:
        loop.uv = (loop.uv[0] + shift, loop.uv[1] + shift * 7)
    return made


def frame_of_beams(name, origin, u, v, low, high, wide, depth, material, bars=(1, 1)):
    """A window frame in the rectangle low..high (u, v) with `bars` upright and level bars between the outer ones;
    `depth` of it along the normal, half on each side of the plane."""
    origin, u, v = Vector(origin), Vector(u), Vector(v)
    normal = u.cross(v)

    def level(at, thick):
        return beam("bar", origin + u * low[0] + v * at, origin + u * high[0] + v * at, normal, depth, thick, material)

    def upright(at, thick, shrink):
        return beam("bar", origin + u * at + v * (low[1] + shrink), origin + u * at + v * (high[1] - shrink), normal,
                    depth - 0.006, thick, material)

    parts = [level(low[1] + wide / 2, wide), level(high[1] - wide / 2, wide)]
    parts += [upright(low[0] + wide / 2, wide, wide / 2), upright(high[0] - wide / 2, wide, wide / 2)]
    for bar in range(bars[0]):
        parts.append(upright(low[0] + (high[0] - low[0]) * (bar + 1) / (bars[0] + 1), wide * 0.6, wide / 2))
    for bar in range(bars[1]):
        at = low[1] + (high[1] - low[1]) * (bar + 1) / (bars[1] + 1)
        parts.append(beam("bar", origin + u * (low[0] + wide / 2) + v * at, origin + u * (high[0] - wide / 2) + v * at,
                          normal, depth - 0.012, wide * 0.6, material))
    return join(name, parts)


def turned(thing, x, y, z, degrees):
    """Put an object that was made around the origin in its place."""
    thing.location, thing.rotation_euler = (x, y, z), (0, 0, math.radians(degrees))
    return thing


def pile_of_books(name, x, y, z, count, materials, paper, seed):
    """Books that lie on one another, each a little turned: two covers, a spine and the block of pages."""
    chance, parts, z = random.Random(seed), [], z + 0.0005
    for _ in range(count):
        wide, deep, thick = chance.uniform(0.13, 0.18), chance.uniform(0.19, 0.26), chance.uniform(0.02, 0.05)
        cover, board, angle = chance.choice(materials), 0.003, chance.gauss(0, 9) + 180 * chance.randrange(2)
        pieces = [box("cover", (-wide, -deep, 0), (0, deep, board), cover),
                  box("cover", (-wide, -deep, thick - board), (0, deep, thick), cover),
                  box("spine", (-wide, -deep, board), (-wide + board, deep, thick - board), cover),
                  box("pages", (-wide + board, -deep + 0.008, board), (-0.008, deep - 0.008, thick - board), paper)]
        place = Matrix.Translation((x + chance.gauss(0, 0.008), y + chance.gauss(0, 0.008), z)) @ Matrix.Rotation(
            math.radians(angle), 4, "Z") @ Matrix.Diagonal((0.9, 0.5, 1, 1)) @ Matrix.Translation((wide / 2, 0, 0))
        for piece in pieces:
            piece.data.transform(place)
        parts += pieces
        z += thick + 0.0005
    join(name, parts)
    return z


def trunk(name, wide, deep, high, cover, wood, metal):
    """A closed travelling trunk around the origin: thin sides, a lid, wooden slats and metal corners."""
    x, y, lid, board = wide / 2, deep / 2, high * 0.72, 0.012
    parts = [box("bottom", (-x, -y, 0.012), (x, y, 0.012 + board), cover),
             box("lid", (-x - 0.004, -y - 0.004, high - board), (x + 0.004, y + 0.004, high), cover)]
    for low, top, out in ((0.012 + board, lid, 0.0), (lid, high - board, 0.004)):
        parts += [box("side", (-x - out, -y - out, low), (x + out, -y - out + board, top), cover),
                  box("side", (-x - out, y + out - board, low), (x + out, y + out, top), cover),
                  box("side", (-x - out, -y - out + board, low), (-x - out + board, y + out - board, top), cover),
                  box("side", (x + out - board, -y - out + board, low), (x + out, y + out - board, top), cover)]
    for at in (-x * 0.55, x * 0.55):
        parts += [box("slat", (at - 0.025, -y - 0.016, 0.02), (at + 0.025, -y - 0.001, lid - 0.004), wood),
                  box("slat", (at - 0.025, -y - 0.020, lid + 0.004), (at + 0.025, -y - 0.005, high + 0.012), wood),
                  box("slat", (at - 0.025, -y - 0.005, high + 0.0005), (at + 0.025, y + 0.004, high + 0.012), wood)]
    for side_x in (-1, 1):
        for side_y in (-1, 1):
            parts.append(box("foot", (side_x * (x - 0.02) - 0.03, side_y * (y - 0.02) - 0.03, 0),
                             (side_x * (x - 0.02) + 0.03, side_y * (y - 0.02) + 0.03, 0.05), metal))
    parts.append(box("lock", (-0.045, -y - 0.012, lid - 0.06), (0.045, -y - 0.0045, lid + 0.05), metal))
    return join(name, parts)


def carton(name, wide, deep, high, board):
    """A closed cardboard box around the origin; its image covers each side once."""
    made = box(name, (-wide / 2, -deep / 2, 0), (wide / 2, deep / 2, high), board)
    return whole_image(made)


def whole_image(thing):
    """Let a box's image cover each of its sides once."""
    for polygon in thing.data.polygons:
        for loop, uv in zip(polygon.loop_indices, ((0, 0), (1, 0), (1, 1), (0, 1))):
            thing.data.uv_layers.active.data[loop].uv = uv
    return thing


def table(name, x, y, turn, material):
    """A kitchen table with a drawer, long side along y; returns its height."""
    top, wide, deep = 0.75, 1.25, 0.72
    u, v = deep / 2, wide / 2
    parts = [box("top", (-u, -v, top - 0.028), (u, v, top), material, tile=0.9)]
    parts += [beam("apron", (s * (u - 0.06), -v + 0.09, top - 0.08), (s * (u - 0.06), v - 0.09, top - 0.08), (0, 0, 1),
                   0.104, 0.02, material) for s in (-1, 1)]
    parts += [beam("apron", (-u + 0.09, s * (v - 0.06), top - 0.08), (u - 0.09, s * (v - 0.06), top - 0.08), (0, 0, 1),
                   0.104, 0.02, material) for s in (-1, 1)]
    parts += [beam("leg", (s * (u - 0.06), t * (v - 0.06), 0.001), (s * (u - 0.06), t * (v - 0.06), top - 0.028),
                   (1, 0, 0), 0.06, 0.06, material) for s in (-1, 1) for t in (-1, 1)]
    turned(join(name, parts), x, y, 0, turn)
    return top


def laid(thing, x, y, z, turn):
    """Lay an upright object on its back."""
    low, high = extent(thing)
    place = Matrix.Rotation(math.radians(turn), 4, "Z") @ Matrix.Rotation(math.radians(90), 4, "X")
    thing.location = Vector((x, y, z - low[1])) - place @ Vector((0, 0, (low[2] + high[2]) / 2))
    thing.rotation_euler = place.to_euler()
    return thing
