"""What renders had to say: problems that did not stop them, and their statistics. Kept here, never in the scene."""

import json

import bpy

_messages: dict[str, list[tuple[str, str, int]]] = {}
_statistics: dict[str, str] = {}
_reported: dict[str, str] = {}  # per scene, so that an animation says things once


def of_scene(scene) -> list[tuple[str, str, int]]:
    """(object, text, how often) of the scene's last render."""
    return _messages.get(scene.name_full, [])


def keep(scene, messages: list[tuple[str, str, int]]) -> str:
    """Keeps a render's messages, equal ones as one. Returns a summary, "" when it was the scene's last one as well."""
    counts: dict[tuple[str, str], int] = {}
    for name, text, count in messages:
        counts[name, text] = counts.get((name, text), 0) + count
    _messages[scene.name_full] = [(name, text, count) for (name, text), count in counts.items()]
    summary = _summary(_messages[scene.name_full])
    if summary == _reported.get(scene.name_full):
        return ""
    _reported[scene.name_full] = summary
    return summary


def _summary(messages) -> str:
    if not messages:
        return ""
    lines = [line(*message) for message in messages]
    return f"Gridgather could not convert everything ({len(lines)}):\n" + "\n".join(f"  {text}" for text in lines)


def line(name: str, text: str, count: int) -> str:
    """A message as one line."""
    return f"{name}: {text}" + (f" ({count} times)" if count > 1 else "")


def keep_statistics(scene, layers: dict[str, dict]) -> str:
    """Keeps {view layer: statistics} of a scene's last frame; returns them as JSON."""
    _statistics[scene.name_full] = json.dumps(layers)
    return _statistics[scene.name_full]


def statistics_of_scene(scene) -> str:
    """JSON of the last frame's statistics, "" before the first."""
    return _statistics.get(scene.name_full, "")


@bpy.app.handlers.persistent
def _forget(*_) -> None:
    for kept in (_messages, _statistics, _reported):
        kept.clear()


def register() -> None:
    bpy.app.handlers.load_pre.append(_forget)


def unregister() -> None:
    bpy.app.handlers.load_pre.remove(_forget)
    _forget()
