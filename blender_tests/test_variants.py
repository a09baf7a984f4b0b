"""What scenes/constant, scenes/robustness and scenes/reevaluations make and compute."""

import bpy
import numpy as np
import pytest
from building import add, lamp, link, material, quad, surface
from constant_light import make_constant
from curves import curve, ratios
from mathutils import Vector
from pictures import render_pixels
from subdivided import corner_normals, divide

IMAGE_BYTE, IMAGE_LINEAR = 188 / 255, 0.502886  # sRGB


def image_texture(tree):
    """An Image Texture node with an image of one grey."""
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = bpy.data.images.new("grey", 4, 4)
    node.image.pixels.foreach_set(np.tile(np.float32([IMAGE_BYTE] * 3 + [1]), 16))
    return node


def kinds_of_material():
    """[(material or None, colour that it has in constant light)]."""
    plain = material("plain", (0.1, 0.4, 0.7))
    textured = material("textured")
    principled = add(textured.node_tree, "ShaderNodeBsdfPrincipled")
    textured.node_tree.links.new(image_texture(textured.node_tree).outputs[0], principled.inputs["Base Color"])
    surface(textured.node_tree, principled)
    lit = material("lit")
    both = add(lit.node_tree, "ShaderNodeAddShader")
    parts = (
        add(lit.node_tree, "ShaderNodeBsdfDiffuse", Color=(0.3, 0.2, 0.1, 1)),
        add(lit.node_tree, "ShaderNodeEmission", Strength=7.0),
    )
    for socket, part in zip(both.inputs, parts, strict=True):
        lit.node_tree.links.new(part.outputs[0], socket)
    surface(lit.node_tree, both)
    glowing = material("glowing")
    surface(glowing.node_tree, add(glowing.node_tree, "ShaderNodeEmission", Color=(0.2, 0.4, 0.6, 1), Strength=30.0))
    bare = bpy.data.materials.new("bare")
    bare.diffuse_color = (0.6, 0.5, 0.4, 1)
    return [
        (plain, (0.1, 0.4, 0.7)),
        (textured, (IMAGE_LINEAR,) * 3),
        (lit, (0.3, 0.2, 0.1)),
        (glowing, (1, 1, 1)),
        (bare, (0.6, 0.5, 0.4)),
        (None, (0.8, 0.8, 0.8)),
    ]


@pytest.mark.parametrize("engine", ["GRIDGATHER", "CYCLES"])
def test_constant_light_shows_the_colours_of_materials(scene, engine):
    kinds = kinds_of_material()
    for place, (kind, _) in enumerate(kinds):
        mesh = quad(f"Quad {place}")
        mesh.uv_layers.new()
        if kind:
            mesh.materials.append(kind)
        link(mesh, location=(2 * place, 0, 0))
    lamp("POINT").location = (0, 0, 2)
    scene.world = bpy.data.worlds.new("sky")
    scene.world.color = (1, 1, 1)
    scene.camera.location.x = len(kinds) - 1
    scene.camera.data.type, scene.camera.data.ortho_scale = "ORTHO", 2 * len(kinds)
    scene.render.resolution_x, scene.render.resolution_y = 8 * len(kinds), 24
    scene.cycles.device, scene.cycles.samples, scene.cycles.use_denoising = "CPU", 4, False
    make_constant(scene)
    pixels = render_pixels(scene, engine)
    for place, (_, colour) in enumerate(kinds):
        assert pixels[12, 8 * place + 4, :3] == pytest.approx(colour, rel=1e-4), kinds[place][0]
    assert pixels[1, :, :3] == pytest.approx(0, abs=1e-6), "the world is not black"


def test_subdivided_meshes_keep_their_shape(scene):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=12, ring_count=8)
    mesh = bpy.context.object.data
    mesh.polygons.foreach_set("use_smooth", np.arange(len(mesh.polygons)) % 3 > 0)
    mesh.polygons.foreach_set("material_index", np.arange(len(mesh.polygons)) % 2)
    mesh.use_auto_smooth = True
    mesh.normals_split_custom_set_from_vertices(
        [(vertex.co + Vector((0, 0.3, 0))).normalized() for vertex in mesh.vertices]
    )
    before, normals = totals(mesh), normals_by_place(mesh)
    divide(mesh)
    after = totals(mesh)
    assert after.pop("triangles") == 4 * before.pop("triangles")
    for what, value in before.items():
        assert after[what] == pytest.approx(value, rel=1e-4), what
    found = normals_by_place(mesh)
    for place, kept in normals.items():
        for normal in kept:
            assert np.abs(np.array(found[place]) - normal).max(axis=1).min() < 2e-3, place


def totals(mesh):
    """Sums over a mesh by material."""
    mesh.calc_loop_triangles()
    uvs = np.array([corner.uv[:] for corner in mesh.uv_layers.active.data])
    sums = {"triangles": len(mesh.loop_triangles), "area": 0, "texture": 0, "first material": 0, "flat": 0}
    for triangle in mesh.loop_triangles:
        a, b, c = uvs[list(triangle.loops)]
        polygon = mesh.polygons[triangle.polygon_index]
        sums["area"] += triangle.area
        sums["texture"] += abs(np.cross(b - a, c - a)) / 2
        sums["first material"] += triangle.area * (polygon.material_index == 0)
        sums["flat"] += triangle.area * (not polygon.use_smooth)
    return sums


def normals_by_place(mesh):
    """{rounded position: normals of the corners there}."""
    found = {}
    for loop, normal in zip(mesh.loops, corner_normals(mesh), strict=True):
        found.setdefault(tuple(round(x, 3) + 0.0 for x in mesh.vertices[loop.vertex_index].co), []).append(normal)
    return found


def test_curves_leave_out_what_a_cheaper_render_is_as_right_as():
    assert curve([(1, 0.5), (4, 0.25), (3, 0.6), (5, 0.25)]) == [(0.25, 4), (0.5, 1)]


def test_curves_are_compared_between_the_ends_that_both_have():
    ours = curve([(error**-2, error) for error in (0.05, 0.1, 0.2, 0.4)])
    others = curve([(5 * error**-2, error) for error in (0.04, 0.3)])
    found = ratios(ours, others)
    assert [error for error, _ in found] == pytest.approx([0.05, (0.05 * 0.3) ** 0.5, 0.3], rel=1e-3)
    assert [ratio for _, ratio in found] == pytest.approx([0.2] * 3)
    assert ratios(ours, [(0.01, 9), (0.02, 3)]) == []
