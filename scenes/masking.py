"""After figure 4 of the paper: one soft shadow on a plain floor, on a patterned one, and behind a plant."""
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent))
from repeated import again
from scene_pictures import noise
from scene_tools import area_light, box, camera, diffuse, furniture, image, quads, reset, save

PLACES = (-2.1, 0.0, 2.1)  # x of the middles of plain floor, pattern, plant
HALF, FRONT, BACK, HEIGHT = 1.05, -2.6, 2.4, 3.0
GREY = 0.45


def terrazzo(size):
    """Chips of stone of three sizes, on average as bright as the plain floor."""
    chips = sum(noise(size, size, cells, cells, seed) for seed, cells in enumerate((400, 200, 100)))
    shade = np.clip(0.68 + 0.55 * (chips - chips.mean()), 0.2, 1.0)
    return np.stack([shade, 0.98 * shade, 0.94 * shade], axis=2)


def floor(name, x, material):
    quads(name, [((x - HALF, FRONT, 0), (x + HALF, FRONT, 0), (x + HALF, BACK, 0), (x - HALF, BACK, 0))], material, 2.1)


reset(700, 350)
plain = diffuse("plain", (GREY, GREY, 0.96 * GREY))
pattern = diffuse("pattern", image("terrazzo", terrazzo(1024)))
board = diffuse("board", (0.30, 0.20, 0.12))
left, middle, right = PLACES
floor("plain floor", left, plain)
floor("patterned floor", middle, pattern)
floor("plant's floor", right, plain)
x0, x1 = left - HALF, right + HALF
quads("wall", [((x0, BACK, 0), (x1, BACK, 0), (x1, BACK, HEIGHT), (x0, BACK, HEIGHT))],
      diffuse("wall", (0.62, 0.60, 0.56)))
for place in PLACES:
    box("board", (place - 0.6, 0.35, 0.62), (place + 0.6, 1.05, 0.65), board)
plant = furniture("plant", "CC-BY", "spatifilum", (right - 0.3, -0.75, 0), scale=1.1)
again(plant, "plant 2", (right + 0.3, -0.65, 0), turn=120)
area_light("lamp", ((x0 + x1) / 2, 0.2, HEIGHT), (0, 0, -1), x1 - x0, 0.7, 260, (1.0, 0.94, 0.86))
camera((0, -4.1, 2.6), (0, 0.2, 0.25), 66)
save()
