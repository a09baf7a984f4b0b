"""Materials of Blender to diffuse reflectors and emitters."""

from .. import description
from ..compat import node_tree
from ..description import NONE, Color
from .image import ImageExport
from .nodes import follow
from .surface import SurfaceReader


class MaterialExport:
    """Collects each material once."""

    def __init__(self, scene: description.Scene):
        self._scene = scene
        self._images = ImageExport(scene)
        self._indices: dict[str, int] = {}
        self._uv_names: dict[int, set[str]] = {}

    def index(self, material) -> int:
        """Index of a material; NONE for None."""
        if material is None:
            return NONE
        if material.name_full not in self._indices:
            exported, uv_names = export_material(material, self._scene, self._images)
            index = len(self._scene.materials)
            self._scene.materials.append(exported)
            self._indices[material.name_full], self._uv_names[index] = index, uv_names
        return self._indices[material.name_full]

    def check_uv_map(self, materials, mesh: description.Mesh, name: str) -> None:
        """Says where a material asks for another UV map than the one that `mesh` brings along."""
        wanted = set().union(*(self._uv_names.get(index, set()) for index in materials))
        for uv_name in sorted(wanted - {mesh.uv_name}):
            self._scene.say(
                name, f"UV map {uv_name} is not the active one for rendering: {mesh.uv_name or 'none'} is used"
            )


def export_material(material, scene: description.Scene, images: ImageExport):
    """(description.Material, names of UV maps that its nodes ask for)."""
    tree = node_tree(material)
    reader = SurfaceReader(material.name, scene, images)
    if tree is None:
        return description.Material(material.name, Color(tuple(material.diffuse_color)[:3])), reader.uv_names
    output = tree.get_output_node("CYCLES")
    if output is None:
        reader.say("material has no output node: black is used")
        return description.Material(material.name), reader.uv_names
    for name in ("Volume", "Displacement"):
        if name in output.inputs and follow(output.inputs[name])[0] is not None:
            reader.say(f"{name} is ignored")
    reflectance, emission = reader.shader(output.inputs["Surface"])
    return description.Material(material.name, reflectance, emission), reader.uv_names
