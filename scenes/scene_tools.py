"""What the scene scripts share: each of them builds its scene from nothing.

Units: metres, watts, degrees. Colours are scene-linear RGB reflectances, kept within LOWEST..HIGHEST albedo.
Every material is purely diffuse (Diffuse BSDF, Emission, or their sum).
"""
import math
import sys
import tempfile
import zipfile
from pathlib import Path

import bmesh
import bpy
import numpy as np
from mathutils import Matrix, Vector

LOWEST, HIGHEST = 0.02, 0.85
FURNITURE = Path("/usr/share/sweethome3d/furniture")  # Debian package sweethome3d-furniture


def reset(width, height, view_transform="Standard"):
    """An empty scene with a black world, for a picture of width x height pixels."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.world = bpy.data.worlds.new("World")
    scene.world.color = (0, 0, 0)
    picture(width, height, view_transform)


def picture(width, height, view_transform):
    """Size of the picture and how it is shown; no dither, so that tests may compare pixels."""
    scene = bpy.context.scene
    scene.render.resolution_x, scene.render.resolution_y = width, height
    scene.render.resolution_percentage = 100
    scene.render.dither_intensity = 0
    scene.view_settings.view_transform = view_transform


def save():
    """Save the scene, images packed, to the path given after `--`."""
    path = Path(sys.argv[sys.argv.index("--") + 1]).absolute()
    path.parent.mkdir(parents=True, exist_ok=True)
    bpy.ops.wm.save_as_mainfile(filepath=str(path), compress=True)


def image(name, srgb):
    """A packed 8-bit image from an array (height, width, 3), sRGB-encoded 0..1, first row at the bottom."""
    height, width, _ = srgb.shape
    made = bpy.data.images.new(name, width, height)
    write_pixels(made, srgb)
    return made


def write_pixels(target, srgb):
    """Replace an image's pixels, clipped to the permitted albedos, and pack it into the file."""
    low, high = srgb_encoded(LOWEST), srgb_encoded(HIGHEST)
    rgba = np.ones(srgb.shape[:2] + (4,), np.float32)
    rgba[..., :3] = np.clip(srgb, low, high)
    target.pixels.foreach_set(rgba.ravel())
    target.update()
    target.pack()


def srgb_encoded(value):
    """The sRGB curve for a scene-linear value in 0..1."""
    return 12.92 * value if value <= 0.0031308 else 1.055 * value ** (1 / 2.4) - 0.055


def diffuse(name, colour, emission=None):
    """A Lambertian material. colour: RGB or an image; emission: radiance RGB in W/m2/sr that it emits besides."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    surface = nodes.new("ShaderNodeBsdfDiffuse")
    if isinstance(colour, bpy.types.Image):
        texture = nodes.new("ShaderNodeTexImage")
        texture.image = colour
        links.new(texture.outputs["Color"], surface.inputs["Color"])
    else:
        colour = tuple(min(max(c, LOWEST), HIGHEST) for c in colour[:3])
        surface.inputs["Color"].default_value = (*colour, 1)
    material.diffuse_color = (0.5, 0.5, 0.5, 1) if isinstance(colour, bpy.types.Image) else (*colour, 1)
    if emission is not None:
        reflection, surface = surface, nodes.new("ShaderNodeAddShader")
        links.new(reflection.outputs[0], surface.inputs[0])
        links.new(emission_node(nodes, emission).outputs[0], surface.inputs[1])
    links.new(surface.outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def emitter(name, radiance):
    """A material that only emits: radiance RGB in W/m2/sr."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    links.new(emission_node(nodes, radiance).outputs[0], nodes.new("ShaderNodeOutputMaterial").inputs["Surface"])
    return material


def emission_node(nodes, radiance):
    node = nodes.new("ShaderNodeEmission")
    strength = max(radiance)
    node.inputs["Strength"].default_value = strength
    node.inputs["Color"].default_value = (*(c / strength for c in radiance), 1)
    return node


def add_mesh(name, vertices, faces, material, tile=1.0):
    """An object from quads. UV: each face's own edges, measured in tiles of `tile` metres."""
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(v) for v in vertices], [], faces)
    layer = mesh.uv_layers.new()
    for polygon in mesh.polygons:
        a, b, c, _ = (mesh.vertices[v].co for v in polygon.vertices)
        width, height = (b - a).length / tile, (c - b).length / tile
        for loop, uv in zip(polygon.loop_indices, ((0, 0), (width, 0), (width, height), (0, height))):
            layer.data[loop].uv = uv
    mesh.materials.append(material)
    added = bpy.data.objects.new(name, mesh)
    bpy.context.collection.objects.link(added)
    return added


def quads(name, corners, material, tile=1.0):
    """One object of separate quads; corners: (a, b, c, d) each, counter-clockwise seen from outside."""
    vertices = [corner for quad in corners for corner in quad]
    return add_mesh(name, vertices, [tuple(range(i, i + 4)) for i in range(0, len(vertices), 4)], material, tile)


