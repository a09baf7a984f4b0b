"""What happens to texture coordinates before an image is looked up."""

from mathutils import Matrix

from .nodes import constant, follow


def uv_map(socket, groups, reader) -> tuple[float, ...]:
    """The 2x3 matrix between the mesh's texture coordinates and an Image Texture node's Vector input.

    `reader` is told what is not understood (reader.unsupported) and which UV map is asked for (reader.uv_names).
    """
    matrix = _matrix(socket, groups, reader, True)
    return tuple(matrix[row][column] for row in range(2) for column in (0, 1, 3))


def _matrix(socket, groups, reader, is_texture: bool) -> Matrix:
    """4x4, applied to (u, v, 0)."""
    node, output, groups = follow(socket, groups)
    if node is None:
        return Matrix.Identity(4) if is_texture else Matrix.Scale(0.0, 4)
    if node.type == "UVMAP":
        if node.uv_map:
            reader.uv_names.add(node.uv_map)
        return Matrix.Identity(4)
    if node.type == "TEX_COORD" and output.name == "UV":
        return Matrix.Identity(4)
    if node.type == "MAPPING":
        return _mapping(node, groups, reader) @ _matrix(node.inputs["Vector"], groups, reader, False)
    reader.unsupported(node, "the active UV map is used", output)
    return Matrix.Identity(4)


def _mapping(node, groups, reader) -> Matrix:
    def vector(name, default):
        socket = node.inputs.get(name)
        if socket is None or not socket.enabled:
            return default
        value = constant(socket, groups)
        if value is None:
            reader.unsupported(node, f"its varying {name} is ignored")
            return default
        return value if isinstance(value, tuple) else (value,) * 3

    location, rotation, scale = (
        vector("Location", (0.0,) * 3),
        vector("Rotation", (0.0,) * 3),
        vector("Scale", (1.0,) * 3),
    )
    rotated = _euler(rotation)
    if node.vector_type == "TEXTURE":
        inverse = Matrix.Diagonal((*(1.0 / s if s else 0.0 for s in scale), 1.0))
        return inverse @ rotated.transposed() @ Matrix.Translation([-value for value in location])
    return Matrix.Translation(location) @ rotated @ Matrix.Diagonal((*scale, 1.0))


def _euler(rotation) -> Matrix:
    x, y, z = (Matrix.Rotation(angle, 4, axis) for angle, axis in zip(rotation, "XYZ", strict=True))
    return z @ y @ x
