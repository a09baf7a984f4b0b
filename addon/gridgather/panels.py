"""The engine's own panels, Blender's shared ones, and those of Cycles for what is read the same way."""

import bpy
from bpy.types import Panel

from . import interface, messages, passes
from .engine import GridgatherEngine

_ENGINE = GridgatherEngine.bl_idname
# Panels that list Blender's built-in engine, but show what Gridgather does not have or has a panel for.
_EXCLUDED = {
    "DATA_PT_area",
    "DATA_PT_camera_dof",
    "DATA_PT_falloff_curve",
    "DATA_PT_light",
    "DATA_PT_preview",
    "DATA_PT_spot",
    "MATERIAL_PT_context_material",
    "MATERIAL_PT_preview",
    "NODE_DATA_PT_light",
    "NODE_DATA_PT_spot",
    "OBJECT_PT_visibility",
    "RENDER_PT_simplify",
    "VIEWLAYER_PT_filter",
    "VIEWLAYER_PT_layer_passes",
}
# Panels of Cycles -> what the context must have. Their poll asks for Cycles, so each gets a class of its own.
_FROM_CYCLES = {
    "CYCLES_RENDER_PT_film": "scene",
    "CYCLES_RENDER_PT_film_pixel_filter": "scene",
    "CYCLES_PT_context_material": "object",
    "CYCLES_MATERIAL_PT_surface": "material",
    "CYCLES_LIGHT_PT_light": "light",
    "CYCLES_LIGHT_PT_nodes": "light",
    "CYCLES_WORLD_PT_surface": "world",
    "CYCLES_OBJECT_PT_visibility": "object",
    "CYCLES_OBJECT_PT_visibility_ray_visibility": "object",
}


def _split_layout(panel):
    """The panel's layout with names beside their fields, as in Blender's own panels."""
    layout = panel.layout
    layout.use_property_split = True
    layout.use_property_decorate = False
    return layout


class _RenderPanel:
    bl_space_type = "PROPERTIES"
    bl_region_type = "WINDOW"
    bl_context = "render"

    @classmethod
    def poll(cls, context):
        return context.engine == _ENGINE


class GRIDGATHER_PT_settings(_RenderPanel, Panel):
    bl_label = "Gridgather"

    def draw(self, context):
        layout = _split_layout(self)
        failure = interface.failure()
        if failure:
            layout.label(text=failure, icon="ERROR")
        settings = context.scene.gridgather
        for name in ("preset", "method", "quality", "samples"):
            layout.prop(settings, name)
        layout.prop(context.scene.render, "film_transparent", text="Transparent Film")


class GRIDGATHER_PT_perception(_RenderPanel, Panel):
    bl_label = "Judge as Shown"
    bl_parent_id = "GRIDGATHER_PT_settings"
    bl_options = {"DEFAULT_CLOSED"}

    def draw_header(self, context):
        self.layout.prop(context.scene.gridgather, "use_perception", text="")

    def draw(self, context):
        layout = _split_layout(self)
        settings = context.scene.gridgather
        layout.active = settings.use_perception and settings.method == "GATHER"
        layout.prop(settings, "noticeable")
        layout.prop(settings, "shown_as", expand=True)
        row = layout.row()
        row.active = settings.shown_as == "STILL"
        row.prop(settings, "use_masking")
        for name in ("display_white", "display_black", "viewing_distance", "display_density"):
            layout.prop(settings, name)


class GRIDGATHER_PT_gather(_RenderPanel, Panel):
    bl_label = "Final Gather"
    bl_parent_id = "GRIDGATHER_PT_settings"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout = _split_layout(self)
        settings = context.scene.gridgather
        layout.active = settings.method != "SOLUTION"
        layout.prop(settings, "gather_samples")
        column = layout.column()
        column.active = settings.method == "GATHER"
        for name in ("threshold", "cell_size", "use_surface_sites", "receivers", "depth_law"):
            column.prop(settings, name)


class GRIDGATHER_PT_diagnostics(_RenderPanel, Panel):
    bl_label = "Diagnostics"
    bl_parent_id = "GRIDGATHER_PT_settings"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        _split_layout(self).prop(context.scene.gridgather, "capture_path")


class GRIDGATHER_PT_diagnostic_passes(_RenderPanel, Panel):
    bl_label = "Diagnostic Passes"
    bl_context = "view_layer"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        column = _split_layout(self).column(heading="Include")
        for name in passes.PROPERTIES:
            column.prop(context.view_layer.gridgather, name)


class GRIDGATHER_PT_messages(_RenderPanel, Panel):
    bl_label = "Messages"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        found = messages.of_scene(context.scene)
        if not found:
            self.layout.label(text="Everything in the last render was understood")
        for message in found:
            self.layout.label(text=messages.line(*message), icon="INFO")


class GridgatherPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    def draw(self, _context):
        failure = interface.failure()
        if failure:
            self.layout.label(text=failure, icon="ERROR")
        else:
            self.layout.label(text=f"Library {interface.load().gg_version().decode()}", icon="CHECKMARK")


_classes = [
    GRIDGATHER_PT_settings,
    GRIDGATHER_PT_perception,
    GRIDGATHER_PT_gather,
    GRIDGATHER_PT_diagnostics,
    GRIDGATHER_PT_diagnostic_passes,
    GRIDGATHER_PT_messages,
    GridgatherPreferences,
]
_from_cycles = []


def _panel_from_cycles(name: str, needs: str):
    """A panel of ours that draws what a panel of Cycles draws."""
    source = getattr(bpy.types, name)
    body = {
        "bl_label": source.bl_label,
        "bl_space_type": source.bl_space_type,
        "bl_region_type": source.bl_region_type,
        "bl_context": source.bl_context,
        "bl_options": set(getattr(source, "bl_options", ())),
        "draw": source.draw,
        "poll": classmethod(lambda _, context: context.engine == _ENGINE and getattr(context, needs, None) is not None),
    }
    parent = getattr(source, "bl_parent_id", "")
    if parent:
        body["bl_parent_id"] = parent.replace("CYCLES", "GRIDGATHER", 1)
    return type(name.replace("CYCLES", "GRIDGATHER", 1), (Panel,), body)


def _shared():
    return [
        panel
        for panel in Panel.__subclasses__()
        if "BLENDER_RENDER" in getattr(panel, "COMPAT_ENGINES", ()) and panel.__name__ not in _EXCLUDED
    ]


def register() -> None:
    for panel in _shared():
        panel.COMPAT_ENGINES.add(_ENGINE)
    for cls in _classes:
        bpy.utils.register_class(cls)
    for name, needs in _FROM_CYCLES.items():
        if hasattr(bpy.types, name):  # Cycles can be switched off
            _from_cycles.append(_panel_from_cycles(name, needs))
            bpy.utils.register_class(_from_cycles[-1])


def unregister() -> None:
    while _from_cycles:
        bpy.utils.unregister_class(_from_cycles.pop())
    for cls in reversed(_classes):
        bpy.utils.unregister_class(cls)
    for panel in _shared():
        panel.COMPAT_ENGINES.discard(_ENGINE)
