"""Registering, panels, the manifest."""

from types import SimpleNamespace
from unittest.mock import MagicMock

import addon_utils
import bpy
import pytest
from gridgather import bl_info, interface, messages, panels, passes
from nodeitems_utils import node_categories_iter


def shared_panels():
    every = bpy.types.Panel.__subclasses__()
    return {panel.__name__ for panel in every if "GRIDGATHER" in getattr(panel, "COMPAT_ENGINES", ())}


def test_unregister_undoes_register(scene):
    scene.render.engine = "BLENDER_WORKBENCH"
    before = shared_panels()
    addon_utils.disable("gridgather")
    try:
        assert shared_panels() == set()
        assert not [name for name in dir(bpy.types) if name.startswith("GRIDGATHER_PT")]
        assert not hasattr(bpy.types.Scene, "gridgather") and not hasattr(bpy.types.Scene, "gridgather_statistics")
        with pytest.raises(TypeError):
            scene.render.engine = "GRIDGATHER"
    finally:
        addon_utils.enable("gridgather")
    assert shared_panels() == before
    scene.render.engine = "GRIDGATHER"


def test_panels_of_blender_are_shared():
    assert {"RENDER_PT_format", "RENDER_PT_output", "RENDER_PT_color_management"} <= shared_panels()
    assert {"DATA_PT_lens", "DATA_PT_context_light", "WORLD_PT_context_world"} <= shared_panels()
    assert "DATA_PT_light" not in shared_panels()


def drawn(panel, **context):
    """The layout that a panel drew into."""
    layout = MagicMock()
    context = {"scene": bpy.context.scene, "engine": "GRIDGATHER", **context}
    panel.draw(SimpleNamespace(layout=layout), SimpleNamespace(**context))
    return layout


def labels(layout):
    return [call.kwargs["text"] for call in layout.label.call_args_list]


def test_settings_panel():
    layout = drawn(panels.GRIDGATHER_PT_settings)
    assert [call.args[1] for call in layout.prop.call_args_list][:4] == ["preset", "method", "quality", "samples"]
    assert labels(layout) == []


def test_gather_panel():
    layout = drawn(panels.GRIDGATHER_PT_gather)
    names = [call.args[1] for call in (*layout.prop.call_args_list, *layout.column().prop.call_args_list)]
    assert names == ["gather_samples", "threshold", "cell_size", "use_surface_sites", "receivers", "depth_law"]


def test_diagnostic_passes_panel():
    layout = drawn(panels.GRIDGATHER_PT_diagnostic_passes, view_layer=bpy.context.view_layer)
    assert [call.args[1] for call in layout.column().prop.call_args_list] == list(passes.PROPERTIES)


def test_settings_panel_and_preferences_say_why_the_library_is_missing(monkeypatch, tmp_path):
    assert labels(drawn(panels.GridgatherPreferences))[0].startswith("Library 0.")
    monkeypatch.setattr(interface, "LIBRARY_PATH", str(tmp_path / "gone.so"))
    for panel in (panels.GRIDGATHER_PT_settings, panels.GridgatherPreferences):
        assert "cannot be loaded" in labels(drawn(panel))[0]


def test_messages_panel(scene):
    assert "Everything" in labels(drawn(panels.GRIDGATHER_PT_messages))[0]
    messages.keep(scene, [("Cube", "is odd", 1), ("Cube", "is odd", 2), ("Lamp", "is off", 1)])
    assert labels(drawn(panels.GRIDGATHER_PT_messages)) == ["Cube: is odd (3 times)", "Lamp: is off"]


@pytest.mark.parametrize("name", ["MATERIAL_PT_surface", "LIGHT_PT_light", "WORLD_PT_surface", "OBJECT_PT_visibility"])
def test_panels_taken_from_cycles(name):
    panel = getattr(bpy.types, f"GRIDGATHER_{name}")
    needs = name.split("_")[0].lower()
    assert panel.poll(SimpleNamespace(engine="GRIDGATHER", **{needs: object()}))
    assert not panel.poll(SimpleNamespace(engine="GRIDGATHER", **{needs: None}))
    assert not panel.poll(SimpleNamespace(engine="CYCLES", **{needs: object()}))


def test_shader_nodes_can_be_added():
    editor = SimpleNamespace(type="NODE_EDITOR", tree_type="ShaderNodeTree")
    context = SimpleNamespace(engine="GRIDGATHER", space_data=editor)
    own = [category for category in node_categories_iter(context) if category.identifier == "GRIDGATHER"]
    assert len(own) == (bpy.app.version < (4, 0, 0))
    for category in own:
        assert "ShaderNodeBsdfPrincipled" in {item.nodetype for item in category.items(context)}
        assert not category.poll(SimpleNamespace(engine="CYCLES", space_data=editor))


def test_manifest_and_bl_info_agree():
    import tomllib

    with open(panels.__file__.replace("panels.py", "blender_manifest.toml"), "rb") as file:
        manifest = tomllib.load(file)
    assert manifest["version"] == ".".join(map(str, bl_info["version"]))
    assert manifest["name"] == bl_info["name"] and manifest["id"] == "gridgather"
    assert manifest["tagline"] == bl_info["description"] and len(manifest["tagline"]) <= 64
