"""The world's uniform radiance."""

from .. import description
from ..compat import node_tree
from .nodes import follow
from .surface import SurfaceReader


def export_world(world, scene: description.Scene) -> tuple[float, float, float]:
    """Radiance in W/(m2 sr); black without a world."""
    if world is None:
        return (0.0, 0.0, 0.0)
    tree = node_tree(world)
    if tree is None:
        return tuple(world.color)
    output = tree.get_output_node("CYCLES")
    if output is None:
        return (0.0, 0.0, 0.0)
    reader = SurfaceReader(world.name, scene)
    if follow(output.inputs["Volume"])[0] is not None:
        reader.say("Volume is ignored")
    _, radiance = reader.shader(output.inputs["Surface"])
    return radiance.factor
