"""Node trees to reflectance and emission."""

import bpy
import pytest
from building import add, diffuse, link, material, quad, surface
from capture import export, exported
from gridgather.export.blackbody import blackbody
from pictures import cycles_pixels

BLACK = (0, 0, 0)


def emission(tree, color, strength=1.0):
    return add(tree, "ShaderNodeEmission", Color=(*color, 1), Strength=strength)


def principled(tree, **inputs):
    """A Principled BSDF; inputs by their names up to 3.6 or from 4.0 on, whichever the version has."""
    node = tree.nodes.new("ShaderNodeBsdfPrincipled")
    new_names = {"Transmission": "Transmission Weight", "Emission": "Emission Color"}
    for name, value in inputs.items():
        name = name.replace("_", " ")
        (node.inputs.get(name) or node.inputs[new_names[name]]).default_value = value
    return node


def white_principled(tree, **inputs):
    return principled(tree, Base_Color=(1, 1, 1, 1), **inputs)


def added(tree, first, second):
    return joined(tree, tree.nodes.new("ShaderNodeAddShader"), first, second)


def mixed(tree, first, second, factor):
    return joined(tree, add(tree, "ShaderNodeMixShader", Fac=factor), first, second)


def joined(tree, node, *shaders):
    sockets = [socket for socket in node.inputs if socket.type == "SHADER"]
    for shader, socket in zip(shaders, sockets, strict=True):
        tree.links.new(shader.outputs[0], socket)
    return node


SURFACES = {
    "diffuse": (lambda tree: diffuse(tree, (0.2, 0.4, 0.6)), (0.2, 0.4, 0.6), BLACK),
    "emission": (lambda tree: emission(tree, (1, 0.5, 0.25), 4), BLACK, (4, 2, 1)),
    "principled": (lambda tree: principled(tree, Base_Color=(0.2, 0.4, 0.6, 1)), (0.2, 0.4, 0.6), BLACK),
    "principled emission": (
        lambda tree: principled(tree, Base_Color=(0.2, 0.4, 0.6, 1), Emission=(1, 0, 0.5, 1), Emission_Strength=3),
        (0.2, 0.4, 0.6),
        (3, 0, 1.5),
    ),
    "add": (
        lambda tree: added(tree, diffuse(tree, (0.2, 0.4, 0.6)), emission(tree, (1, 2, 3))),
        (0.2, 0.4, 0.6),
        (1, 2, 3),
    ),
    "mix": (
        lambda tree: mixed(tree, diffuse(tree, (1, 0, 0)), diffuse(tree, (0, 1, 0)), 0.25),
        (0.75, 0.25, 0),
        BLACK,
    ),
    "mix of emission": (
        lambda tree: mixed(tree, diffuse(tree, (1, 1, 1)), emission(tree, (1, 0, 0), 8), 0.5),
        (0.5, 0.5, 0.5),
        (4, 0, 0),
    ),
}


@pytest.mark.parametrize("name", SURFACES)
def test_surfaces_that_are_kept_exactly(name):
    make, reflectance, emitted = SURFACES[name]
    source = material("Surface")
    surface(source.node_tree, make(source.node_tree))
    result, frame = exported(source)
    assert result.reflectance.factor == pytest.approx(reflectance)
    assert result.emission.factor == pytest.approx(emitted)
    assert frame.scene.messages == []


# name -> (node tree, reflectance, word of the message)
APPROXIMATIONS = {
    "metallic": (lambda tree: principled(tree, Base_Color=(1, 1, 1, 1), Metallic=0.25), (0.75,) * 3, "Metallic"),
    "transmission": (
        lambda tree: principled(tree, Base_Color=(1, 1, 1, 1), Transmission=0.5),
        (0.5,) * 3,
        "Transmission",
    ),
    "alpha": (lambda tree: principled(tree, Base_Color=(1, 1, 1, 1), Alpha=0.5), (1,) * 3, "Alpha"),
    "glass": (lambda tree: add(tree, "ShaderNodeBsdfGlass", Color=(0.1, 0.2, 0.3, 1)), (0.1, 0.2, 0.3), "Glass BSDF"),
    "translucent": (
        lambda tree: add(tree, "ShaderNodeBsdfTranslucent", Color=(0.1, 0.2, 0.3, 1)),
        (0.1, 0.2, 0.3),
        "Translucent BSDF",
    ),
    "rough diffuse": (
        lambda tree: add(tree, "ShaderNodeBsdfDiffuse", Color=(0.1, 0.2, 0.3, 1), Roughness=0.5),
        (0.1, 0.2, 0.3),
        "Roughness",
    ),
    "half transparent": (
        lambda tree: mixed(tree, tree.nodes.new("ShaderNodeBsdfTransparent"), diffuse(tree, (0.5,) * 3), 0.3),
        (0.5,) * 3,
        "Transparent BSDF",
    ),
    "holdout": (lambda tree: tree.nodes.new("ShaderNodeHoldout"), BLACK, "Holdout"),
}


@pytest.mark.parametrize("name", APPROXIMATIONS)
def test_approximations_name_material_and_node(name):
    make, reflectance, word = APPROXIMATIONS[name]
    source = material("Surface")
    surface(source.node_tree, make(source.node_tree))
    result, frame = exported(source)
    assert result.reflectance.factor == pytest.approx(reflectance)
    ((owner, text),) = frame.scene.messages
    assert owner == "Surface" and word in text


