"""Lamps."""

import math

from .. import description
from ..compat import casts_shadow, has_soft_falloff, light_factor, node_tree
from ..description import AREA_ELLIPSE, AREA_RECTANGLE, LIGHT_AREA, LIGHT_POINT, LIGHT_SPOT, LIGHT_SUN, Light
from .identity import rows
from .surface import SurfaceReader

_TYPES = {"POINT": LIGHT_POINT, "SPOT": LIGHT_SPOT, "SUN": LIGHT_SUN, "AREA": LIGHT_AREA}


def export_light(instance, stable_id: int, scene: description.Scene) -> Light | None:
    """The lamp of a DepsgraphObjectInstance; None when it sends no light to diffuse surfaces."""
    lamp, data = instance.object, instance.object.data
    cycles = getattr(data, "cycles", None)
    if getattr(cycles, "is_portal", False) or not lamp.visible_diffuse:
        return None
    light = Light(
        name=lamp.name,
        type=_TYPES[data.type],
        matrix=rows(instance.matrix_world),
        power=(0.0, 0.0, 0.0),
        stable_id=stable_id,
    )
    _set_shape(light, data)
    tint = _node_color(data, lamp.name, scene)
    factor = light_factor(data, area(light))
    light.power = tuple(data.energy * c * t * f for c, t, f in zip(data.color, tint, factor, strict=True))
    if not any(light.power):
        return None
    if not casts_shadow(data):
        scene.say(lamp.name, "light without shadows casts them all the same")
    if data.type == "AREA" and getattr(data, "spread", math.pi) < math.pi:
        scene.say(lamp.name, "Spread of the area light is taken as 180 degrees")
    return light


def _set_shape(light: Light, data) -> None:
    if data.type in {"POINT", "SPOT"}:
        light.radius = data.shadow_soft_size
        light.soft_falloff = has_soft_falloff(data)
    if data.type == "SPOT":
        light.spot_angle, light.spot_blend = data.spot_size, data.spot_blend
    if data.type == "SUN":
        light.angle = data.angle
    if data.type == "AREA":
        light.size_x = data.size
        light.size_y = data.size_y if data.shape in {"RECTANGLE", "ELLIPSE"} else data.size
        light.shape = AREA_ELLIPSE if data.shape in {"DISK", "ELLIPSE"} else AREA_RECTANGLE


def area(light: Light) -> float:
    """What Cycles divides a lamp's power by [m2; sun: projected solid angle, sr]; 1 for lamps without extent."""
    if light.type in {LIGHT_POINT, LIGHT_SPOT}:
        result = 4 * math.pi * light.radius**2
    elif light.type == LIGHT_SUN:
        result = math.pi * math.sin(light.angle / 2) ** 2
    else:
        columns = ([light.matrix[row * 4 + axis] for row in range(3)] for axis in range(2))
        width, height = (math.hypot(*column) for column in columns)
        result = width * light.size_x * height * light.size_y * (math.pi / 4 if light.shape == AREA_ELLIPSE else 1.0)
    return result or 1.0


def _node_color(data, name: str, scene: description.Scene) -> tuple[float, float, float]:
    """What the lamp's node tree multiplies its power by."""
    tree = node_tree(data)
    if tree is None:
        return (1.0, 1.0, 1.0)
    output = tree.get_output_node("CYCLES")
    if output is None:
        return (0.0, 0.0, 0.0)
    _, emission = SurfaceReader(name, scene).shader(output.inputs["Surface"])
    return emission.factor
