"""Image textures on surfaces: images, UV maps, mappings."""

import bpy
import numpy as np
import pytest
from building import diffuse, link, material, quad, surface
from capture import export, exported
from gridgather.description import EXTENSION_CLIP, FILTER_CLOSEST, IDENTITY_UV, NONE


def textured(source, extension="REPEAT", interpolation="Linear", **mapping):
    """Diffuse of an image, through a Mapping node when there is something to map; returns the texture node."""
    tree = source.node_tree
    node, texture = diffuse(tree, (1, 1, 1)), tree.nodes.new("ShaderNodeTexImage")
    texture.image = bpy.data.images.new("Picture", 2, 3)
    texture.extension, texture.interpolation = extension, interpolation
    tree.links.new(texture.outputs["Color"], node.inputs["Color"])
    surface(tree, node)
    if mapping:
        place = tree.nodes.new("ShaderNodeMapping")
        place.vector_type = mapping.pop("vector_type", "POINT")
        for name, value in mapping.items():
            place.inputs[name].default_value = value
        tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["UV"], place.inputs["Vector"])
        tree.links.new(place.outputs[0], texture.inputs["Vector"])
    return texture


def test_image_texture_on_the_active_uv_map():
    source = material("Surface")
    textured(source, extension="CLIP", interpolation="Closest")
    result, frame = exported(source)
    assert result.reflectance.factor == (1, 1, 1)
    assert result.reflectance.uv_map == IDENTITY_UV
    image = frame.scene.images[result.reflectance.image]
    assert (image.name, image.extension, image.filter_mode) == ("Picture", EXTENSION_CLIP, FILTER_CLOSEST)
    assert frame.scene.messages == []


MAPPINGS = {
    "move": ({"Location": (0.5, 0.25, 9)}, (1, 0, 0.5, 0, 1, 0.25)),
    "scale": ({"Scale": (2, 3, 4)}, (2, 0, 0, 0, 3, 0)),
    "turn": ({"Rotation": (0, 0, np.pi / 2)}, (0, -1, 0, 1, 0, 0)),
    "all": ({"Location": (5, 6, 0), "Rotation": (0, 0, np.pi / 2), "Scale": (2, 3, 1)}, (0, -3, 5, 2, 0, 6)),
    "texture": (
        {"vector_type": "TEXTURE", "Location": (5, 6, 0), "Rotation": (0, 0, np.pi / 2), "Scale": (2, 4, 1)},
        (0, 0.5, -3, -0.25, 0, 1.25),
    ),
    "vector": ({"vector_type": "VECTOR", "Rotation": (0, 0, np.pi / 2), "Scale": (2, 3, 1)}, (0, -3, 0, 2, 0, 0)),
    "tilt": ({"Rotation": (np.pi / 3, 0, 0)}, (1, 0, 0, 0, 0.5, 0)),
}


@pytest.mark.parametrize("name", MAPPINGS)
def test_mapping_nodes(name):
    inputs, expected = MAPPINGS[name]
    source = material("Surface")
    textured(source, **inputs)
    result, frame = exported(source)
    assert result.reflectance.uv_map == pytest.approx(expected, abs=1e-6)
    assert frame.scene.messages == []


def test_tinted_image():
    source = material("Surface")
    tree = source.node_tree
    texture = textured(source)
    node = next(node for node in tree.nodes if node.type == "BSDF_DIFFUSE")
    tint = tree.nodes.new("ShaderNodeMixRGB")
    tint.blend_type = "MULTIPLY"
    tint.inputs[0].default_value = 0.5
    tint.inputs[2].default_value = (0.2, 0.4, 0.6, 1)
    tree.links.new(texture.outputs["Color"], tint.inputs[1])
    tree.links.new(tint.outputs[0], node.inputs["Color"])
    result, frame = exported(source)
    assert result.reflectance.factor == pytest.approx((0.6, 0.7, 0.8))
    assert result.reflectance.image != NONE and frame.scene.messages == []


def test_image_texture_without_image_is_magenta_and_reported():
    source = material("Surface")
    textured(source).image = None
    result, frame = exported(source)
    assert result.reflectance.factor == (1, 0, 1) and result.reflectance.image == NONE
    assert "no image" in frame.scene.messages[0][1]


def test_other_coordinates_and_other_uv_maps_are_reported():
    source = material("Surface")
    tree = source.node_tree
    texture = textured(source)
    tree.links.new(tree.nodes.new("ShaderNodeTexCoord").outputs["Generated"], texture.inputs["Vector"])
    _, frame = exported(source)
    assert "Generated" in frame.scene.messages[0][1]
    uv = tree.nodes.new("ShaderNodeUVMap")
    tree.links.new(uv.outputs[0], texture.inputs["Vector"])
    uv.uv_map = "UVMap"
    assert export().scene.messages == []
    uv.uv_map = "Lightmap"
    ((name, text),) = export().scene.messages
    assert name == "Quad" and "Lightmap" in text and "UVMap" in text


def test_one_image_is_exported_once():
    first, second = material("First"), material("Second")
    textured(second).image = textured(first).image
    mesh = quad(slots=2, faces=2)
    mesh.materials.append(first)
    mesh.materials.append(second)
    link(mesh)
    frame = export()
    assert len(frame.scene.images) == 1 and len(frame.scene.materials) == 2
