"""Images of the library as arrays (height, width, 3), sRGB-encoded 0..1, made by arithmetic alone."""
import numpy as np
from scene_pictures import noise

CLOTH = ((0.50, 0.14, 0.12), (0.16, 0.22, 0.42), (0.14, 0.36, 0.24), (0.72, 0.62, 0.40), (0.83, 0.79, 0.70),
         (0.24, 0.21, 0.19), (0.66, 0.36, 0.14), (0.36, 0.52, 0.62), (0.44, 0.22, 0.36), (0.60, 0.56, 0.50),
         (0.30, 0.40, 0.34), (0.76, 0.48, 0.40), (0.20, 0.44, 0.50), (0.86, 0.70, 0.32), (0.40, 0.28, 0.20),
         (0.70, 0.72, 0.74))
SPINES = 2 * len(CLOTH)


def spines(width, height):
    """The backs of SPINES books side by side: cloth with bands, a label, or letters; the lowest eighth is plain."""
    random = np.random.default_rng(5)
    made, wide, up = np.empty((height, width, 3)), width // SPINES, np.linspace(0, 1, height)
    across = np.abs(np.linspace(-1, 1, wide))
    for book in range(SPINES):
        cloth = np.array(CLOTH[book % len(CLOTH)]) * random.uniform(0.85, 1.1)
        back = np.tile(cloth, (height, wide, 1)) * (0.92 + 0.16 * noise(height, wide, 64, 8, 100 + book))[..., None]
        gold = np.array((0.80, 0.66, 0.36)) if cloth.mean() < 0.55 else np.array((0.28, 0.22, 0.18))
        for band in random.choice((0.16, 0.20, 0.24, 0.46, 0.80, 0.84, 0.88, 0.94), random.integers(2, 5), False):
            back[np.abs(up - band) < 0.006] = gold
        low, high = sorted(random.uniform(0.28, 0.78, 2))
        high = max(high, low + 0.16)
        if book % 3 == 0:
            back[(up > low) & (up < high)] = np.array((0.82, 0.78, 0.68)) if book % 2 else cloth * 0.55
        letters = (up > low + 0.03) & (up < high - 0.03) & (random.random(height // 8).repeat(8)[:height] > 0.3)
        back[np.ix_(letters, across < 0.4)] = gold
        made[:, book * wide:(book + 1) * wide] = back * (1 - 0.6 * across ** 5)[:, None]  # backs are rounded
    return made


def paper_edge(size):
    """The leaves of a book seen from their edge: fine lines along x."""
    lines = noise(size, size, size // 2, 3, 8)
    return np.array((0.86, 0.81, 0.70)) * (0.82 + 0.2 * lines)[..., None]


def printed_page(size):
    """Lines of text in two paragraphs under a heading."""
    random, page = np.random.default_rng(2), np.full((size, size, 3), (0.88, 0.85, 0.77))
    rows, margin = 30, size // 9
    for row in range(rows):
        if row in (1, 2, 14):
            continue
        top = margin + row * (size - 2 * margin) // rows
        end = size - margin - (random.integers(size // 4, size // 2) if row in (13, 29) else 0)
        ink = random.random(size) > 0.28
        ink[:margin], ink[end:] = False, False
        page[size - 1 - top - size // 90:size - 1 - top, ink] = (0.30, 0.28, 0.27)
    return page


def stone_floor(size, tiles=8):
    """Square slabs of limestone, each of its own tone, with a small dark stone where four of them meet."""
    random = np.random.default_rng(4)
    side, joint = size // tiles, max(size // 1024, 1)
    tones = random.uniform(0.93, 1.05, (tiles, tiles)).repeat(side, 0).repeat(side, 1)
    warm = random.uniform(-0.012, 0.012, (tiles, tiles)).repeat(side, 0).repeat(side, 1)
    cloud = 0.5 * noise(size, size, 20, 24, 31) + 0.3 * noise(size, size, 70, 60, 32) + 0.2 * noise(size, size, 300,
                                                                                                 300, 33)
    stone = (tones * (0.90 + 0.18 * cloud))[..., None] * np.array((0.68, 0.64, 0.57))
    stone += warm[..., None] * np.array((1, 0, -1))
    y, x = np.mgrid[0:size, 0:size]
    to_x, to_y = np.minimum(x % side, side - x % side), np.minimum(y % side, side - y % side)
    seam = (np.minimum(to_x, to_y) < joint) | (np.abs(to_x + to_y - side * 0.16) < joint)
    inset = to_x + to_y < side * 0.16
    stone[inset] = (0.36, 0.38, 0.38) * (0.85 + 0.3 * cloud[inset])[:, None]
    stone[seam & ~(inset & (to_x + to_y < side * 0.14))] *= 0.62
    return stone


def runner(width, height):
    """A long carpet: a dark red ground with small flowers and a border along both sides; rows run along it."""
    y, x = np.mgrid[0:height, 0:width]
    across = x / width
    petals = np.cos(across * np.pi * 20) * np.cos(y / height * np.pi * 40)
    made = np.where(petals[..., None] > 0.72, (0.66, 0.50, 0.30), (0.47, 0.15, 0.14))
    edge = np.minimum(across, 1 - across)[..., None]
    made = np.where(edge < 0.14, (0.20, 0.22, 0.34), made)
    made = np.where((edge < 0.03) | (np.abs(edge - 0.14) < 0.012), (0.70, 0.56, 0.36), made)
    return made * (0.86 + 0.2 * noise(height, width, 128, 64, 77))[..., None]


def earth(width, height):
    """An old globe's map: land of sandy tones on blue-green seas, with a net of meridians and parallels."""
    land = 0.55 * noise(height, width, 4, 6, 51) + 0.3 * noise(height, width, 10, 16, 52)
    land += 0.15 * noise(height, width, 30, 48, 53)
    relief = (0.85 + 0.25 * noise(height, width, 24, 40, 54))[..., None]
    made = np.where(land[..., None] > 0.53, (0.78, 0.64, 0.40), (0.30, 0.47, 0.50)) * relief
    made[np.abs(land - 0.53) < 0.008] = (0.36, 0.28, 0.18)
    y, x = np.mgrid[0:height, 0:width]
    made[(x % (width // 24) < 2) | (y % (height // 12) < 2)] *= 0.8
    return made


def clock_face(size):
    """A white dial with twelve strokes; seven minutes to eleven."""
    y, x = (np.mgrid[0:size, 0:size] + 0.5) / size * 2 - 1
    radius, angle = np.hypot(x, y), np.arctan2(x, y) % (2 * np.pi)
    made = np.full((size, size, 3), (0.88, 0.86, 0.80))
    hour = np.abs((angle + np.pi / 12) % (np.pi / 6) - np.pi / 12) * radius
    black = (radius > 0.72) & (radius < 0.9) & (hour < 0.025)
    for turn, length, half in ((10.88 / 12, 0.5, 0.04), (53 / 60, 0.8, 0.025)):
        along = x * np.sin(turn * 2 * np.pi) + y * np.cos(turn * 2 * np.pi)
        aside = x * np.cos(turn * 2 * np.pi) - y * np.sin(turn * 2 * np.pi)
        black |= (along > -0.12) & (along < length) & (np.abs(aside) < half)
    made[black] = (0.10, 0.10, 0.11)
    return made


def portrait_of_a_tree(width, height):
    """A dark tree on a meadow under a pale sky."""
    y, x = np.mgrid[0:height, 0:width]
    x, y = x / width, y / height
    haze = noise(height, width, 12, 5, 91)
    made = np.array((0.78, 0.76, 0.66)) - (0.25 * y + 0.12 * haze)[..., None] * np.array((0.9, 0.6, 0.2))
    made = np.where((y < 0.28 + 0.05 * haze)[..., None], np.array((0.48, 0.50, 0.26)) * (0.8 + 0.4 * haze)[..., None],
                    made)
    crown = np.hypot((x - 0.5) / 0.34, (y - 0.62) / 0.25) + 0.5 * (noise(height, width, 24, 18, 92) - 0.5)
    leaf = np.array((0.22, 0.32, 0.18)) * (0.6 + 0.9 * noise(height, width, 50, 40, 93))[..., None]
    made = np.where(((np.abs(x - 0.5) < 0.03) & (y > 0.2) & (y < 0.5))[..., None], (0.25, 0.18, 0.13), made)
    return np.where(crown[..., None] < 1, leaf, made)