def box(name, low, high, material, tile=1.0, turn=0.0):
    """A box between two corners, turned about the vertical through its centre."""
    low, high = Vector(low), Vector(high)
    centre, half = (low + high) / 2, (high - low) / 2
    vertices = [Vector((x, y, z)) * half for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    added = add_mesh(name, vertices, faces, material, tile)
    added.data.transform(Matrix.Translation(centre) @ Matrix.Rotation(math.radians(turn), 4, "Z"))
    return added


def join(name, objects):
    """Make one object of several; it keeps their materials."""
    bpy.ops.object.select_all(action="DESELECT")
    for part in objects:
        part.select_set(True)
    bpy.context.view_layer.objects.active = objects[0]
    if len(objects) > 1:
        bpy.ops.object.join()
    objects[0].name = objects[0].data.name = name
    return objects[0]


def area_light(name, location, direction, width, height, watts, colour=(1, 1, 1), shape="RECTANGLE"):
    """An area light (or an ellipse, a disk) that shines along `direction`."""
    data = bpy.data.lights.new(name, "AREA")
    data.shape, data.size, data.size_y = shape, width, height
    return place_light(name, data, location, watts, colour, direction)


def point_light(name, location, radius, watts, colour=(1, 1, 1)):
    data = bpy.data.lights.new(name, "POINT")
    data.shadow_soft_size = radius
    return place_light(name, data, location, watts, colour, (0, 0, -1))


def place_light(name, data, location, watts, colour, direction):
    data.energy, data.color = watts, colour
    added = bpy.data.objects.new(name, data)
    added.location = location
    added.rotation_euler = Vector(direction).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(added)
    return added


def camera(location, target, degrees):
    """The scene's camera; degrees: angle of view along the longer side of the picture."""
    data = bpy.data.cameras.new("Camera")
    data.angle = math.radians(degrees)
    added = bpy.data.objects.new("Camera", data)
    added.location = location
    added.rotation_euler = (Vector(target) - Vector(location)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(added)
    bpy.context.scene.camera = added


def furniture(name, archive, model, location, turn=0.0, scale=1.0, colours=None, without=()):
    """A model of the furniture archives as one object, its lowest point's height and its middle at `location`.

    archive: CC-0 or CC-BY (the Blend Swap archives); turn: degrees, at 0 the front looks along -y;
    scale: of the model's own size; colours: {material name: RGB} instead of the model's; without: material names whose
    faces are left out.
    """
    before = set(bpy.data.objects)
    with tempfile.TemporaryDirectory() as folder:
        with zipfile.ZipFile(FURNITURE / f"BlendSwap-{archive}.sh3f") as models:
            prefix = f"blendswap-{archive.lower()}/{model}/"
            models.extractall(folder, [entry for entry in models.namelist() if entry.startswith(prefix)])
        bpy.ops.wm.obj_import(filepath=f"{folder}/{prefix}{model}.obj")
        parts = sorted((o for o in bpy.data.objects if o not in before and o.type == "MESH"), key=lambda o: o.name)
        replacement = {}
        for part in parts:
            part.data.transform(part.matrix_world)
            part.matrix_world = Matrix()
            remove_faces(part, without)
            for slot in part.material_slots:
                old = slot.material
                if old not in replacement:
                    replacement[old] = imported_material(f"{name} {old.name}", old, (colours or {}).get(old.name))
                slot.material = replacement[old]
            part.data.validate()  # some models have faces that use a vertex twice, on which path tracers crash
    for old in replacement:
        bpy.data.materials.remove(old)
    for empty in [part for part in parts if not part.data.polygons]:
        parts.remove(empty)
        bpy.data.objects.remove(empty)
    made = join(name, parts)
    remove_doubles(made)
    low, high = extent(made)
    to_middle = Matrix.Translation((-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -low[2]))
    made.data.transform(Matrix.Scale(scale / 100, 4) @ to_middle)
    made.location = location
    made.rotation_euler = (0, 0, math.radians(turn))
    return made


def extent(thing):
    """Lowest and highest x, y, z of an object's own vertices."""
    points = np.empty(3 * len(thing.data.vertices), np.float32)
    thing.data.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3).astype(float)
    return points.min(0), points.max(0)


def imported_material(name, material, colour):
    """The diffuse part of an imported material: `colour` if given, else its image, else its own colour."""
    base = next(n for n in material.node_tree.nodes if n.type == "BSDF_PRINCIPLED").inputs["Base Color"]
    if colour is not None or not base.is_linked:
        return diffuse(name, colour or base.default_value)
    picture_of = base.links[0].from_node.image
    if picture_of.packed_file is None:
        pixels = np.empty(picture_of.size[0] * picture_of.size[1] * 4, np.float32)
        picture_of.pixels.foreach_get(pixels)
        write_pixels(picture_of, pixels.reshape(picture_of.size[1], picture_of.size[0], 4)[..., :3])
    return diffuse(name, picture_of)


def remove_doubles(thing):
    """Delete faces that lie on another face of the object: models made for one-sided games have leaves twice, whose
    shadow on themselves is an accident of rounding in every renderer."""
    low, high = extent(thing)
    grain = 1e-5 * (high - low).max()
    edited = bmesh.new()
    edited.from_mesh(thing.data)
    place = [tuple(round(c / grain) for c in vertex.co) for vertex in edited.verts]
    seen, doomed = set(), []
    for face in edited.faces:
        corners = frozenset(place[vertex.index] for vertex in face.verts)
        if corners in seen:
            doomed.append(face)
        seen.add(corners)
    bmesh.ops.delete(edited, geom=doomed, context="FACES")
    edited.to_mesh(thing.data)
    edited.free()


def remove_faces(part, material_names):
    """Delete the faces of an object that have one of the named materials."""
    doomed = {i for i, slot in enumerate(part.material_slots) if slot.material.name in material_names}
    if not doomed:
        return
    edited = bmesh.new()
    edited.from_mesh(part.data)
    bmesh.ops.delete(edited, geom=[f for f in edited.faces if f.material_index in doomed], context="FACES")
    edited.to_mesh(part.data)
    edited.free()
