"""Models in two parts, and more than once."""
import math

import bpy
from mathutils import Matrix
from scene_tools import extent, furniture, remove_faces


def again(thing, name, location, turn=0.0, scale=1.0):
    """One more of a thing: an object that shares its mesh. turn: degrees."""
    made = bpy.data.objects.new(name, thing.data)
    made.location, made.rotation_euler = location, (0, 0, math.radians(turn))
    made.scale = (scale, scale, scale)
    bpy.context.collection.objects.link(made)
    return made


def plant(name, archive, model, location, foliage, by_pot=False, **options):
    """A model split into "NAME pot" and "NAME leaves". Its middle stands at `location`, or that of its pot.

    foliage: the model's material names that are leaves or flowers; options: of furniture().
    """
    pot = furniture(f"{name} pot", archive, model, location, **options)
    leaves = pot.copy()
    leaves.data = pot.data.copy()
    leaves.name = leaves.data.name = f"{name} leaves"
    bpy.context.collection.objects.link(leaves)
    green = {f"{name} pot {material}" for material in foliage}
    remove_faces(pot, green)
    remove_faces(leaves, {slot.material.name for slot in leaves.material_slots} - green)
    low, high = extent(pot)
    to_foot = Matrix.Translation((-(low[0] + high[0]) / 2, -(low[1] + high[1]) / 2, -low[2]))
    for part in (pot, leaves):
        drop_unused_slots(part)
        if by_pot:
            part.data.transform(to_foot)
    return pot, leaves


def drop_unused_slots(thing):
    bpy.ops.object.select_all(action="DESELECT")
    bpy.context.view_layer.objects.active = thing
    thing.select_set(True)
    bpy.ops.object.material_slot_remove_unused()
