"""Images of the toy room as arrays (height, width, 3), sRGB-encoded 0..1, made by arithmetic alone."""
import numpy as np
from scene_pictures import grain, noise


def parquet(size, squares=8, strips=8):
    """Mosaic parquet: squares of narrow strips, laid across and along in turn; fine dark joints."""
    random = np.random.default_rng(4)
    square, strip = size // squares, size // squares // strips
    floor = np.empty((size, size, 3))
    for row in range(squares):
        for column in range(squares):
            tile = np.empty((square, square, 3))
            for i in range(strips):
                colour = np.array((0.70, 0.52, 0.34)) * random.uniform(0.76, 1.14) + random.uniform(-0.025, 0.025, 3)
                tone = 0.80 + 0.28 * grain(strip, square, random.integers(1 << 30))
                tone[0] *= 0.5
                tile[i * strip:(i + 1) * strip] = colour * tone[..., None]
            tile[:, 0] *= 0.5
            if (row + column) % 2:
                tile = tile.transpose(1, 0, 2)
            floor[row * square:(row + 1) * square, column * square:(column + 1) * square] = tile
    return floor


def carpet(width, height):
    """Stripes and rows of triangles in wool, with the loops of the weave, and a plain border."""
    y, x = np.mgrid[0:height, 0:width]
    band, along = (y * 14 // height), (x * 18 / width) % 1
    within = (y * 14 / height) % 1
    teal, ochre, cream, red = (0.24, 0.42, 0.45), (0.80, 0.62, 0.30), (0.84, 0.79, 0.68), (0.68, 0.29, 0.24)
    plain = np.array([cream, teal, cream, ochre, cream, red, cream])[band % 7]
    teeth = (2 * np.abs(along - 0.5) < within) & (band % 2 == 0)
    made = np.where(teeth[..., None], np.array([teal, ochre, ochre, red, red, teal, teal])[band % 7], plain)
    edge = (x < width // 40) | (x >= width - width // 40) | (y < height // 28) | (y >= height - height // 28)
    made = np.where(edge[..., None], np.array((0.20, 0.30, 0.36)), made)
    loops = 0.80 + 0.20 * np.sin(x * np.pi / 4 + (y // 8 % 2) * np.pi / 2) * np.sin(y * np.pi / 4)
    return made * (loops * (0.90 + 0.16 * noise(height, width, 90, 120, 8)))[..., None]


def crayon(shade, colour, ground, seed):
    """Colour a region 0..1 with slanting wax strokes that let the paper through."""
    height, width = shade.shape
    y, x = np.mgrid[0:height, 0:width]
    wobble = 9 * noise(height, width, 9, 9, seed)
    strokes = 0.62 + 0.38 * np.sin((x + 0.6 * y) * 0.55 + wobble) * noise(height, width, 60, 60, seed + 1)
    cover = (shade * np.clip(strokes + 0.15, 0, 1))[..., None]
    return ground * (1 - cover) + np.array(colour) * cover


def child_drawing(width, height, roof, seed):
    """A house, a tree and the sun in wax crayon on paper."""
    y, x = np.mgrid[0:height, 0:width]
    u = x / height + 0.02 * noise(height, width, 6, 6, seed)
    v = y / height + 0.02 * noise(height, width, 6, 6, seed + 5)
    middle = 0.42 * width / height
    house = (abs(u - middle) < 0.20) & (v > 0.2) & (v < 0.52)
    gable = (v >= 0.52) & (abs(u - middle) < 0.26 - 0.95 * (v - 0.52))
    door = (abs(u - middle + 0.06) < 0.05) & (v > 0.2) & (v < 0.38)
    pane = (abs(u - middle - 0.10) < 0.05) & (abs(v - 0.40) < 0.05)
    right = 0.82 * width / height
    shapes = [(v > 0.86, (0.35, 0.55, 0.80)), (v < 0.2, (0.30, 0.58, 0.24)), (house, (0.90, 0.78, 0.45)),
              (gable, roof), (door, (0.45, 0.25, 0.15)), (pane, (0.40, 0.62, 0.82)),
              ((abs(u - right) < 0.03) & (v > 0.2) & (v < 0.45), (0.42, 0.27, 0.16)),
              (np.hypot(u - right, v - 0.52) < 0.14, (0.22, 0.50, 0.20)),
              (np.hypot(u - 0.16, v - 0.78) < 0.09, (0.96, 0.74, 0.12))]
    made = np.full((height, width, 3), 0.90)
    for i, (shade, colour) in enumerate(shapes):
        made = crayon(shade.astype(float), colour, made, seed + 10 + i)
    return made
