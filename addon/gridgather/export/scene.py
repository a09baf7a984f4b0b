"""A depsgraph to a description: what is placed where."""

import time

from .. import passes
from ..description import HIDDEN_FROM_CAMERA, HIDDEN_FROM_LIGHT, Frame, InstanceGroup, Scene
from . import ExportCancelledError
from .camera import export_camera
from .display import export_display
from .identity import distinct_id, rows, stable_id
from .light import export_light
from .material import MaterialExport
from .mesh import export_mesh
from .settings import export_settings
from .world import export_world

# What renders but is not converted. Curves, text, surfaces and metaballs come along as meshes of their own.
_UNSUPPORTED = {"CURVES", "POINTCLOUD", "VOLUME", "GPENCIL", "GREASEPENCIL"}
_POLL_EVERY = 256  # instances


def export_frame(depsgraph, width: int, height: int, camera=None, cancelled=lambda: False) -> Frame:
    """All that a full picture of width x height pixels needs, through `camera` or the scene's own.

    Raises ExportError, or ExportCancelledError once cancelled().
    """
    start = time.perf_counter()
    camera = camera or depsgraph.scene.camera
    window = export_camera(depsgraph, camera, width, height)
    settings = export_settings(depsgraph.scene_eval, width, height)
    settings.passes = passes.bits(depsgraph.view_layer)
    scene = export_scene(depsgraph, cancelled)
    if depsgraph.scene_eval.gridgather.use_perception:
        settings.display = export_display(depsgraph.scene_eval, scene)
    if camera.data.dof.use_dof:
        scene.say(camera.name, "Depth of Field is left out")
    return Frame(scene, window, settings, time.perf_counter() - start)


def export_scene(depsgraph, cancelled=lambda: False) -> Scene:
    scene, render = Scene(), depsgraph.scene.render
    for name, used in (("Motion Blur", render.use_motion_blur), ("Stereoscopy", render.use_multiview)):
        if used:
            scene.say(depsgraph.scene.name, f"{name} is left out")
    scene.world = export_world(depsgraph.scene_eval.world, scene)
    placing = _Placing(depsgraph, scene)
    for number, instance in enumerate(depsgraph.object_instances):
        if number % _POLL_EVERY == 0 and cancelled():
            raise ExportCancelledError
        if not instance.show_self:
            continue
        kind = instance.object.type
        if kind == "MESH":
            placing.add_mesh(instance)
        elif kind == "LIGHT":
            placing.add_light(instance)
        elif kind in _UNSUPPORTED:
            scene.say(instance.object.name, f"objects of type {kind} are left out")
    return scene


class _Placing:
    """Exports each mesh once and sorts its instances by their material lists."""

    def __init__(self, depsgraph, scene: Scene):
        self._scene = scene
        self._materials = MaterialExport(scene)
        self._view_layer = depsgraph.view_layer
        self._override = self._view_layer.material_override
        self._meshes: dict[int, int | None] = {}  # evaluated mesh -> index; evaluated meshes live as long as depsgraph
        self._groups: dict[tuple[int, ...], InstanceGroup] = {}
        self._kinds: dict[tuple, tuple | None] = {}
        self._ids: set[int] = set()

    def add_light(self, instance) -> None:
        light = export_light(instance, distinct_id(stable_id(instance), self._ids), self._scene)
        if light is not None:
            self._scene.lights.append(light)

    def add_mesh(self, instance) -> None:
        # Iterating reuses one object for all instances, so what lasts is the original behind it.
        thing, parent = instance.object, instance.parent
        key = (thing.original.as_pointer(), thing.data.as_pointer(), parent.original.as_pointer() if parent else 0)
        if key not in self._kinds:
            self._kinds[key] = self._kind(thing, parent)
        kind = self._kinds[key]
        if kind is None:
            return
        mesh, flags, group = kind
        group.meshes.append(mesh)
        group.matrices.append(rows(instance.matrix_world))
        group.stable_ids.append(distinct_id(stable_id(instance), self._ids))
        group.flags.append(flags)
        group.names.append(thing.name)

    def _kind(self, thing, parent):
        """(mesh, flags, group) of all instances of an object under a parent; None when there is nothing to place."""
        flags = self._flags(thing, parent)
        if flags == HIDDEN_FROM_CAMERA | HIDDEN_FROM_LIGHT:
            return None
        mesh = self._mesh(thing.data)
        if mesh is None:
            return None
        slots = [self._override] if self._override else [slot.material for slot in thing.material_slots]
        materials = tuple(self._materials.index(material) for material in slots)
        if materials not in self._groups:
            self._groups[materials] = InstanceGroup(materials)
            self._scene.instances.append(self._groups[materials])
        self._materials.check_uv_map(materials, self._scene.meshes[mesh], thing.name)
        for system in thing.particle_systems:
            if system.settings.type == "HAIR" and system.settings.render_type == "PATH":
                self._scene.say(thing.name, f"hair of particle system {system.name} is left out")
        return mesh, flags, self._groups[materials]

    def _mesh(self, mesh) -> int | None:
        key = mesh.as_pointer()
        if key not in self._meshes:
            exported = export_mesh(mesh)
            self._meshes[key] = None if exported is None else len(self._scene.meshes)
            if exported is not None:
                self._scene.meshes.append(exported)
        return self._meshes[key]

    def _flags(self, thing, parent) -> int:
        """What does not see the object; with the parent's own switches for an instance, as in Cycles."""
        pair = [thing.original] + ([parent.original] if parent else [])
        owner = pair[-1]
        camera, diffuse, shadow = (
            all(getattr(item, name) for item in pair)
            for name in ("visible_camera", "visible_diffuse", "visible_shadow")
        )
        if owner.holdout_get(view_layer=self._view_layer):
            self._scene.say(thing.name, "Holdout is ignored")
        if thing.is_shadow_catcher:
            self._scene.say(thing.name, "Shadow Catcher is ignored")
        if diffuse != shadow:
            self._scene.say(
                thing.name, "visibility to Diffuse and Shadow rays can only be switched together: both stay on"
            )
        hidden = 0 if camera and not owner.indirect_only_get(view_layer=self._view_layer) else HIDDEN_FROM_CAMERA
        return hidden | (0 if diffuse or shadow else HIDDEN_FROM_LIGHT)
