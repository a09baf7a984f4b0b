"""Furniture of the library made by script."""
import math

import bmesh
import bpy
from mathutils import Matrix
from repeated import again
from scene_tools import box, join


def forget(*things):
    """Remove objects whose meshes only served for linked duplicates."""
    for thing in things:
        bpy.data.objects.remove(thing)


def plant_again(parts, name, location, turn=0.0, scale=1.0):
    """A linked duplicate of both parts of a plant."""
    for part, kind in zip(parts, ("pot", "leaves")):
        again(part, f"{name} {kind}", location, turn, scale)


def turned_solid(name, profile, material, segments=32):
    """A solid of revolution about z; profile: (radius, z) from its lower to its upper end."""
    solid = bmesh.new()
    rings = [[solid.verts.new((r * math.cos(k * math.tau / segments), r * math.sin(k * math.tau / segments), z))
              for k in range(segments)] for r, z in profile]
    for low, high in zip(rings, rings[1:]):
        for k in range(segments):
            face = solid.faces.new((low[k], low[(k + 1) % segments], high[(k + 1) % segments], high[k]))
            face.smooth = True
    solid.faces.new(rings[0][::-1])
    solid.faces.new(rings[-1])
    mesh = bpy.data.meshes.new(name)
    solid.to_mesh(mesh)
    solid.free()
    mesh.uv_layers.new()
    mesh.materials.append(material)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing


def disk(name, radius, z, material, segments=64):
    """A round face that looks up, its image fitted around it."""
    rim = [(math.cos(k * math.tau / segments), math.sin(k * math.tau / segments)) for k in range(segments)]
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([(x * radius, y * radius, z) for x, y in rim], [], [range(segments)])
    for loop, (x, y) in zip(mesh.uv_layers.new().data, rim):
        loop.uv = (0.5 + x / 2, 0.5 + y / 2)
    mesh.materials.append(material)
    made = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(made)
    return made


def column(name, radius, height, material):
    """A round column with a square foot, and rings below and above its shaft."""
    shaft = turned_solid("shaft", [(radius * 1.22, 0.118), (radius * 1.25, 0.16), (radius * 1.18, 0.2),
                                   (radius, 0.24), (radius * 0.92, height - 0.34), (radius, height - 0.3),
                                   (radius * 1.25, height - 0.2), (radius * 1.28, height - 0.12),
                                   (radius * 1.28, height - 0.09)], material, 40)
    wide = radius * 1.4
    return join(name, [shaft, box("foot", (-wide, -wide, 0), (wide, wide, 0.12), material),
                       box("head", (-wide, -wide, height - 0.1), (wide, wide, height), material)])


def globe(name, location, sea, wood, brass, radius=0.27):
    """A standing globe in a wooden ring on a turned foot, its axis tilted by 23 degrees."""
    middle = 0.86
    ball = bmesh.new()
    bmesh.ops.create_uvsphere(ball, u_segments=96, v_segments=48, radius=radius, calc_uvs=True)
    mesh = bpy.data.meshes.new("ball")
    uv = ball.loops.layers.uv.verify()
    for face in ball.faces:
        face.smooth = True
        angles = [math.atan2(loop.vert.co.y, loop.vert.co.x) / math.tau % 1 for loop in face.loops]
        angles = [a + 1 if max(angles) - a > 0.5 else a for a in angles]
        for loop, angle in zip(face.loops, angles):
            loop[uv].uv = (angle, 0.5 + math.asin(max(-1, min(1, loop.vert.co.z / radius))) / math.pi)
    ball.to_mesh(mesh)
    ball.free()
    mesh.materials.append(sea)
    earth = bpy.data.objects.new("ball", mesh)
    bpy.context.collection.objects.link(earth)
    tilt = Matrix.Translation((0, 0, middle)) @ Matrix.Rotation(math.radians(23), 4, "X")
    mesh.transform(tilt)
    ring = hoop("horizon", radius + 0.03, radius + 0.085, 0.03, wood)
    ring.data.transform(Matrix.Translation((0, 0, middle)))
    meridian = hoop("meridian", radius + 0.008, radius + 0.026, 0.012, brass)
    meridian.data.transform(tilt @ Matrix.Rotation(math.pi / 2, 4, "X") @ Matrix.Rotation(0.1, 4, "Z"))
    foot = turned_solid("foot", [(0.05, 0.1), (0.06, 0.14), (0.03, 0.2), (0.035, 0.34), (0.05, 0.42), (0.03, 0.47),
                                 (0.026, middle - radius - 0.027)], wood)
    parts = [earth, ring, meridian, foot]
    for k in range(3):
        leg = box("leg", (0.03, -0.02, 0), (0.30, 0.02, 0.11), wood)
        for vertex in leg.data.vertices:
            if vertex.co.x > 0.2:
                vertex.co.z *= 0.45
        leg.data.transform(Matrix.Rotation(k * math.tau / 3 + 0.4, 4, "Z"))
        post = box("post", (radius + 0.045, -0.012, 0.02), (radius + 0.07, 0.012, middle - 0.013), wood)
        post.data.transform(Matrix.Rotation(k * math.tau / 3 + 0.4, 4, "Z"))
        parts += [leg, post]
    made = join(name, parts)
    made.location = location
    return made


def hoop(name, inner, outer, thick, material, segments=64):
    """A flat ring about z, centred."""
    ring = bmesh.new()
    edges = []
    for k in range(segments):
        x, y = math.cos(k * math.tau / segments), math.sin(k * math.tau / segments)
        edges.append([ring.verts.new((r * x, r * y, z)) for r, z in ((inner, -thick / 2), (outer, -thick / 2),
                                                                     (outer, thick / 2), (inner, thick / 2))])
    for low, high in zip(edges, edges[1:] + edges[:1]):
        for i in range(4):
            ring.faces.new((low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i])[::-1])
    bmesh.ops.recalc_face_normals(ring, faces=ring.faces)
    mesh = bpy.data.meshes.new(name)
    ring.to_mesh(mesh)
    ring.free()
    mesh.uv_layers.new()
    mesh.materials.append(material)
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(thing)
    return thing