def test_varying_inputs_fall_back_to_their_own_value_and_are_named():
    source = material("Surface")
    tree = source.node_tree
    node = diffuse(tree, (0.1, 0.2, 0.3))
    surface(tree, node)
    tree.links.new(tree.nodes.new("ShaderNodeTexNoise").outputs["Color"], node.inputs["Color"])
    result, frame = exported(source)
    assert result.reflectance.factor == pytest.approx((0.1, 0.2, 0.3))
    ((_, text),) = frame.scene.messages
    assert "Noise Texture" in text and "(0.1, 0.2, 0.3)" in text


def test_material_without_nodes_has_its_viewport_colour():
    source = material("Plain", (1, 0, 0))
    source.use_nodes = False
    source.diffuse_color = (0.1, 0.2, 0.3, 1)
    if not source.use_nodes:  # from 5.0 on there are always nodes
        assert exported(source)[0].reflectance.factor == pytest.approx((0.1, 0.2, 0.3))


def test_material_without_output_is_black_and_reported():
    source = material("Broken")
    source.node_tree.nodes.clear()
    result, frame = exported(source)
    assert result.reflectance.is_black
    assert "no output" in frame.scene.messages[0][1]


def test_output_for_cycles_goes_before_the_one_for_eevee():
    source = material("Surface")
    tree = source.node_tree
    tree.nodes.clear()
    for target, color in (("EEVEE", (1, 0, 0)), ("CYCLES", (0, 1, 0))):
        output = tree.nodes.new("ShaderNodeOutputMaterial")
        output.target = target
        tree.links.new(diffuse(tree, color).outputs[0], output.inputs["Surface"])
    assert exported(source)[0].reflectance.factor == pytest.approx((0, 1, 0))


def test_constants_reach_through_reroutes_groups_and_muted_nodes():
    group = bpy.data.node_groups.new("Group", "ShaderNodeTree")
    if hasattr(group, "interface"):
        group.interface.new_socket("Tint", in_out="INPUT", socket_type="NodeSocketColor")
        group.interface.new_socket("Shader", in_out="OUTPUT", socket_type="NodeSocketShader")
    else:
        group.inputs.new("NodeSocketColor", "Tint")
        group.outputs.new("NodeSocketShader", "Shader")
    inside = group.nodes.new("ShaderNodeBsdfDiffuse")
    group.links.new(group.nodes.new("NodeGroupInput").outputs[0], inside.inputs["Color"])
    group.links.new(inside.outputs[0], group.nodes.new("NodeGroupOutput").inputs[0])
    source = material("Surface")
    tree = source.node_tree
    rgb, reroute, muted = (tree.nodes.new(kind) for kind in ("ShaderNodeRGB", "NodeReroute", "ShaderNodeGamma"))
    rgb.outputs[0].default_value = (0.1, 0.2, 0.3, 1)
    muted.mute = True
    use = tree.nodes.new("ShaderNodeGroup")
    use.node_tree = group
    tree.links.new(rgb.outputs[0], reroute.inputs[0])
    tree.links.new(reroute.outputs[0], muted.inputs["Color"])
    tree.links.new(muted.outputs[0], use.inputs["Tint"])
    surface(tree, use)
    result, frame = exported(source)
    assert result.reflectance.factor == pytest.approx((0.1, 0.2, 0.3))
    assert frame.scene.messages == []
    tree.links.remove(use.inputs["Tint"].links[0])
    use.inputs["Tint"].default_value = (0.7, 0.6, 0.5, 1)
    assert export().scene.materials[0].reflectance.factor == pytest.approx((0.7, 0.6, 0.5))


def test_value_node_as_strength_and_blackbody_as_colour():
    source = material("Lamp")
    tree = source.node_tree
    node, value, glow = (
        emission(tree, (1, 1, 1)),
        tree.nodes.new("ShaderNodeValue"),
        tree.nodes.new("ShaderNodeBlackbody"),
    )
    value.outputs[0].default_value = 5
    glow.inputs["Temperature"].default_value = 3000
    tree.links.new(value.outputs[0], node.inputs["Strength"])
    tree.links.new(glow.outputs[0], node.inputs["Color"])
    surface(tree, node)
    assert exported(source)[0].emission.factor == pytest.approx([5 * c for c in blackbody(3000)])


@pytest.mark.parametrize("kelvin", [2000, 3000, 4500, 6500, 9000])
def test_blackbody_is_that_of_cycles(scene, kelvin):
    source = material("Lamp")
    tree = source.node_tree
    node = emission(tree, (1, 1, 1))
    glow = add(tree, "ShaderNodeBlackbody", Temperature=kelvin)
    tree.links.new(glow.outputs[0], node.inputs["Color"])
    surface(tree, node)
    assert blackbody(kelvin) == pytest.approx(rendered_by_cycles(scene, source), rel=0.03, abs=0.02)


def rendered_by_cycles(scene, source):
    """The colour of a picture that an emitting material fills."""
    mesh = quad(size=100)
    mesh.materials.append(source)
    link(mesh)
    scene.render.resolution_x = scene.render.resolution_y = 4
    return cycles_pixels(scene, 1)[0, 0, :3]
