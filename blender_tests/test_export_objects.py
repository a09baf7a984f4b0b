"""What is placed where: instances, generated geometry, visibility."""

import bpy
import numpy as np
import pytest
from building import link, material, operator_object, quad
from capture import export
from gridgather.description import HIDDEN_FROM_CAMERA, HIDDEN_FROM_LIGHT, NONE
from gridgather.export import ExportCancelledError
from gridgather.export.identity import distinct_id
from gridgather.export.scene import export_scene


def placed(frame):
    """{name: (mesh, 3x4 matrix, flags, materials)} of all instances; names may repeat as name, name, ..."""
    result = []
    for group in frame.scene.instances:
        for index, name in enumerate(group.names):
            mesh = frame.scene.meshes[group.meshes[index]]
            matrix = np.array(group.matrices[index]).reshape(3, 4)
            result.append((name, mesh, matrix, group.flags[index], group.materials))
    return result


def ids(frame):
    return {number for group in frame.scene.instances for number in group.stable_ids}


def test_objects_of_one_mesh_share_it():
    mesh = quad()
    for x in range(3):
        link(mesh, f"Quad {x}", location=(x, 0, 0))
    frame = export()
    assert len(frame.scene.meshes) == 1
    assert sorted(matrix[0, 3] for _, _, matrix, _, _ in placed(frame)) == [0, 1, 2]
    assert len(ids(frame)) == 3


def test_matrices_are_world_matrices():
    parent = link(None, "Parent", location=(1, 2, 3), scale=(2, 2, 2))
    child = link(quad(), "Child", location=(1, 0, 0), rotation_euler=(0, 0, np.pi / 2))
    child.parent = parent
    ((_, _, matrix, _, _),) = placed(export())
    assert matrix == pytest.approx(np.array([[0, -2, 0, 3], [2, 0, 0, 2], [0, 0, 2, 3]]), abs=1e-6)


def test_modifiers_are_applied_and_do_not_touch_objects_that_share_the_mesh():
    mesh = quad()
    link(mesh, "Plain")
    modifier = link(mesh, "Subdivided").modifiers.new("Subdivision", "SUBSURF")
    modifier.levels, modifier.render_levels = 0, 3
    triangles = {name: len(mesh.triangle_vertices) for name, mesh, *_ in placed(export())}
    assert triangles == {"Plain": 2, "Subdivided": 2 * 4**3}


def test_collection_instances_are_instances():
    collection = bpy.data.collections.new("Things")
    collection.objects.link(bpy.data.objects.new("Thing", quad()))
    for x in range(4):
        link(None, f"Empty {x}", location=(x, 0, 0), instance_type="COLLECTION", instance_collection=collection)
    frame = export()
    assert len(frame.scene.meshes) == 1
    assert [name for name, *_ in placed(frame)] == ["Thing"] * 4
    assert len(ids(frame)) == 4


def test_stable_ids_do_not_depend_on_what_else_there_is():
    collection = bpy.data.collections.new("Things")
    collection.objects.link(bpy.data.objects.new("Thing", quad()))
    places = [
        link(None, f"Empty {x}", instance_type="COLLECTION", instance_collection=collection, location=(x, 0, 0))
        for x in range(3)
    ]
    link(quad("Other"), "Quad")

    def id_of(x):
        (group,) = export().scene.instances
        (index,) = (i for i, matrix in enumerate(group.matrices) if matrix[3] == x and group.names[i] == "Thing")
        return group.stable_ids[index]

    before = id_of(2)
    link(quad("Another"), "A first one", location=(5, 0, 0))
    places[0].hide_render = True
    assert id_of(2) == before != id_of(1)


def test_ids_that_collide_are_moved_apart():
    taken = set()
    assert [distinct_id(wanted, taken) for wanted in (7, 7, 8, 2**64 - 1, 2**64 - 1)] == [7, 8, 9, 2**64 - 1, 0]


def test_particles_place_their_object():
    thing = link(quad(size=0.1), "Thing")
    thing.hide_render = True
    emitter = link(quad(), "Emitter")
    settings = emitter.modifiers.new("Particles", "PARTICLE_SYSTEM").particle_system.settings
    settings.count, settings.frame_start, settings.frame_end, settings.lifetime = 7, 1, 1, 100
    settings.render_type, settings.instance_object = "OBJECT", thing
    emitter.show_instancer_for_render = False
    bpy.context.scene.frame_set(2)
    frame = export()
    assert [name for name, *_ in placed(frame)] == ["Thing"] * 7
    assert len(ids(frame)) == 7


def test_geometry_nodes_instances_and_materials():
    grid = link(quad(faces=3), "Grid")
    red = material("Red", (1, 0, 0))
    tree = bpy.data.node_groups.new("Points to instances", "GeometryNodeTree")
    if hasattr(tree, "interface"):
        tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
        tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    else:
        tree.inputs.new("NodeSocketGeometry", "Geometry")
        tree.outputs.new("NodeSocketGeometry", "Geometry")
    start, end = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    place, cube = tree.nodes.new("GeometryNodeInstanceOnPoints"), tree.nodes.new("GeometryNodeMeshCube")
    paint = tree.nodes.new("GeometryNodeSetMaterial")
    paint.inputs["Material"].default_value = red
    for source, target in (
        (start.outputs[0], place.inputs["Points"]),
        (cube.outputs["Mesh"], paint.inputs["Geometry"]),
        (paint.outputs["Geometry"], place.inputs["Instance"]),
        (place.outputs["Instances"], end.inputs[0]),
    ):
        tree.links.new(source, target)
    grid.modifiers.new("Nodes", "NODES").node_group = tree
    frame = export()
    found = placed(frame)
    assert len(found) == 12
    assert len(frame.scene.meshes) == 1
    assert {len(mesh.triangle_vertices) for _, mesh, *_ in found} == {12}
    (slot,) = set(found[0][1].triangle_slots)
    assert {frame.scene.materials[materials[slot]].name for *_, materials in found} == {"Red"}
    assert len(ids(frame)) == 12


