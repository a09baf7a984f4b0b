"""Images of the attic as arrays (height, width, 3), sRGB-encoded 0..1, made by arithmetic alone."""
import numpy as np
from scene_pictures import grain, noise


def boards(width, height, rows, colour, seed, contrast=0.26, joint=2):
    """Old planks along x, `rows` of them across the image, with butt joints, nails and stains."""
    random = np.random.default_rng(seed)
    deep = height // rows
    made = np.empty((rows * deep, width, 3))
    for row in range(rows):
        end = int(random.random() * width)
        tone = np.empty((deep, width, 3))
        for start, stop in ((0, end), (end, width)):
            if stop == start:
                continue
            shade = np.array(colour) * random.uniform(0.84, 1.10) + random.uniform(-0.012, 0.012, 3)
            lines = grain(deep, stop - start, random.integers(1 << 30))
            tone[:, start:stop] = shade * (1 - contrast / 2 + contrast * (lines - 0.5))[..., None]
            for nail in (start + 14, stop - 14):
                for side in (deep // 5, deep - deep // 5):
                    tone[side - 1:side + 2, max(nail - 1, 0):nail + 2] *= 0.45
        tone[:, max(end - 1, 0):end + 1] *= 0.5
        tone[:joint] *= 0.42
        made[row * deep:(row + 1) * deep] = tone
    stains = noise(rows * deep, width, 5, 5, seed + 90) * 0.6 + noise(rows * deep, width, 17, 13, seed + 91) * 0.4
    return made * (0.88 + 0.22 * stains)[..., None]


def old_rug(width, height):
    """A red carpet with a border and a field of medallions, worn in the middle."""
    y, x = np.mgrid[0:height, 0:width] / width
    tall = height / width
    edge = np.minimum(np.minimum(x, 1 - x), np.minimum(y, tall - y))
    cell = 0.25
    across, along = (x / cell) % 1 - 0.5, (y / cell) % 1 - 0.5
    flower = np.hypot(across, along) + 0.10 * np.cos(8 * np.arctan2(along, across))
    lattice = np.abs(np.abs(across) + np.abs(along) - 0.5)
    red, blue, cream, ochre = (np.array(c) for c in ((0.55, 0.20, 0.16), (0.20, 0.26, 0.40), (0.83, 0.77, 0.64),
                                                     (0.72, 0.54, 0.30)))
    made = np.broadcast_to(red, (height, width, 3)).copy()
    made[lattice < 0.035] = ochre
    made[flower < 0.26] = blue
    made[flower < 0.16] = cream
    made[flower < 0.07] = red
    made[edge < 0.13] = blue
    leaf = (np.hypot(((x + y) / 0.07) % 1 - 0.5, ((x - y) / 0.07) % 1 - 0.5) < 0.3) & (edge < 0.115) & (edge > 0.045)
    made[leaf] = ochre
    for low, high, colour in ((0.12, 0.132, cream), (0.03, 0.04, cream), (0.0, 0.016, red)):
        made[(edge >= low) & (edge < high)] = colour
    thread = 0.90 + 0.10 * np.sin(x * np.pi * 300) * np.sin(y * np.pi * 300)
    wear = noise(height, width, 6, 5, 71) * 0.6 + noise(height, width, 40, 30, 72) * 0.4
    return np.clip(made * (thread * (0.80 + 0.30 * wear))[..., None] + 0.05 * wear[..., None], 0, 1)


def cardboard(size):
    """Brown board with faint ribs and a strip of tape along the middle."""
    y, x = np.mgrid[0:size, 0:size] / size
    ribs = 1 + 0.025 * np.sin(x * np.pi * 160)
    stain = 0.90 + 0.16 * noise(size, size, 6, 6, 51)
    made = np.array((0.66, 0.52, 0.37)) * (ribs * stain)[..., None]
    made[np.abs(y - 0.5) < 0.045] *= np.array((1.12, 1.10, 1.02))
    return made


def leather(size):
    """The worn cover of a trunk."""
    patches = noise(size, size, 8, 8, 61) * 0.5 + noise(size, size, 60, 60, 62) * 0.5
    return np.array((0.36, 0.25, 0.17)) * (0.72 + 0.5 * patches)[..., None]
