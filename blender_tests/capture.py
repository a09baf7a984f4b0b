"""A render engine that only exports: tests see what F12 would give the library, through a depsgraph for rendering."""

import bpy
from building import link, quad
from gridgather.export.scene import export_frame


class CaptureEngine(bpy.types.RenderEngine):
    bl_idname = "GRIDGATHER_CAPTURE"
    bl_label = "Capture"
    frame = None
    error = None

    def update(self, data=None, depsgraph=None):
        CaptureEngine.frame = CaptureEngine.error = None
        try:
            CaptureEngine.frame = export_frame(depsgraph, self.resolution_x, self.resolution_y)
        except Exception as error:
            CaptureEngine.error = error

    def render(self, depsgraph):
        self.end_result(self.begin_result(0, 0, self.resolution_x, self.resolution_y, layer=depsgraph.view_layer.name))


def export():
    """The description.Frame of the current scene; raises what its export raises."""
    bpy.context.scene.render.engine = CaptureEngine.bl_idname
    bpy.ops.render.render()
    if CaptureEngine.error is not None:
        raise CaptureEngine.error
    return CaptureEngine.frame


def exported(source):
    """(description.Material, Frame) of a material that one quad wears."""
    mesh = quad()
    mesh.uv_layers.new(name="UVMap")
    mesh.materials.append(source)
    link(mesh)
    frame = export()
    return frame.scene.materials[0], frame
