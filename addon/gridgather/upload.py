"""Description to library: the half of the export that knows nothing of Blender."""

import ctypes

import numpy as np

from . import description, interface
from .session import Scene


def upload(scene: description.Scene, target: Scene) -> None:
    """Fills the empty native scene. Takes the big arrays out of `scene` on the way, to hold them once."""
    target.check(target.library.gg_scene_set_world(target.pointer, (ctypes.c_float * 3)(*scene.world)))
    for name, text in scene.messages:
        target.check(target.library.gg_scene_add_message(target.pointer, _text(name), _text(text)))
    image_ids = [_add_image(target, image) for image in _drain(scene.images)]
    material_ids = [_add_material(target, material, image_ids) for material in scene.materials]
    mesh_ids = [_add_mesh(target, mesh) for mesh in _drain(scene.meshes)]
    for group in _drain(scene.instances):
        _add_instances(target, group, mesh_ids, material_ids)
    for light in scene.lights:
        _add_light(target, light)


def _drain(items: list):
    items.reverse()
    while items:
        yield items.pop()


def _text(text: str) -> bytes:
    return text.encode("utf-8", "replace")


class _Arrays(list):
    """Makes pointers for a struct and keeps what they point to alive; null for None."""

    def pointer(self, values, dtype, ctype):
        if values is None:
            return None
        self.append(np.ascontiguousarray(values, dtype))
        return self[-1].ctypes.data_as(ctypes.POINTER(ctype))

    def floats(self, values):
        return self.pointer(values, np.float32, ctypes.c_float)

    def uints(self, values):
        return self.pointer(values, np.uint32, ctypes.c_uint32)


def _add_image(target: Scene, image: description.Image) -> int:
    arrays = _Arrays()
    height, width = (0, 0) if image.pixels is None else image.pixels.shape[:2]
    return target.add(
        "image",
        interface.Image(
            name=_text(image.name),
            path=None if image.path is None else _text(image.path),
            pixels=arrays.floats(image.pixels),
            width=width,
            height=height,
            color_space=image.color_space,
            extension=image.extension,
            filter_mode=image.filter_mode,
        ),
    )


def _color(color: description.Color, image_ids: list[int]) -> interface.ColorInput:
    return interface.ColorInput(
        factor=(ctypes.c_float * 3)(*color.factor),
        image=native_id(color.image, image_ids),
        uv_map=(ctypes.c_float * 6)(*color.uv_map),
    )


def native_id(index: int, ids: list[int]) -> int:
    """The library's id of a description's index; NONE stays NONE."""
    return description.NONE if index == description.NONE else ids[index]


def _add_material(target: Scene, material: description.Material, image_ids: list[int]) -> int:
    return target.add(
        "material",
        interface.Material(
            name=_text(material.name),
            reflectance=_color(material.reflectance, image_ids),
            emission=_color(material.emission, image_ids),
        ),
    )


def _add_mesh(target: Scene, mesh: description.Mesh) -> int:
    arrays = _Arrays()
    return target.add(
        "mesh",
        interface.Mesh(
            name=_text(mesh.name),
            vertex_count=len(mesh.positions),
            positions=arrays.floats(mesh.positions),
            triangle_count=len(mesh.triangle_vertices),
            triangle_vertices=arrays.uints(mesh.triangle_vertices),
            triangle_corners=arrays.uints(mesh.triangle_corners),
            triangle_slots=arrays.uints(mesh.triangle_slots),
            corner_count=mesh.corner_count,
            corner_normals=arrays.floats(mesh.corner_normals),
            corner_uvs=arrays.floats(mesh.corner_uvs),
        ),
    )


def _add_instances(target: Scene, group: description.InstanceGroup, mesh_ids: list[int], material_ids: list[int]):
    arrays, count = _Arrays(), len(group.meshes)
    struct = interface.Instances(
        count=count,
        meshes=arrays.uints([mesh_ids[mesh] for mesh in group.meshes]),
        matrices=arrays.floats(group.matrices),
        stable_ids=arrays.pointer(group.stable_ids, np.uint64, ctypes.c_uint64),
        flags=arrays.uints(group.flags),
        names=(ctypes.c_char_p * count)(*map(_text, group.names)),
        slot_count=len(group.materials),
        materials=arrays.uints([native_id(index, material_ids) for index in group.materials]),
    )
    target.check(target.library.gg_scene_add_instances(target.pointer, ctypes.byref(struct)))


def _add_light(target: Scene, light: description.Light) -> None:
    struct = interface.Light(
        name=_text(light.name),
        type=light.type,
        matrix=(ctypes.c_float * 12)(*light.matrix),
        power=(ctypes.c_float * 3)(*light.power),
        radius=light.radius,
        size_x=light.size_x,
        size_y=light.size_y,
        shape=light.shape,
        spot_angle=light.spot_angle,
        spot_blend=light.spot_blend,
        soft_falloff=int(light.soft_falloff),
        angle=light.angle,
        stable_id=light.stable_id,
    )
    target.check(target.library.gg_scene_add_light(target.pointer, ctypes.byref(struct)))
