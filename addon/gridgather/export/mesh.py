"""An evaluated mesh to arrays: bulk reads only, each in the type that Blender keeps."""

import numpy as np

from .. import compat, description


def export_mesh(mesh) -> description.Mesh | None:
    """Arrays of a bpy Mesh, copied; None when it has no triangles."""
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    if count == 0:
        return None
    corners = np.empty((count, 3), np.uint32)
    mesh.loop_triangles.foreach_get("loops", corners.ravel())
    corner_vertices = compat.corner_vertices(mesh)
    result = description.Mesh(
        name=mesh.name,
        positions=compat.positions(mesh),
        triangle_vertices=corner_vertices[corners],
        triangle_slots=_slots(mesh),
    )
    result.corner_normals = compat.corner_normals(mesh, corner_vertices)
    result.uv_name, result.corner_uvs = compat.render_uvs(mesh)
    if result.corner_normals is not None or result.corner_uvs is not None:
        result.corner_count = len(corner_vertices)
        result.triangle_corners = corners
    return result


def _slots(mesh) -> np.ndarray | None:
    """Material slot per triangle; None when all are 0."""
    indices = compat.material_indices(mesh)
    if indices is None or not indices.any():
        return None
    return indices[compat.triangle_polygons(mesh)].astype(np.uint32)
