"""Blender up to 3.6 hides shader nodes from the Add menu of engines that it does not know: a category of our own."""

import bpy

from .compat import hides_shader_nodes

_CATEGORY = "GRIDGATHER"
_NODES = (
    "ShaderNodeOutputMaterial",
    "ShaderNodeOutputLight",
    "ShaderNodeOutputWorld",
    "ShaderNodeBsdfPrincipled",
    "ShaderNodeBsdfDiffuse",
    "ShaderNodeEmission",
    "ShaderNodeBackground",
    "ShaderNodeAddShader",
    "ShaderNodeMixShader",
)


def register() -> None:
    if not hides_shader_nodes():
        return
    from nodeitems_utils import NodeCategory, NodeItem, register_node_categories

    class GridgatherNodes(NodeCategory):
        @classmethod
        def poll(cls, context):
            return context.space_data.tree_type == "ShaderNodeTree" and context.engine == "GRIDGATHER"

    items = [NodeItem(name) for name in _NODES if hasattr(bpy.types, name)]
    register_node_categories(_CATEGORY, [GridgatherNodes(_CATEGORY, "Gridgather", items=items)])


def unregister() -> None:
    if not hides_shader_nodes():
        return
    from nodeitems_utils import unregister_node_categories

    unregister_node_categories(_CATEGORY)
