"""Blender to description: the half of the export that knows nothing of the library."""


class ExportError(Exception):
    """Nothing can be rendered; the text says why."""


class ExportCancelledError(Exception):
    """The user stopped the render during the export."""
