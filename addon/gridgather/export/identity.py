"""Ids and matrices of placed things."""

from hashlib import blake2b

_UNUSED = 2147483647  # fills Blender's persistent_id


def stable_id(instance) -> int:
    """64 bits that stay the same for the same DepsgraphObjectInstance in every frame, session and machine."""
    parts = [instance.object.name_full]
    if instance.is_instance:
        parts.append(instance.parent.name_full)
        parts.extend(str(number) for number in instance.persistent_id if number != _UNUSED)
    return int.from_bytes(blake2b("\0".join(parts).encode("utf-8", "replace"), digest_size=8).digest(), "little")


def distinct_id(wanted: int, taken: set[int]) -> int:
    """`wanted`, or the next number that is not taken yet; takes it."""
    while wanted in taken:
        wanted = (wanted + 1) & 0xFFFFFFFFFFFFFFFF
    taken.add(wanted)
    return wanted


def rows(matrix) -> tuple[float, ...]:
    """A 4x4 matrix as the 12 floats of its first three rows."""
    return (*matrix[0], *matrix[1], *matrix[2])
