"""Shader nodes to diffuse reflectance and emission."""

from ..compat import socket_named
from ..description import BLACK, NONE, Color
from .nodes import as_color, as_float, constant, follow, plain
from .uv_map import uv_map

_MAGENTA = Color((1.0, 0.0, 1.0))  # what Cycles shows for an image texture without an image
# Inputs of the Principled BSDF that take light from its diffuse part, and others that are left out when not zero.
_PRINCIPLED_TAKES = ("Metallic", "Transmission Weight")
_PRINCIPLED_LEFT_OUT = ("Subsurface Weight", "Sheen Weight", "Coat Weight")


class SurfaceReader:
    """Reads one node tree. What it cannot convert goes to `scene`'s messages under `name`.

    `images` is an ImageExport, or None where textures are not possible (lights, world).
    """

    def __init__(self, name: str, scene, images=None):
        self._name, self._scene, self._images = name, scene, images
        self.uv_names: set[str] = set()  # UV maps that are asked for by name

    def say(self, text: str) -> None:
        self._scene.say(self._name, text)

    def unsupported(self, node, instead: str, output=None) -> None:
        what = node.name if output is None else f"{node.name}'s {output.name}"
        self.say(f"node {what} ({node.type}) is not supported: {instead}")

    def shader(self, socket, groups=()) -> tuple[Color, Color]:
        """(reflectance, emission) of what is linked to a shader socket."""
        node, _, groups = follow(socket, groups)
        if node is None:
            return BLACK, BLACK
        return _READERS.get(node.type, SurfaceReader._nearest)(self, node, groups)

    def _bsdf_diffuse(self, node, groups):
        if self.number(node.inputs["Roughness"], groups, node) > 0:
            self.say(f"node {node.name}: Roughness is taken as 0")
        self._ignored(node, "Normal")
        return self.color(node.inputs["Color"], groups), BLACK

    def _emission(self, node, groups):
        strength = self.number(node.inputs["Strength"], groups, node)
        return BLACK, self.color(node.inputs["Color"], groups).scaled(strength)

    def _bsdf_principled(self, node, groups):
        diffuse = 1.0
        for name in _PRINCIPLED_TAKES + _PRINCIPLED_LEFT_OUT:
            amount = self.number(socket_named(node, name), groups, node)
            if amount > 0:
                self.say(f"node {node.name}: {name} {amount:.3g} is left out")
            if name in _PRINCIPLED_TAKES:
                diffuse *= 1.0 - min(max(amount, 0.0), 1.0)
        if constant(node.inputs["Alpha"], groups) != 1.0:
            self.say(f"node {node.name}: Alpha is taken as 1")
        self._ignored(node, "Normal")
        strength = self.number(node.inputs["Emission Strength"], groups, node)
        emission = BLACK
        if strength:
            emission = self.color(socket_named(node, "Emission Color"), groups).scaled(strength)
        return self.color(node.inputs["Base Color"], groups).scaled(diffuse), emission

    def _add_shader(self, node, groups):
        return self._sum(node, self.shader(node.inputs[0], groups), self.shader(node.inputs[1], groups))

    def _mix_shader(self, node, groups):
        factor = min(max(self.number(node.inputs[0], groups, node), 0.0), 1.0)
        for socket, weight in ((node.inputs[1], 1.0), (node.inputs[2], 0.0)):
            part, _, _ = follow(socket, groups)
            if part is not None and part.type == "BSDF_TRANSPARENT":
                self.unsupported(part, "the surface is opaque")
                factor = weight
        parts = []
        for socket, share in ((node.inputs[1], 1.0 - factor), (node.inputs[2], factor)):
            parts.append([color.scaled(share) for color in self.shader(socket, groups)] if share else (BLACK, BLACK))
        return self._sum(node, *parts)

    def _bsdf_transparent(self, node, groups):
        self.unsupported(node, "black is used")
        return BLACK, BLACK

    def _nearest(self, node, groups):
        socket = node.inputs.get("Color") or node.inputs.get("Base Color")
        if socket is None:
            self.unsupported(node, "black is used")
            return BLACK, BLACK
        self.unsupported(node, f"its {socket.name} is used as a diffuse colour")
        return self.color(socket, groups), BLACK

    def _sum(self, node, first, second):
        return tuple(self._sum_color(node, a, b) for a, b in zip(first, second, strict=True))

    def _sum_color(self, node, a: Color, b: Color) -> Color:
        if a.is_black or b.is_black:
            return b if a.is_black else a
        if (a.image, a.uv_map) == (b.image, b.uv_map):
            return Color(tuple(x + y for x, y in zip(a.factor, b.factor, strict=True)), a.image, a.uv_map)
        self.unsupported(node, "a sum with a texture keeps only the brighter part")
        return max(a, b, key=lambda color: sum(color.factor))

    def number(self, socket, groups, node) -> float:
        """A constant input; where something varying drives it, the socket's own value."""
        if socket is None:
            return 0.0
        value = constant(socket, groups)
        if value is None:
            self.say(f"node {node.name}: varying {socket.name} is taken as {socket.default_value:.3g}")
            value = float(socket.default_value)
        return as_float(value)

    def color(self, socket, groups=()) -> Color:
        """A colour input: constant, image, or image times constant; else the socket's own colour."""
        value = constant(socket, groups)
        if value is not None:
            return Color(as_color(value))
        node, output, inner = follow(socket, groups)
        if node.type == "TEX_IMAGE" and output.name == "Color" and self._images:
            return self._image(node, inner)
        product = self._product(node, inner)
        if product is not None:
            return product
        own = as_color(plain(socket.default_value)) if hasattr(socket, "default_value") else (0.8,) * 3
        self.unsupported(node, "the colour ({:.3g}, {:.3g}, {:.3g}) is used".format(*own), output)
        return Color(own)

    def _image(self, node, groups) -> Color:
        if node.projection != "FLAT":
            self.unsupported(node, "projection is taken as FLAT")
        index = self._images.index(node)
        if index == NONE:
            self.say(f"node {node.name} has no image: shown in magenta")
            return _MAGENTA
        return Color((1.0, 1.0, 1.0), index, uv_map(node.inputs["Vector"], groups, self))

    def _product(self, node, groups) -> Color | None:
        """A Mix node that multiplies a colour by a constant, else None."""
        if node.type not in {"MIX_RGB", "MIX"} or getattr(node, "blend_type", "") != "MULTIPLY":
            return None
        if getattr(node, "data_type", "RGBA") != "RGBA":
            return None
        factor, first, second = [socket for socket in node.inputs if socket.enabled][:3]
        tints = [constant(socket, groups) for socket in (factor, first, second)]
        if tints[0] is None or (tints[1] is None) == (tints[2] is None):
            return None
        amount = min(max(as_float(tints[0]), 0.0), 1.0)
        if tints[1] is None:
            return self.color(first, groups).scaled(tuple(1.0 + amount * (c - 1.0) for c in as_color(tints[2])))
        if amount == 1.0:
            return self.color(second, groups).scaled(as_color(tints[1]))
        return None

    def _ignored(self, node, name: str) -> None:
        socket = node.inputs.get(name)
        if socket is not None and follow(socket)[0] is not None:
            self.say(f"node {node.name}: {name} is ignored")


_READERS = {
    "BSDF_DIFFUSE": SurfaceReader._bsdf_diffuse,
    "BSDF_PRINCIPLED": SurfaceReader._bsdf_principled,
    "BSDF_TRANSPARENT": SurfaceReader._bsdf_transparent,
    "EMISSION": SurfaceReader._emission,
    "BACKGROUND": SurfaceReader._emission,
    "ADD_SHADER": SurfaceReader._add_shader,
    "MIX_SHADER": SurfaceReader._mix_shader,
}