@pytest.mark.parametrize("kind", ["curve", "text", "surface", "metaball", "curve with modifier"])
def test_generated_geometry_comes_once(kind):
    red = material("Red", (1, 0, 0))
    if kind.startswith("curve"):
        thing = operator_object(bpy.ops.curve.primitive_bezier_circle_add)
        thing.data.bevel_depth = 0.1
        if "modifier" in kind:
            thing.modifiers.new("Subdivision", "SUBSURF")
    elif kind == "text":
        thing = operator_object(bpy.ops.object.text_add)
    elif kind == "surface":
        thing = operator_object(bpy.ops.surface.primitive_nurbs_surface_sphere_add)
    else:
        thing = operator_object(bpy.ops.object.metaball_add)
        operator_object(bpy.ops.object.metaball_add, location=(1, 0, 0))
    thing.data.materials.append(red)
    frame = export()
    ((_, mesh, _, _, materials),) = placed(frame)
    assert len(mesh.triangle_vertices) > 20
    assert frame.scene.materials[materials[0]].name == "Red"
    assert frame.scene.messages == []


def test_hidden_things_are_left_out(scene):
    link(quad(), "Hidden").hide_render = True
    link(quad(), "Seen").hide_viewport = True
    collection = bpy.data.collections.new("Excluded")
    scene.collection.children.link(collection)
    collection.objects.link(bpy.data.objects.new("In excluded collection", quad()))
    bpy.context.view_layer.layer_collection.children["Excluded"].exclude = True
    assert [name for name, *_ in placed(export())] == ["Seen"]


def test_instancer_that_is_not_shown_is_left_out():
    parent = link(quad(), "Instancer", instance_type="VERTS", show_instancer_for_render=False)
    child = link(quad(size=0.1), "Child")
    child.parent = parent
    assert [name for name, *_ in placed(export())] == ["Child"] * 4


def test_ray_visibility_becomes_flags():
    link(quad(), "Normal")
    link(quad(), "No camera", visible_camera=False)
    link(quad(), "No light", visible_diffuse=False, visible_shadow=False)
    link(quad(), "Nothing", visible_camera=False, visible_diffuse=False, visible_shadow=False)
    link(quad(), "No shadow", visible_shadow=False)
    frame = export()
    flags = {name: flags for name, _, _, flags, _ in placed(frame)}
    expected = {"Normal": 0, "No camera": HIDDEN_FROM_CAMERA, "No light": HIDDEN_FROM_LIGHT, "No shadow": 0}
    assert flags == expected
    assert [name for name, _ in frame.scene.messages] == ["No shadow"]


def test_indirect_only_collections_are_hidden_from_the_camera(scene):
    collection = bpy.data.collections.new("Indirect")
    scene.collection.children.link(collection)
    collection.objects.link(bpy.data.objects.new("Quad", quad()))
    bpy.context.view_layer.layer_collection.children["Indirect"].indirect_only = True
    ((_, _, _, flags, _),) = placed(export())
    assert flags == HIDDEN_FROM_CAMERA


def test_holdout_is_reported():
    link(quad(), "Hole", is_holdout=True)
    assert export().scene.messages == [("Hole", "Holdout is ignored")]


def test_slots_of_objects_go_before_slots_of_meshes():
    mesh = quad(slots=2, faces=3)
    for name in ("Red", "Green"):
        mesh.materials.append(material(name, (1, 0, 0)))
    link(mesh, "Of mesh")
    own = link(mesh, "Of object")
    own.material_slots[1].link = "OBJECT"
    own.material_slots[1].material = material("Blue", (0, 0, 1))
    frame = export()
    names = {
        name: [frame.scene.materials[index].name for index in materials] for name, _, _, _, materials in placed(frame)
    }
    assert names == {"Of mesh": ["Red", "Green"], "Of object": ["Red", "Blue"]}
    assert len(frame.scene.meshes) == 1
    assert frame.scene.meshes[0].triangle_slots.tolist() == [0, 0, 1, 1, 0, 0]


def test_empty_slots_and_no_slots():
    mesh = quad()
    link(mesh, "None")
    with_slot = quad()
    with_slot.materials.append(None)
    link(with_slot, "Empty")
    assert {name: materials for name, _, _, _, materials in placed(export())} == {"None": (), "Empty": (NONE,)}


def test_material_override_of_the_view_layer():
    mesh = quad(slots=2, faces=2)
    for name in ("Red", "Green"):
        mesh.materials.append(material(name, (1, 0, 0)))
    link(mesh)
    bpy.context.view_layer.material_override = material("Clay", (0.5, 0.5, 0.5))
    frame = export()
    assert [material.name for material in frame.scene.materials] == ["Clay"]


def test_objects_without_triangles_place_nothing():
    line = bpy.data.meshes.new("Line")
    line.from_pydata([(0, 0, 0), (1, 0, 0)], [(0, 1)], [])
    link(line)
    link(bpy.data.curves.new("Wire", "CURVE"))
    frame = export()
    assert placed(frame) == [] and frame.scene.messages == []


def test_unsupported_kinds_are_named():
    link(bpy.data.volumes.new("Cloud"))
    assert export().scene.messages == [("Cloud", "objects of type VOLUME are left out")]


def test_export_stops_when_cancelled():
    link(quad())
    with pytest.raises(ExportCancelledError):
        export_scene(bpy.context.evaluated_depsgraph_get(), cancelled=lambda: True)
