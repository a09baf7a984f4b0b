"""Every difference between Blender 3.4 and 5.2 that the add-on meets: nothing else asks which version it runs on.

What a version has is asked of the data itself, so that releases in between need no entry here.
"""

import math

import bpy
import numpy as np

# Principled BSDF inputs that 4.0 renamed: new name -> old name.
_OLD_SOCKETS = {
    "Subsurface Weight": "Subsurface",
    "Transmission Weight": "Transmission",
    "Coat Weight": "Clearcoat",
    "Sheen Weight": "Sheen",
    "Emission Color": "Emission",
}


def socket_named(node, name: str):
    """A node's input by its newest name; None when the version has none."""
    return node.inputs.get(name) or node.inputs.get(_OLD_SOCKETS.get(name, name))


def node_tree(block):
    """The node tree that a material, world or light is rendered with, or None. From 5.0 on, use_nodes is always on."""
    if bpy.app.version < (5, 0, 0) and not block.use_nodes:
        return None
    return block.node_tree


def casts_shadow(light) -> bool:
    """Cycles had a switch of its own up to 4.1."""
    return getattr(getattr(light, "cycles", None), "cast_shadow", light.use_shadow)


def has_soft_falloff(light) -> bool:
    """Whether a point or spot lamp is a disk that faces every receiver; before Blender 4.1 it always is."""
    return getattr(light, "use_soft_falloff", True)


def light_factor(light, area: float) -> tuple[float, float, float]:
    """What a lamp's power is multiplied by to have the library's units: those of Cycles 3.4, but an exact sun.

    Since 4.5 lamps have exposure, temperature, and a switch (off) for power by `area`, see export.light.area().
    """
    scale = 2.0 ** getattr(light, "exposure", 0.0)
    if not getattr(light, "normalize", True):
        scale *= area
    if light.type == "AREA" and bpy.app.version >= (4, 0, 0):
        scale *= 4 / math.pi  # radiance is power / (pi area); power / (4 area) before
    if light.type == "SUN" and bpy.app.version < (4, 0, 0):
        cosine = math.cos(light.angle / 2)
        scale *= 2 * cosine / (1 + cosine)  # the mean cosine over a flat disk at distance 1 that covers the sun
    warm = light.temperature_color if getattr(light, "use_temperature", False) else (1.0, 1.0, 1.0)
    return tuple(scale * channel for channel in warm)


def write_pixels(render_pass, pixels: np.ndarray) -> None:
    """Copies float32 (height, width, channels) into a RenderPass of the same size, bottom row first.

    Up to 3.6 `rect` takes (pixels, channels), and reads a flat array out of bounds; later it takes only the flat one.
    """
    pixels = np.ascontiguousarray(pixels, np.float32)
    flat = bpy.app.version >= (4, 0, 0)
    render_pass.rect.foreach_set(pixels.ravel() if flat else pixels.reshape(-1, pixels.shape[-1]))


def hides_shader_nodes() -> bool:
    """Whether the shader editor's Add menu shows shaders only to engines that it knows by name."""
    return bpy.app.version < (4, 0, 0)


def _read(collection, name: str, dtype, width: int = 1) -> np.ndarray:
    """One property of a whole collection; dtype must be Blender's own, another one is up to 400 times slower."""
    values = np.empty(len(collection) * width, dtype)
    collection.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def _attribute(mesh, name: str):
    """The attribute's data, or None."""
    attribute = mesh.attributes.get(name)
    return attribute.data if attribute is not None else None


def positions(mesh) -> np.ndarray:
    """float32 (vertices, 3)."""
    data = _attribute(mesh, "position")
    return _read(mesh.vertices, "co", np.float32, 3) if data is None else _read(data, "vector", np.float32, 3)


def corner_vertices(mesh) -> np.ndarray:
    """Vertex of each corner, uint32."""
    data = _attribute(mesh, ".corner_vert")
    if data is None:
        return _read(mesh.loops, "vertex_index", np.uint32)
    return _read(data, "value", np.int32).view(np.uint32)


def triangle_polygons(mesh) -> np.ndarray:
    """Polygon of each triangle; needs calc_loop_triangles()."""
    if hasattr(mesh, "loop_triangle_polygons"):
        return _read(mesh.loop_triangle_polygons, "value", np.int32)
    return _read(mesh.loop_triangles, "polygon_index", np.uint32)


def material_indices(mesh) -> np.ndarray | None:
    """Material slot of each polygon, int32; None when all are 0."""
    data = _attribute(mesh, "material_index")
    return None if data is None else _read(data, "value", np.int32)


def render_uvs(mesh) -> tuple[str, np.ndarray | None]:
    """The UV map that is active for rendering: its name, and float32 (corners, 2); ("", None) when there is none."""
    layer = next((layer for layer in mesh.uv_layers if layer.active_render), None)
    if layer is None:
        return "", None
    if hasattr(layer, "uv"):
        return layer.name, _read(layer.uv, "vector", np.float32, 2)
    return layer.name, _read(layer.data, "uv", np.float32, 2)


def corner_normals(mesh, vertices: np.ndarray) -> np.ndarray | None:
    """Shading normal of each corner, float32 (corners, 3); None when the whole mesh is flat.

    `vertices` are corner_vertices(mesh).
    """
    if hasattr(mesh, "corner_normals"):  # 4.1
        if mesh.normals_domain == "FACE":
            return None
        return _read(mesh.corner_normals, "vector", np.float32, 3)
    smooth = _read(mesh.polygons, "use_smooth", bool)
    if mesh.use_auto_smooth and (mesh.has_custom_normals or smooth.any()):
        mesh.calc_normals_split()  # slow, and needed only for sharp edges and custom normals
        return _read(mesh.loops, "normal", np.float32, 3)
    if not smooth.any():
        return None
    normals = _read(mesh.vertex_normals, "vector", np.float32, 3)[vertices]
    if not smooth.all():
        polygons = np.repeat(np.arange(len(smooth)), _read(mesh.polygons, "loop_total", np.int32))
        flat = ~smooth[polygons]
        normals[flat] = _read(mesh.polygon_normals, "vector", np.float32, 3)[polygons[flat]]
    return normals
