"""Gridgather: radiosity for Blender."""

bl_info = {
    "name": "Gridgather",
    "author": "Gridgather developers",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "Properties > Render > Render Engine",
    "description": "Noise-free diffuse global illumination by hierarchical radiosity",
    "category": "Render",
}


def _modules():
    """What registers, in this order. Imported only now: the half of the add-on that knows no Blender works without."""
    from . import engine, messages, node_menu, panels, passes, properties

    return (messages, properties, passes, engine, panels, node_menu)


def register():
    for module in _modules():
        module.register()


def unregister():
    for module in reversed(_modules()):
        module.unregister()
