"""Small scenes for tests."""

import bpy


def link(data, name=None, **properties):
    """A new object of the data in the scene."""
    thing = bpy.data.objects.new(name or data.name, data)
    for key, value in properties.items():
        setattr(thing, key, value)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def quad(name="Quad", size=2.0, slots=1, faces=1):
    """Mesh of `faces` squares side by side in z = 0, each using the material slot of its number modulo slots."""
    half = size / 2
    vertices, polygons = [], []
    for face in range(faces):
        x = face * size
        vertices += [(x - half, -half, 0), (x + half, -half, 0), (x + half, half, 0), (x - half, half, 0)]
        polygons.append(range(4 * face, 4 * face + 4))
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], polygons)
    for face, polygon in enumerate(mesh.polygons):
        polygon.material_index = face % slots
    return mesh


def material(name, color=None):
    """A material with an empty node tree but its output, or of one diffuse colour."""
    result = bpy.data.materials.new(name)
    result.use_nodes = True
    tree = result.node_tree
    tree.nodes.clear()
    tree.nodes.new("ShaderNodeOutputMaterial")
    if color:
        diffuse = add(tree, "ShaderNodeBsdfDiffuse", Color=(*color, 1))
        surface(tree, diffuse)
    return result


def add(tree, kind, **inputs):
    """A node with input values; underscores in names read as spaces."""
    node = tree.nodes.new(kind)
    for name, value in inputs.items():
        node.inputs[name.replace("_", " ")].default_value = value
    return node


def diffuse(tree, color):
    """A Diffuse BSDF of one colour."""
    return add(tree, "ShaderNodeBsdfDiffuse", Color=(*color, 1))


def surface(tree, node):
    """Links a shader node to the output."""
    output = next(node for node in tree.nodes if node.type.startswith("OUTPUT_"))
    tree.links.new(node.outputs[0], output.inputs["Surface"])


def operator_object(operator, **arguments):
    """The object that a bpy.ops primitive makes."""
    operator(**arguments)
    return bpy.context.object


def lamp(kind, name="Lamp", energy=100.0, **properties):
    data = bpy.data.lights.new(name, kind)
    data.energy = energy
    for key, value in properties.items():
        setattr(data, key, value)
    return link(data)
