"""native/include/gridgather.h in ctypes: structs, functions, and loading the library that lies beside this file."""

import ctypes
import os
from ctypes import POINTER, c_char, c_char_p, c_float, c_int, c_int32, c_uint32, c_uint64, c_void_p

INTERFACE_VERSION = 6
LIBRARY_PATH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "libgridgather.so")

OK, CANCELLED = 0, 1

_floats, _uints = POINTER(c_float), POINTER(c_uint32)


class LibraryError(Exception):
    """The library cannot be used on this machine; the text says why."""


class Image(ctypes.Structure):
    _fields_ = [
        ("name", c_char_p),
        ("path", c_char_p),
        ("pixels", _floats),
        ("width", c_uint32),
        ("height", c_uint32),
        ("color_space", c_int32),
        ("extension", c_int32),
        ("filter_mode", c_int32),
    ]


class ColorInput(ctypes.Structure):
    _fields_ = [("factor", c_float * 3), ("image", c_uint32), ("uv_map", c_float * 6)]


class Material(ctypes.Structure):
    _fields_ = [("name", c_char_p), ("reflectance", ColorInput), ("emission", ColorInput)]


class Mesh(ctypes.Structure):
    _fields_ = [
        ("name", c_char_p),
        ("vertex_count", c_uint32),
        ("positions", _floats),
        ("triangle_count", c_uint32),
        ("triangle_vertices", _uints),
        ("triangle_corners", _uints),
        ("triangle_slots", _uints),
        ("corner_count", c_uint32),
        ("corner_normals", _floats),
        ("corner_uvs", _floats),
    ]


class Instances(ctypes.Structure):
    _fields_ = [
        ("count", c_uint32),
        ("meshes", _uints),
        ("matrices", _floats),
        ("stable_ids", POINTER(c_uint64)),
        ("flags", _uints),
        ("names", POINTER(c_char_p)),
        ("slot_count", c_uint32),
        ("materials", _uints),
    ]


class Light(ctypes.Structure):
    _fields_ = [
        ("name", c_char_p),
        ("type", c_int32),
        ("matrix", c_float * 12),
        ("power", c_float * 3),
        ("radius", c_float),
        ("soft_falloff", c_int32),
        ("size_x", c_float),
        ("size_y", c_float),
        ("shape", c_int32),
        ("spot_angle", c_float),
        ("spot_blend", c_float),
        ("angle", c_float),
        ("stable_id", c_uint64),
    ]


class Camera(ctypes.Structure):
    _fields_ = [
        ("type", c_int32),
        ("matrix", c_float * 12),
        ("window", c_float * 4),
        ("clip_start", c_float),
        ("clip_end", c_float),
    ]


class Curves(ctypes.Structure):
    _fields_ = [
        ("values", ctypes.POINTER(c_float)),
        ("size", c_uint32),
        ("range", c_float * 2),
        ("slopes", c_float * 6),
        ("black", c_float * 3),
        ("white", c_float * 3),
    ]


class Display(ctypes.Structure):
    _fields_ = [
        ("config", c_char_p),
        ("device", c_char_p),
        ("view", c_char_p),
        ("look", c_char_p),
        ("exposure", c_float),
        ("gamma", c_float),
        ("white", c_float),
        ("black", c_float),
        ("pixels_per_degree", c_float),
        ("curves", ctypes.POINTER(Curves)),
    ]


class Settings(ctypes.Structure):
    _fields_ = [
        ("method", c_int32),
        ("width", c_uint32),
        ("height", c_uint32),
        ("crop", c_uint32 * 4),
        ("quality", c_float),
        ("samples", c_uint32),
        ("filter_width", c_float),
        ("filter_type", c_int32),
        ("exposure", c_float),
        ("film_transparent", c_int32),
        ("threads", c_int32),
        ("passes", c_uint32),
        ("sites", c_int32),
        ("receivers", c_int32),
        ("depth_law", c_int32),
        ("cell_size", c_float),
        ("threshold", c_float),
        ("gather_samples", c_uint32),
        ("display", POINTER(Display)),
        ("noticeable", c_float),
        ("use_masking", c_int32),
    ]


