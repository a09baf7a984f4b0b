"""A scene with four times the triangles and the same shape: blender -b SCENE.blend --python subdivided.py -- OUT.blend

Every triangle of a mesh is divided at the middles of its edges. Normals, texture coordinates and materials stay.
"""
import math
import sys

import bpy
import numpy as np

QUARTERS = ((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5))  # of corners 0 to 2 and the middles of 0-1, 1-2, 2-0


def read(things, name, kind, columns):
    """An attribute of all things as an array of rows."""
    values = np.empty((len(things), columns), kind)
    things.foreach_get(name, values.ravel())
    return values


def with_middles(corners):
    """(triangles, 3, n) values at corners to (triangles, 6, n): the middles of the edges are their means."""
    return np.concatenate([corners, (corners + np.roll(corners, -1, 1)) / 2], 1)


def quartered(values):
    """(triangles, 6, n) values to rows, three for each quarter."""
    return values[:, QUARTERS].reshape(-1, values.shape[2])


def corner_normals(mesh):
    """Of every corner; None where all faces are flat and have no normals of their own."""
    if not mesh.has_custom_normals and not read(mesh.polygons, "use_smooth", bool, 1).any():
        return None
    if not mesh.use_auto_smooth:
        mesh.use_auto_smooth, mesh.auto_smooth_angle = True, math.pi
    mesh.calc_normals_split()
    return read(mesh.loops, "normal", np.float32, 3)


def divide(mesh):
    """Divide every triangle of a mesh into four."""
    mesh.calc_loop_triangles()
    if not mesh.loop_triangles:
        return
    corners = read(mesh.loop_triangles, "loops", np.int32, 3)
    polygons = np.repeat(read(mesh.loop_triangles, "polygon_index", np.int32, 1)[:, 0], 4)
    vertices = read(mesh.loop_triangles, "vertices", np.int32, 3)
    positions = read(mesh.vertices, "co", np.float32, 3)
    edges, middles = np.unique(np.sort(np.stack([vertices, np.roll(vertices, -1, 1)], 2), 2).reshape(-1, 2), axis=0,
                               return_inverse=True)
    six = np.concatenate([vertices, len(positions) + middles.reshape(-1, 3)], 1)
    positions = np.concatenate([positions, positions[edges].mean(1)])
    smooth, slots = (read(mesh.polygons, name, kind, 1)[polygons, 0]
                     for name, kind in (("use_smooth", bool), ("material_index", np.int32)))
    uvs = [(layer.name, layer.active_render, quartered(with_middles(read(layer.data, "uv", np.float32, 2)[corners])))
           for layer in mesh.uv_layers]
    normals = corner_normals(mesh)
    if normals is not None:
        normals = quartered(with_middles(normals[corners]))
    fill(mesh, positions, quartered(six[..., None])[:, 0])
    mesh.polygons.foreach_set("use_smooth", smooth)
    mesh.polygons.foreach_set("material_index", slots)
    for name, rendered, values in uvs:
        layer = mesh.uv_layers.new(name=name)
        layer.active_render = rendered
        layer.data.foreach_set("uv", values.ravel())
    mesh.update(calc_edges=True)
    if normals is not None:
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set(normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-20))


def fill(mesh, positions, corners):
    """Make a mesh of triangles. corners: vertices, three for each."""
    mesh.clear_geometry()
    mesh.vertices.add(len(positions))
    mesh.vertices.foreach_set("co", positions.ravel())
    mesh.loops.add(len(corners))
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.add(len(corners) // 3)
    mesh.polygons.foreach_set("loop_start", np.arange(0, len(corners), 3, dtype=np.int32))
    mesh.polygons.foreach_set("loop_total", np.full(len(corners) // 3, 3, np.int32))


if __name__ == "__main__":
    for mesh in bpy.data.meshes:
        divide(mesh)
    bpy.ops.wm.save_as_mainfile(filepath=sys.argv[sys.argv.index("--") + 1], compress=True)
