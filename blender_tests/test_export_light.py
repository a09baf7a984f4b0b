"""Lamps and the world."""

import math

import bpy
import pytest
from building import add, lamp, link, surface
from capture import export
from gridgather import description
from gridgather.export.light import area


def only_light():
    (light,) = export().scene.lights
    return light


def test_point_lamp():
    lamp("POINT", energy=50, color=(1, 0.5, 0.25), shadow_soft_size=0.3).location = (1, 2, 3)
    light = only_light()
    assert light.type == description.LIGHT_POINT
    assert light.power == pytest.approx((50, 25, 12.5))
    assert light.radius == pytest.approx(0.3) and light.soft_falloff
    assert light.matrix[3::4] == (1, 2, 3)


def test_spot_lamp():
    lamp("SPOT", spot_size=1.2, spot_blend=0.4, shadow_soft_size=0)
    light = only_light()
    assert light.type == description.LIGHT_SPOT
    assert (light.spot_angle, light.spot_blend, light.radius) == pytest.approx((1.2, 0.4, 0))


def test_sun():
    lamp("SUN", energy=3, angle=0.1)
    light = only_light()
    assert light.type == description.LIGHT_SUN
    assert light.angle == pytest.approx(0.1)
    assert light.power == pytest.approx((3, 3, 3), rel=1e-3)


@pytest.mark.parametrize(
    "shape, size, expected",
    [
        ("SQUARE", (2, 5), (2, 2, description.AREA_RECTANGLE)),
        ("RECTANGLE", (2, 5), (2, 5, description.AREA_RECTANGLE)),
        ("DISK", (2, 5), (2, 2, description.AREA_ELLIPSE)),
        ("ELLIPSE", (2, 5), (2, 5, description.AREA_ELLIPSE)),
    ],
)
def test_area_lamp(shape, size, expected):
    lamp("AREA", shape=shape, size=size[0], size_y=size[1])
    light = only_light()
    assert light.type == description.LIGHT_AREA
    assert (light.size_x, light.size_y, light.shape) == expected


def test_strength_and_colour_of_a_node_tree_multiply():
    data = lamp("POINT", energy=10).data
    data.use_nodes = True
    emission = next(node for node in data.node_tree.nodes if node.type == "EMISSION")
    emission.inputs["Strength"].default_value = 2
    emission.inputs["Color"].default_value = (1, 0.5, 0, 1)
    assert only_light().power == pytest.approx((20, 10, 0))


def test_texture_on_a_lamp_is_reported():
    data = lamp("POINT", "Gobo").data
    data.use_nodes = True
    emission = next(node for node in data.node_tree.nodes if node.type == "EMISSION")
    texture = data.node_tree.nodes.new("ShaderNodeTexNoise")
    data.node_tree.links.new(texture.outputs["Color"], emission.inputs["Color"])
    frame = export()
    assert len(frame.scene.lights) == 1
    ((name, text),) = frame.scene.messages
    assert name == "Gobo" and "Noise Texture" in text


def test_lamps_without_light_are_left_out():
    lamp("POINT", energy=0)
    lamp("POINT").visible_diffuse = False
    lamp("AREA").data.cycles.is_portal = True
    lamp("POINT").hide_render = True
    assert export().scene.lights == []


def test_lamps_are_instanced():
    collection = bpy.data.collections.new("Lamps")
    collection.objects.link(bpy.data.objects.new("Lamp", bpy.data.lights.new("Lamp", "POINT")))
    for x in range(3):
        link(None, f"Empty {x}", location=(x, 0, 0), instance_type="COLLECTION", instance_collection=collection)
    lights = export().scene.lights
    assert sorted(light.matrix[3] for light in lights) == [0, 1, 2]
    assert len({light.stable_id for light in lights}) == 3


def test_lamp_without_shadow_is_reported():
    data = lamp("POINT", "Fill").data
    if hasattr(data.cycles, "cast_shadow"):
        data.cycles.cast_shadow = False
    else:
        data.use_shadow = False
    assert export().scene.messages == [("Fill", "light without shadows casts them all the same")]


def test_normalization_divides_by_these_areas():
    turned = (0, 3, 0, 0, 2, 0, 0, 0, 0, 0, 1, 0)  # scales x by 2 and y by 3
    panel = description.Light("", description.LIGHT_AREA, turned, (1, 1, 1), 0, size_x=0.5, size_y=2)
    assert area(panel) == pytest.approx(6)
    panel.shape = description.AREA_ELLIPSE
    assert area(panel) == pytest.approx(6 * math.pi / 4)
    point = description.Light("", description.LIGHT_POINT, turned, (1, 1, 1), 0, radius=2)
    assert area(point) == pytest.approx(16 * math.pi)
    point.radius = 0
    assert area(point) == 1


def world(scene):
    scene.world = bpy.data.worlds.new("World")
    return scene.world


def test_no_world_is_black(scene):
    scene.world = None
    assert export().scene.world == (0, 0, 0)


def test_world_colour(scene):
    world(scene).use_nodes = False
    scene.world.color = (0.1, 0.2, 0.3)
    assert export().scene.world == pytest.approx((0.1, 0.2, 0.3))


def background(scene, **inputs):
    world(scene).use_nodes = True
    tree = scene.world.node_tree
    tree.nodes.clear()
    tree.nodes.new("ShaderNodeOutputWorld")
    node = add(tree, "ShaderNodeBackground", **inputs)
    surface(tree, node)
    return tree, node


def test_background_node(scene):
    background(scene, Color=(0.1, 0.2, 0.3, 1), Strength=2)
    assert export().scene.world == pytest.approx((0.2, 0.4, 0.6))


def test_world_volume_is_reported(scene):
    tree, _ = background(scene, Color=(0.5, 0.5, 0.5, 1))
    output = next(node for node in tree.nodes if node.type == "OUTPUT_WORLD")
    tree.links.new(tree.nodes.new("ShaderNodeVolumeScatter").outputs[0], output.inputs["Volume"])
    assert export().scene.messages == [("World", "Volume is ignored")]


def test_textured_world_is_reported(scene):
    tree, node = background(scene, Color=(0.5, 0.5, 0.5, 1), Strength=1)
    sky = tree.nodes.new("ShaderNodeTexSky")
    tree.links.new(sky.outputs["Color"], node.inputs["Color"])
    frame = export()
    assert frame.scene.world == pytest.approx((0.5, 0.5, 0.5))
    ((name, text),) = frame.scene.messages
    assert name == "World" and "Sky Texture" in text