class Progress(ctypes.Structure):
    _fields_ = [
        ("finished", c_int32),
        ("status", c_int32),
        ("fraction", c_float),
        ("finished_tiles", c_uint32),
        ("tiles", c_uint32),
        ("memory", c_uint64),
        ("peak_memory", c_uint64),
        ("stage", c_char * 64),
    ]


class Tile(ctypes.Structure):
    _fields_ = [("x", c_uint32), ("y", c_uint32), ("width", c_uint32), ("height", c_uint32)]


class Message(ctypes.Structure):
    _fields_ = [("object", c_char * 128), ("text", c_char * 256), ("count", c_uint32)]


# Handles are void pointers. Functions that return c_int here return a gg_status.
_SIGNATURES = {
    "gg_interface_version": (c_uint32, []),
    "gg_version": (c_char_p, []),
    "gg_processor_supported": (c_int, []),
    "gg_last_error": (c_char_p, []),
    "gg_scene_create": (c_int, [POINTER(c_void_p)]),
    "gg_scene_destroy": (None, [c_void_p]),
    "gg_scene_add_image": (c_int, [c_void_p, POINTER(Image), _uints]),
    "gg_scene_add_material": (c_int, [c_void_p, POINTER(Material), _uints]),
    "gg_scene_add_mesh": (c_int, [c_void_p, POINTER(Mesh), _uints]),
    "gg_scene_add_instances": (c_int, [c_void_p, POINTER(Instances)]),
    "gg_scene_add_light": (c_int, [c_void_p, POINTER(Light)]),
    "gg_scene_set_world": (c_int, [c_void_p, _floats]),
    "gg_scene_add_message": (c_int, [c_void_p, c_char_p, c_char_p]),
    "gg_display_encode": (c_int, [POINTER(Display), _floats, c_uint64]),
    "gg_scene_capture": (c_int, [c_void_p, POINTER(Camera), POINTER(Settings), c_char_p]),
    "gg_render_start": (c_int, [c_void_p, POINTER(Camera), POINTER(Settings), POINTER(c_void_p)]),
    "gg_render_poll": (c_int, [c_void_p, POINTER(Progress)]),
    "gg_render_wait": (c_int, [c_void_p, c_float]),
    "gg_render_cancel": (c_int, [c_void_p]),
    "gg_render_error": (c_char_p, [c_void_p]),
    "gg_render_destroy": (None, [c_void_p]),
    "gg_render_next_tile": (c_int, [c_void_p, POINTER(Tile), POINTER(c_int32)]),
    "gg_render_read": (c_int, [c_void_p, c_char_p, POINTER(Tile), _floats]),
    "gg_render_statistics": (c_int, [c_void_p, POINTER(c_char_p)]),
    "gg_render_message": (c_int, [c_void_p, c_uint32, POINTER(Message), POINTER(c_int32)]),
}

_loaded: dict[str, ctypes.CDLL] = {}


def load() -> ctypes.CDLL:
    """The library, loaded once. Raises LibraryError when it is missing, of another version or for another processor."""
    if LIBRARY_PATH not in _loaded:
        _loaded[LIBRARY_PATH] = _load(LIBRARY_PATH)
    return _loaded[LIBRARY_PATH]


def _load(path: str) -> ctypes.CDLL:
    try:
        library = ctypes.CDLL(path)
        _bind(library, ("gg_processor_supported", "gg_interface_version"))
        if not library.gg_processor_supported():
            raise LibraryError("Gridgather's library needs a processor with AVX2 (most since 2013)")
        version = library.gg_interface_version()
        if version != INTERFACE_VERSION:
            raise LibraryError(
                f"Gridgather's library has interface version {version}, the add-on needs {INTERFACE_VERSION}: "
                "install both from one build"
            )
        _bind(library, _SIGNATURES)
    except (OSError, AttributeError) as error:
        raise LibraryError(f"Gridgather's library cannot be loaded: {error}") from error
    return library


def _bind(library: ctypes.CDLL, names) -> None:
    for name in names:
        function = getattr(library, name)
        function.restype, function.argtypes = _SIGNATURES[name]


def failure() -> str:
    """Why the library cannot be used, or "" when it can."""
    try:
        load()
    except LibraryError as error:
        return str(error)
    return ""
