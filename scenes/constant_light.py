"""A scene whose surfaces shine by themselves, all alike: blender -b SCENE.blend --python constant_light.py -- OUT.blend

Every surface emits what its base colour was, image and all, with strength 1; mixtures with transparency stay as they
are. What only emitted is white. Lamps go, and the world is black. What has no material is of Blender's default grey.
"""
import sys

import bpy

GREY = 0.8  # Blender's, of what has no material
COLOR_INPUTS = ("Base Color", "Color")


def shine(material):
    """Make a material emit its base colour."""
    if not material.use_nodes:
        colour = tuple(material.diffuse_color)
        material.use_nodes = True
        replace(material.node_tree, nodes_of(material.node_tree, "BSDF_PRINCIPLED")[0], colour)
        return
    tree = material.node_tree
    for node in nodes_of(tree, "ADD_SHADER"):  # emission besides a surface: the surface alone is kept
        for socket in node.inputs[:2]:
            if socket.is_linked and socket.links[0].from_node.type == "EMISSION":
                tree.links.remove(socket.links[0])
    for node in list(tree.nodes):
        if node.type == "EMISSION" or node.type.startswith("BSDF_") and node.type != "BSDF_TRANSPARENT":
            replace(tree, node)


def nodes_of(tree, kind):
    return [node for node in tree.nodes if node.type == kind]


def replace(tree, node, colour=None):
    """Put an Emission node in the place of a shader node. colour: RGBA instead of the node's own."""
    glow = tree.nodes.new("ShaderNodeEmission")
    source = next((node.inputs[name] for name in COLOR_INPUTS if name in node.inputs), None)
    if colour is not None or source is None or node.type == "EMISSION":
        glow.inputs["Color"].default_value = colour or (1, 1, 1, 1)
    else:
        glow.inputs["Color"].default_value = source.default_value
        if source.is_linked:
            tree.links.new(source.links[0].from_socket, glow.inputs["Color"])
    for link in list(node.outputs[0].links):
        tree.links.new(glow.outputs[0], link.to_socket)
    tree.nodes.remove(node)


def give_material(thing, grey):
    """`grey` for every slot of an object that is empty, and for an object without slots."""
    if not thing.data.materials:
        thing.data.materials.append(grey)
    for slot in thing.material_slots:
        if slot.material is None:
            slot.material = grey


def darken(scene):
    """No light but that of surfaces."""
    for lamp in [thing for thing in bpy.data.objects if thing.type == "LIGHT"]:
        bpy.data.objects.remove(lamp)
    scene.world = bpy.data.worlds.new("black")
    scene.world.color = (0, 0, 0)


def make_constant(scene):
    grey = bpy.data.materials.new("default grey")
    grey.diffuse_color = (GREY, GREY, GREY, 1)
    for thing in bpy.data.objects:
        if hasattr(thing.data, "materials"):
            give_material(thing, grey)
    for material in bpy.data.materials:
        shine(material)
    darken(scene)


if __name__ == "__main__":
    make_constant(bpy.context.scene)
    bpy.ops.wm.save_as_mainfile(filepath=sys.argv[sys.argv.index("--") + 1], compress=True)
