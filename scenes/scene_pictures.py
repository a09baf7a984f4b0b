"""Images of the scenes as arrays (height, width, 3), sRGB-encoded 0..1, made by arithmetic alone."""
import numpy as np


def noise(height, width, cells_y, cells_x, seed):
    """Smooth noise 0..1 that tiles: random values on a grid, blended by smoothstep."""
    grid = np.random.default_rng(seed).random((cells_y, cells_x))
    y, x = np.arange(height) * cells_y / height, np.arange(width) * cells_x / width
    row, column = y.astype(int), x.astype(int)
    v, u = (y - row)[:, None], (x - column)[None, :]
    v, u = v * v * (3 - 2 * v), u * u * (3 - 2 * u)
    below, right = (row + 1) % cells_y, (column + 1) % cells_x
    low = grid[np.ix_(row, column)] * (1 - u) + grid[np.ix_(row, right)] * u
    high = grid[np.ix_(below, column)] * (1 - u) + grid[np.ix_(below, right)] * u
    return low * (1 - v) + high * v


def grain(height, width, seed):
    """Lines of wood along x, 0..1."""
    coarse = noise(height, width, max(height // 24, 2), 3, seed)
    fine = noise(height, width, max(height // 3, 2), 8, seed + 1)
    rings = 0.5 + 0.5 * np.sin(2 * np.pi * (6 * coarse + 1.5 * noise(height, width, 4, 4, seed + 2)))
    return np.clip(0.45 * rings + 0.55 * fine, 0, 1)


def wood(size, colour, seed):
    """One piece of wood."""
    return np.array(colour) * (0.78 + 0.3 * grain(size, size, seed))[..., None]


def oak_floor(size, rows=16):
    """Planks along x, `rows` of them across the image, their ends staggered; dark joints."""
    random = np.random.default_rng(1)
    plank, joint = size // rows, max(size // 1024, 1)
    floor = np.empty((size, size, 3))
    for row in range(rows):
        tone = np.empty((plank, size, 3))
        ends = np.sort((random.random() + np.array([0, 0.37, 0.69])) % 1 * size).astype(int)
        pieces = list(zip(ends, [*ends[1:], ends[0] + size]))
        for start, end in pieces:
            columns = np.arange(start, end) % size
            colour = np.array((0.66, 0.50, 0.34)) * random.uniform(0.78, 1.12) + random.uniform(-0.02, 0.02, 3)
            tone[:, columns] = colour * (0.82 + 0.26 * grain(plank, end - start, random.integers(1 << 30)))[..., None]
        for start, _ in pieces:
            tone[:, (start + np.arange(joint)) % size] *= 0.45
        tone[:joint] *= 0.45
        floor[row * plank:(row + 1) * plank] = tone
    return floor


def rug(size):
    """A woven pattern of diamonds in three colours."""
    y, x = np.mgrid[0:size, 0:size] / size
    diamond = np.abs((x * 2) % 1 - 0.5) + np.abs((y * 2) % 1 - 0.5)
    band = (diamond * 8).astype(int) % 4
    palette = np.array([(0.80, 0.74, 0.62), (0.30, 0.36, 0.46), (0.80, 0.74, 0.62), (0.62, 0.30, 0.22)])
    thread = 0.86 + 0.14 * np.sin(x * np.pi * 256) * np.sin(y * np.pi * 256)
    return palette[band] * (thread * (0.92 + 0.12 * noise(size, size, 64, 64, 3)))[..., None]


def painting(width, height):
    """Hills under an evening sky."""
    up = np.linspace(0, 1, height)[:, None]
    cloud = noise(height, width, 9, 6, 21) * 0.6 + noise(height, width, 30, 16, 22) * 0.4
    sky = np.array((0.93, 0.70, 0.45)) * (1 - up[..., None]) + np.array((0.35, 0.50, 0.70)) * up[..., None]
    made = sky + (0.22 * (cloud - 0.5))[..., None]
    for layer, colour in enumerate(((0.48, 0.50, 0.58), (0.36, 0.45, 0.40), (0.28, 0.36, 0.20), (0.40, 0.34, 0.16))):
        crest = 0.55 - 0.13 * layer + 0.16 * (noise(2, width, 2, 3 + 2 * layer, 40 + layer)[:1] - 0.5)
        brush = 0.85 + 0.3 * noise(height, width, 60, 20, 60 + layer)
        made = np.where((up < crest)[..., None], np.array(colour) * brush[..., None], made)
    return np.broadcast_to(made, (height, width, 3))
