"""A scene as plain data, between Blender and the library: knows neither bpy nor ctypes.

Units, shapes and meanings are those of native/include/gridgather.h. Indices (images, materials, meshes) count entries
of the lists in Scene.
"""

from dataclasses import dataclass, field

import numpy as np

NONE = 0xFFFFFFFF  # no image, no material

COLOR_SRGB, COLOR_LINEAR = 0, 1
EXTENSION_REPEAT, EXTENSION_EXTEND, EXTENSION_CLIP, EXTENSION_MIRROR = range(4)
FILTER_LINEAR, FILTER_CLOSEST = 0, 1
HIDDEN_FROM_CAMERA, HIDDEN_FROM_LIGHT = 1, 2
LIGHT_POINT, LIGHT_SPOT, LIGHT_SUN, LIGHT_AREA = range(4)
AREA_RECTANGLE, AREA_ELLIPSE = 0, 1
CAMERA_PERSPECTIVE, CAMERA_ORTHOGRAPHIC = 0, 1
METHOD_GATHER, METHOD_SOLUTION, METHOD_FULL = 0, 1, 2
SITES_SURFACES_AND_GRID, SITES_GRID = 0, 1
RECEIVERS_VISIBLE, RECEIVERS_FREE_SPACE = 0, 1
DEPTH_LOGARITHMIC, DEPTH_RECIPROCAL = 0, 1
PIXEL_BLACKMAN_HARRIS, PIXEL_GAUSS, PIXEL_BOX = range(3)

IDENTITY_UV = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0)


@dataclass
class Image:
    """A file when path is set, else pixels: float32 (height, width, 4), bottom row first."""

    name: str
    path: str | None = None
    pixels: np.ndarray | None = None
    color_space: int = COLOR_SRGB
    extension: int = EXTENSION_REPEAT
    filter_mode: int = FILTER_LINEAR


@dataclass(frozen=True)
class Color:
    """factor, times the image at uv_map (2x3, row-major) of the texture coordinates when there is one."""

    factor: tuple[float, float, float] = (0.0, 0.0, 0.0)
    image: int = NONE
    uv_map: tuple[float, ...] = IDENTITY_UV

    def scaled(self, scale: "float | tuple[float, float, float]") -> "Color":
        scale = scale if isinstance(scale, tuple) else (scale,) * 3
        return Color(tuple(f * s for f, s in zip(self.factor, scale, strict=True)), self.image, self.uv_map)

    @property
    def is_black(self) -> bool:
        return not any(self.factor)


BLACK = Color()


@dataclass
class Material:
    name: str
    reflectance: Color = BLACK
    emission: Color = BLACK  # radiance, W/(m2 sr)


@dataclass
class Mesh:
    """Triangles in Blender's layout: corners are loops. Arrays that are None read as in gg_mesh."""

    name: str
    positions: np.ndarray  # float32 (vertices, 3)
    triangle_vertices: np.ndarray  # uint32 (triangles, 3)
    triangle_corners: np.ndarray | None = None  # uint32 (triangles, 3)
    triangle_slots: np.ndarray | None = None  # uint32 (triangles)
    corner_count: int = 0
    corner_normals: np.ndarray | None = None  # float32 (corner_count, 3)
    corner_uvs: np.ndarray | None = None  # float32 (corner_count, 2)
    uv_name: str = ""  # the map that corner_uvs is


@dataclass
class InstanceGroup:
    """Placed meshes that share one list of materials (by slot)."""

    materials: tuple[int, ...]
    meshes: list[int] = field(default_factory=list)
    matrices: list[tuple[float, ...]] = field(default_factory=list)  # 12 floats, 3x4
    stable_ids: list[int] = field(default_factory=list)
    flags: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)


@dataclass
class Light:
    name: str
    type: int
    matrix: tuple[float, ...]  # 12 floats, 3x4
    power: tuple[float, float, float]
    stable_id: int
    radius: float = 0.0
    soft_falloff: bool = False
    size_x: float = 0.0
    size_y: float = 0.0
    shape: int = AREA_RECTANGLE
    spot_angle: float = 0.0
    spot_blend: float = 0.0
    angle: float = 0.0


@dataclass
class Camera:
    type: int
    matrix: tuple[float, ...]  # 12 floats, 3x4
    window: tuple[float, float, float, float]  # x_left, x_right, y_bottom, y_top
    clip_start: float
    clip_end: float


@dataclass
class Curves:
    """See gg_curves."""

    values: np.ndarray  # float32 (3, n)
    range: tuple[float, float]
    slopes: tuple[float, ...]  # 6
    black: tuple[float, float, float]
    white: tuple[float, float, float]


@dataclass
class Display:
    config: str = ""  # path; "": sRGB
    device: str = ""
    view: str = ""
    look: str = ""
    exposure: float = 0.0  # stops
    gamma: float = 1.0
    white: float = 100.0  # cd/m2
    black: float = 0.2  # cd/m2
    pixels_per_degree: float = 40.0
    curves: Curves | None = None


@dataclass
class Settings:
    width: int
    height: int
    crop: tuple[int, int, int, int]  # x, y, width, height from the lower left
    method: int = METHOD_GATHER
    quality: float = 0.02
    samples: int = 16
    filter_width: float = 1.5
    filter_type: int = PIXEL_BLACKMAN_HARRIS
    exposure: float = 1.0
    film_transparent: bool = False
    threads: int = 0
    passes: int = 0  # bits, see passes.py
    sites: int = SITES_SURFACES_AND_GRID
    receivers: int = RECEIVERS_VISIBLE
    depth_law: int = DEPTH_LOGARITHMIC
    cell_size: float = 20.0
    threshold: float = 0.03
    gather_samples: int = 512
    display: Display | None = None  # on which errors are judged; None: by `threshold`
    noticeable: float = 0.25
    use_masking: bool = False


@dataclass
class Scene:
    images: list[Image] = field(default_factory=list)
    materials: list[Material] = field(default_factory=list)
    meshes: list[Mesh] = field(default_factory=list)
    instances: list[InstanceGroup] = field(default_factory=list)
    lights: list[Light] = field(default_factory=list)
    world: tuple[float, float, float] = (0.0, 0.0, 0.0)
    messages: list[tuple[str, str]] = field(default_factory=list)  # (object, what could not be converted)

    def say(self, name: str, text: str) -> None:
        """Notes once that something of `name` could not be converted."""
        if (name, text) not in self.messages:
            self.messages.append((name, text))


@dataclass
class Frame:
    """All that one view layer of one frame needs."""

    scene: Scene
    camera: Camera
    settings: Settings
    seconds: float = 0.0  # what the export took
