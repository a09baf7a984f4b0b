"""Arrays of a mesh: positions, triangles, normals, texture coordinates."""

import bpy
import numpy as np
import pytest
from building import link, operator_object, quad
from capture import export


def only_mesh():
    (mesh,) = export().scene.meshes
    return mesh


def test_triangles_are_blenders_in_types_of_the_interface():
    link(quad(size=2))
    mesh = only_mesh()
    assert mesh.positions.dtype == np.float32 and mesh.triangle_vertices.dtype == np.uint32
    assert mesh.positions.tolist() == [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
    corners = mesh.positions[mesh.triangle_vertices]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    assert normals.tolist() == [[0, 0, 4], [0, 0, 4]]
    assert mesh.triangle_slots is None


def test_flat_mesh_without_uvs_has_no_corners():
    link(quad())
    mesh = only_mesh()
    assert mesh.corner_count == 0
    assert mesh.triangle_corners is None and mesh.corner_normals is None and mesh.corner_uvs is None


def cube(smooth_faces):
    thing = operator_object(bpy.ops.mesh.primitive_cube_add)
    while thing.data.uv_layers:
        thing.data.uv_layers.remove(thing.data.uv_layers[0])
    for polygon in thing.data.polygons:
        polygon.use_smooth = polygon.index in smooth_faces
    return thing


def normals_at_triangles(mesh):
    return mesh.corner_normals[mesh.triangle_corners].reshape(-1, 3), mesh.positions[mesh.triangle_vertices].reshape(
        -1, 3
    )


def test_smooth_normals_point_along_the_diagonals_of_a_cube():
    cube(range(6))
    normals, positions = normals_at_triangles(only_mesh())
    assert normals == pytest.approx(positions / np.sqrt(3), abs=1e-4)


def test_flat_faces_of_a_mixed_mesh_keep_their_own_normals():
    thing = cube([0])
    mesh = only_mesh()
    face_normals = [polygon.normal for polygon in thing.data.polygons]
    spreads = hasattr(thing.data, "use_auto_smooth")  # since 4.1 flat neighbours make the edges of a smooth face sharp
    for corner in range(mesh.corner_count):
        face = corner // 4
        if face == 0 and spreads:
            assert abs(mesh.corner_normals[corner]) == pytest.approx([3**-0.5] * 3, abs=1e-4)
        else:
            assert mesh.corner_normals[corner] == pytest.approx(face_normals[face], abs=1e-4)


def test_sharp_angles_split_normals():
    thing = operator_object(bpy.ops.mesh.primitive_cylinder_add, vertices=64)
    if hasattr(thing.data, "use_auto_smooth"):
        bpy.ops.object.shade_smooth(use_auto_smooth=True, auto_smooth_angle=0.5)
    else:
        bpy.ops.object.shade_smooth_by_angle(angle=0.5)
    normals, positions = normals_at_triangles(only_mesh())
    is_cap = abs(normals[:, 2]) > 0.5
    assert abs(normals[is_cap]) == pytest.approx(np.tile([0, 0, 1], (is_cap.sum(), 1)), abs=1e-3)
    side = positions[~is_cap] * [1, 1, 0]
    assert normals[~is_cap] == pytest.approx(side, abs=2e-3)


def test_custom_normals_are_kept():
    thing = cube(range(6))
    if hasattr(thing.data, "use_auto_smooth"):
        thing.data.use_auto_smooth = True
    wanted = np.tile([0.6, 0.0, 0.8], (24, 1))
    thing.data.normals_split_custom_set(wanted)
    assert only_mesh().corner_normals == pytest.approx(wanted, abs=1e-3)


def test_uvs_are_those_of_the_map_active_for_rendering():
    mesh = quad()
    for name, offset in (("First", 0.0), ("Second", 0.25)):
        layer = mesh.uv_layers.new(name=name)
        for index, uv in enumerate([(0, 0), (1, 0), (1, 1), (0, 1)]):
            layer.data[index].uv = (uv[0] + offset, uv[1])
    mesh.uv_layers["Second"].active_render = True
    mesh.uv_layers.active = mesh.uv_layers["First"]
    link(mesh)
    exported = only_mesh()
    assert exported.uv_name == "Second" and exported.corner_count == 4
    uvs = exported.corner_uvs[exported.triangle_corners]
    positions = exported.positions[exported.triangle_vertices]
    assert uvs == pytest.approx((positions[..., :2] + 1) / 2 + [0.25, 0], abs=1e-6)


def test_slots_follow_polygons_through_triangulation():
    mesh = bpy.data.meshes.new("Mixed")
    pentagon = [(np.cos(a), np.sin(a), 0) for a in np.arange(5) * 2 * np.pi / 5]
    mesh.from_pydata([*pentagon, (3, 0, 0), (4, 0, 0), (3, 1, 0)], [], [(0, 1, 2, 3, 4), (5, 6, 7)])
    mesh.polygons[1].material_index = 2
    link(mesh)
    assert only_mesh().triangle_slots.tolist() == [0, 0, 0, 2]
