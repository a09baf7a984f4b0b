"""The render engine as Blender sees it: exports, starts the library, copies its tiles, and never lets an error pass."""

import contextlib
import time
import traceback

import bpy
import numpy as np

from . import messages, passes
from .compat import write_pixels
from .export import ExportCancelledError, ExportError
from .export.scene import export_frame
from .interface import CANCELLED, OK, LibraryError
from .session import Scene, SessionError
from .upload import upload

_POLL_SECONDS = 0.03
_REDRAW_SECONDS = 1.0  # between copies of the unfinished picture to Blender
_EXPECTED = (ExportError, LibraryError, SessionError)  # their text is for the user as it is


@contextlib.contextmanager
def _reporting(engine):
    """An exception that leaves a callback makes Blender save a black picture and call it a success: report it."""
    try:
        yield
    except ExportCancelledError:
        pass
    except _EXPECTED as error:
        engine.report({"ERROR"}, str(error))
    except Exception as error:
        engine.report({"ERROR"}, f"Gridgather failed: {type(error).__name__}: {error}")
        traceback.print_exc()


class GridgatherEngine(bpy.types.RenderEngine):
    bl_idname = "GRIDGATHER"
    bl_label = "Gridgather"
    bl_use_preview = False
    bl_use_eevee_viewport = True
    bl_use_shading_nodes_custom = False

    def __init__(self, *args, **kwargs):
        super().__init__(*args, **kwargs)
        self.frame = None
        self.layers = {}  # statistics of this frame's view layers

    def update_render_passes(self, scene=None, renderlayer=None):
        """For the compositor's sockets and multilayer files."""
        with _reporting(self):
            self.register_pass(scene, renderlayer, "Combined", 4, "RGBA", "COLOR")
            for name in passes.enabled(renderlayer):
                self.register_pass(scene, renderlayer, name, 1, "X", "VALUE")

    def update(self, data=None, depsgraph=None):
        self.frame = None
        with _reporting(self):
            self.update_stats("", "Exporting")
            size = self.resolution_x, self.resolution_y
            self.frame = export_frame(depsgraph, *size, self.camera_override, self.test_break)

    def render(self, depsgraph):
        with _reporting(self):
            frame, self.frame = self.frame, None
            for name in passes.enabled(depsgraph.view_layer):
                self.add_pass(name, 1, "X", layer=depsgraph.view_layer.name)
            result = self.begin_result(0, 0, self.resolution_x, self.resolution_y, layer=depsgraph.view_layer.name)
            try:
                # After a failed or cancelled update() there is nothing to render; both were reported there.
                if frame is not None:
                    self._render_frame(depsgraph, frame, result)
            finally:
                self.end_result(result, cancel=frame is None or self.test_break())  # without it EXR output ends Blender

    def render_frame_finish(self):
        self.layers = {}

    def _render_frame(self, depsgraph, frame, result):
        width, height = result.resolution_x, result.resolution_y
        frame.settings.crop = (*frame.settings.crop[:2], width, height)
        pixels = {"Combined": np.zeros((height, width, 4), np.float32)}
        if frame.settings.passes:
            pixels |= {name: np.zeros((height, width, 1), np.float32) for name in passes.enabled(depsgraph.view_layer)}
        found = [(name, text, 1) for name, text in frame.scene.messages]
        try:
            start = time.perf_counter()
            with Scene() as scene:
                upload(frame.scene, scene)
                uploaded = time.perf_counter() - start
                capture_path = depsgraph.scene.gridgather.capture_path
                if capture_path:
                    scene.capture(frame.camera, frame.settings, bpy.path.abspath(capture_path))
                with scene.start(frame.camera, frame.settings) as render:
                    status = self._wait(render, result, pixels)
                    found = render.messages()
                    if status == OK:
                        statistics = render.statistics()
                        statistics.setdefault("stages", {}).update(export=frame.seconds, upload=uploaded)
                        self._keep_statistics(depsgraph, statistics)
                    elif status != CANCELLED:
                        raise SessionError(render.error())
        finally:
            summary = messages.keep(depsgraph.scene, found)
            if summary:
                self.report({"WARNING"}, summary)

    def _wait(self, render, result, pixels) -> int:
        """Until the render is finished: shows what is done, passes a cancel on. Returns the render's status."""
        targets = [each for each in result.layers[0].passes if each.name in pixels]  # one a stereo view
        stage, drawn, changed = "", time.perf_counter(), False
        while True:
            progress = render.wait(_POLL_SECONDS)
            if self.test_break():
                render.cancel()
            if progress.stage != stage:
                stage = progress.stage
                self.update_stats("", f"{stage.decode()} | Memory {progress.memory / 2**20:.0f} MB")
            self.update_progress(progress.fraction)
            self.update_memory_stats(memory_used=progress.memory / 2**20, memory_peak=progress.peak_memory / 2**20)
            changed |= render.copy_finished_tiles(pixels)
            if changed and (progress.finished or time.perf_counter() - drawn > _REDRAW_SECONDS):
                for target in targets:
                    write_pixels(target, pixels[target.name])
                self.update_result(result)
                drawn, changed = time.perf_counter(), False
            if progress.finished:
                return progress.status

    def _keep_statistics(self, depsgraph, statistics: dict) -> None:
        self.layers[depsgraph.view_layer.name] = statistics
        text = messages.keep_statistics(depsgraph.scene, self.layers)
        # Fields reach the file's metadata only from the whole result, not from the part that begin_result gives.
        self.get_result().stamp_data_add_field("gridgather_statistics", text)


def register() -> None:
    bpy.utils.register_class(GridgatherEngine)


def unregister() -> None:
    bpy.utils.unregister_class(GridgatherEngine)
