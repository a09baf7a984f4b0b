"""Scenes and renders of the library as Python objects that free what they hold. Knows nothing of Blender."""

import ctypes
import json
import os

import numpy as np

from . import interface
from .description import Camera, Curves, Display, Settings


class SessionError(Exception):
    """A call of the library failed; the text is the library's."""


class _Handle:
    """A native object, destroyed by close() or at the end of a with block."""

    def __init__(self, library, destroy):
        self.library = library
        self.pointer = ctypes.c_void_p()
        self._destroy = destroy

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self) -> None:
        if self.pointer:
            self._destroy(self.pointer)
            self.pointer = ctypes.c_void_p()

    def check(self, status: int) -> None:
        """Raises SessionError for a status that is not OK."""
        if status != interface.OK:
            raise SessionError(self.library.gg_last_error().decode("utf-8", "replace"))


def _native_display(display: Display) -> interface.Display:
    return interface.Display(
        *(text.encode() for text in (display.config, display.device, display.view, display.look)),
        display.exposure,
        display.gamma,
        display.white,
        display.black,
        display.pixels_per_degree,
        ctypes.pointer(_native_curves(display.curves)) if display.curves else None,
    )


def _native_curves(curves: Curves) -> interface.Curves:
    return interface.Curves(
        values=(ctypes.c_float * curves.values.size)(*curves.values.ravel()),  # ctypes keeps an array alive
        size=curves.values.shape[1],
        range=curves.range,
        slopes=curves.slopes,
        black=curves.black,
        white=curves.white,
    )


def _native_camera(camera: Camera) -> interface.Camera:
    return interface.Camera(
        type=camera.type,
        matrix=(ctypes.c_float * 12)(*camera.matrix),
        window=(ctypes.c_float * 4)(*camera.window),
        clip_start=camera.clip_start,
        clip_end=camera.clip_end,
    )


def _native_settings(settings: Settings) -> interface.Settings:
    display = _native_display(settings.display) if settings.display else None
    return interface.Settings(
        method=settings.method,
        width=settings.width,
        height=settings.height,
        crop=(ctypes.c_uint32 * 4)(*settings.crop),
        quality=settings.quality,
        samples=settings.samples,
        filter_width=settings.filter_width,
        filter_type=settings.filter_type,
        exposure=settings.exposure,
        film_transparent=int(settings.film_transparent),
        threads=settings.threads,
        passes=settings.passes,
        sites=settings.sites,
        receivers=settings.receivers,
        depth_law=settings.depth_law,
        cell_size=settings.cell_size,
        threshold=settings.threshold,
        gather_samples=settings.gather_samples,
        display=ctypes.pointer(display) if display else None,
        noticeable=settings.noticeable,
        use_masking=int(settings.use_masking),
    )


def encode_for_display(display: Display, pixels: np.ndarray) -> np.ndarray:
    """What the display gets, 0..1, for scene-linear pixels, float32 (..., 3). Raises SessionError if the configuration
    cannot be used."""
    encoded = np.array(pixels, np.float32, order="C")
    library = interface.load()
    status = library.gg_display_encode(
        ctypes.byref(_native_display(display)),
        encoded.ctypes.data_as(ctypes.POINTER(ctypes.c_float)),
        encoded.size // 3,
    )
    if status != interface.OK:
        raise SessionError(library.gg_last_error().decode("utf-8", "replace"))
    return encoded


class Scene(_Handle):
    """An empty scene. upload.py fills it; start() freezes it."""

    def __init__(self):
        library = interface.load()
        super().__init__(library, library.gg_scene_destroy)
        self.check(library.gg_scene_create(ctypes.byref(self.pointer)))

    def add(self, function: str, struct) -> int:
        """Calls gg_scene_add_{function} that gives an id; returns the id."""
        number = ctypes.c_uint32()
        call = getattr(self.library, f"gg_scene_add_{function}")
        self.check(call(self.pointer, ctypes.byref(struct), ctypes.byref(number)))
        return number.value

    def capture(self, camera: Camera, settings: Settings, path: str) -> None:
        """Writes all that start() would take into a file."""
        self.check(
            self.library.gg_scene_capture(
                self.pointer,
                ctypes.byref(_native_camera(camera)),
                ctypes.byref(_native_settings(settings)),
                os.fsencode(path),
            )
        )

    def start(self, camera: Camera, settings: Settings) -> "Render":
        """Starts a render, which must be closed before the scene."""
        return Render(self, camera, settings)


class Render(_Handle):
    """A running or finished render."""

    def __init__(self, scene: Scene, camera: Camera, settings: Settings):
        super().__init__(scene.library, scene.library.gg_render_destroy)
        self.width, self.height = settings.crop[2:]
        self.check(
            self.library.gg_render_start(
                scene.pointer,
                ctypes.byref(_native_camera(camera)),
                ctypes.byref(_native_settings(settings)),
                ctypes.byref(self.pointer),
            )
        )

    def wait(self, seconds: float) -> interface.Progress:
        """Sleeps until the render is finished, at most `seconds`; says how far it is."""
        self.check(self.library.gg_render_wait(self.pointer, seconds))
        progress = interface.Progress()
        self.check(self.library.gg_render_poll(self.pointer, ctypes.byref(progress)))
        return progress

    def cancel(self) -> None:
        self.check(self.library.gg_render_cancel(self.pointer))

    def error(self) -> str:
        """What went wrong with a finished render."""
        return self.library.gg_render_error(self.pointer).decode("utf-8", "replace")

    def copy_finished_tiles(self, pixels: dict[str, np.ndarray]) -> bool:
        """Copies tiles that finished since the last call. pixels: by name of the pass, float32 (height, width, 4) of
        the crop for "Combined", (height, width, 1) for others, bottom row first. True when there were any."""
        tile, found, copied = interface.Tile(), ctypes.c_int32(), False
        while True:
            self.check(self.library.gg_render_next_tile(self.pointer, ctypes.byref(tile), ctypes.byref(found)))
            if not found.value:
                return copied
            for name, whole in pixels.items():
                part = np.empty((tile.height, tile.width, whole.shape[-1]), np.float32)
                target = part.ctypes.data_as(ctypes.POINTER(ctypes.c_float))
                self.check(self.library.gg_render_read(self.pointer, name.encode(), ctypes.byref(tile), target))
                whole[tile.y : tile.y + tile.height, tile.x : tile.x + tile.width] = part
            copied = True

    def statistics(self) -> dict:
        """The finished render's {"stages": ..., "counts": ..., "memory": ...}."""
        text = ctypes.c_char_p()
        self.check(self.library.gg_render_statistics(self.pointer, ctypes.byref(text)))
        return json.loads(text.value.decode("utf-8", "replace"))

    def messages(self) -> list[tuple[str, str, int]]:
        """Recoverable problems: (object, text, how often)."""
        message, found, result = interface.Message(), ctypes.c_int32(), []
        while True:
            call = self.library.gg_render_message
            self.check(call(self.pointer, len(result), ctypes.byref(message), ctypes.byref(found)))
            if not found.value:
                return result
            name, text = (part.decode("utf-8", "replace") for part in (message.object, message.text))
            result.append((name, text, message.count))
