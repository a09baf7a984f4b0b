"""Which object does each pixel show: blender -b SCENE.blend --python region_masks.py -- OUT.npz [PERCENT]

One ray through each pixel's centre meets the evaluated scene. OUT.npz holds
index    (height, width) int32, first row at the top: position in `names`, -1 where the ray meets nothing
emitting (height, width) bool: the material there only emits
names    the objects' names
triangles  how many triangles the scene has, instances counted
"""
import sys

import bpy
import numpy as np
from mathutils import Vector


def only_emits(material):
    """True if an Emission node alone feeds the material's surface."""
    if material is None or not material.use_nodes:
        return False
    output = material.node_tree.get_output_node("CYCLES")
    links = output.inputs["Surface"].links if output else ()
    return bool(links) and links[0].from_node.type == "EMISSION"


def material_of(thing, polygon_index):
    """The material of a polygon of an object with evaluated mesh data."""
    if not thing.material_slots:
        return None
    slot = thing.data.polygons[polygon_index].material_index
    return thing.material_slots[min(slot, len(thing.material_slots) - 1)].material


def count_triangles(depsgraph):
    counts, total = {}, 0
    for instance in depsgraph.object_instances:
        thing = instance.object
        if thing.type not in {"MESH", "CURVE", "SURFACE", "META", "FONT"} or not instance.show_self:
            continue
        if thing.name not in counts:
            mesh = thing.to_mesh()
            mesh.calc_loop_triangles()
            counts[thing.name] = len(mesh.loop_triangles)
            thing.to_mesh_clear()
        total += counts[thing.name]
    return total


def make_masks(percent):
    """(index, emitting, names) of the current scene's picture."""
    scene, depsgraph = bpy.context.scene, bpy.context.evaluated_depsgraph_get()
    lens = scene.camera.evaluated_get(depsgraph)
    if lens.data.type != "PERSP":
        raise RuntimeError(f"camera {lens.name} is not a perspective one")
    width = scene.render.resolution_x * percent // 100
    height = scene.render.resolution_y * percent // 100
    top_right, bottom_right, _, top_left = (lens.matrix_world.to_3x3() @ v for v in lens.data.view_frame(scene=scene))
    origin = lens.matrix_world.translation
    index, emitting = np.full((height, width), -1, np.int32), np.zeros((height, width), bool)
    names, emits = [], {}
    for row in range(height):
        for column in range(width):
            across = (top_right - top_left) * ((column + 0.5) / width)
            direction = top_left + across + (bottom_right - top_right) * ((row + 0.5) / height)
            hit, _, _, polygon, thing, _ = scene.ray_cast(depsgraph, origin, Vector(direction).normalized())
            if not hit:
                continue
            if thing.name not in names:
                names.append(thing.name)
            index[row, column] = names.index(thing.name)
            material = material_of(thing.evaluated_get(depsgraph), polygon)
            key = material.name if material else None
            if key not in emits:
                emits[key] = only_emits(material)
            emitting[row, column] = emits[key]
    return index, emitting, names


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1:]
    index, emitting, names = make_masks(int(arguments[1]) if len(arguments) > 1 else 50)
    triangles = count_triangles(bpy.context.evaluated_depsgraph_get())
    np.savez_compressed(arguments[0], index=index, emitting=emitting, names=np.array(names), triangles=triangles)
