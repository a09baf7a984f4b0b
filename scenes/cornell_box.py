"""The classic Cornell box, one metre of it for every decimetre of the original's height."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from scene_tools import camera, diffuse, emitter, quads, reset, save

WIDTH, DEPTH, HEIGHT = 5.56, 5.592, 5.488
LAMP = (2.13, 3.43, 2.27, 3.32)  # x from, x to, y from, y to

reset(400, 400)
white = diffuse("white", (0.725, 0.71, 0.68))
red = diffuse("red", (0.63, 0.065, 0.05))
green = diffuse("green", (0.14, 0.45, 0.091))


def block(name, floor_corners, height):
    """A block over four floor corners, counter-clockwise seen from above."""
    low = [(x, y, 0) for x, y in floor_corners]
    high = [(x, y, height) for x, y in floor_corners]
    sides = [(low[i], low[(i + 1) % 4], high[(i + 1) % 4], high[i]) for i in range(4)]
    quads(name, sides + [tuple(high)], white)


def ceiling_quad(x0, x1, y0, y1):
    """Part of the ceiling that looks down."""
    return (x0, y0, HEIGHT), (x0, y1, HEIGHT), (x1, y1, HEIGHT), (x1, y0, HEIGHT)


quads("floor", [((0, 0, 0), (WIDTH, 0, 0), (WIDTH, DEPTH, 0), (0, DEPTH, 0))], white)
quads("wall back", [((0, DEPTH, 0), (WIDTH, DEPTH, 0), (WIDTH, DEPTH, HEIGHT), (0, DEPTH, HEIGHT))], white)
quads("wall left", [((0, 0, 0), (0, DEPTH, 0), (0, DEPTH, HEIGHT), (0, 0, HEIGHT))], red)
quads("wall right", [((WIDTH, DEPTH, 0), (WIDTH, 0, 0), (WIDTH, 0, HEIGHT), (WIDTH, DEPTH, HEIGHT))], green)
# The lamp fills a hole in the ceiling: nothing is hidden above it.
left, right, front, back = LAMP
quads("ceiling", [ceiling_quad(0, left, 0, DEPTH), ceiling_quad(right, WIDTH, 0, DEPTH),
                  ceiling_quad(left, right, 0, front), ceiling_quad(left, right, back, DEPTH)], white)
quads("lamp", [ceiling_quad(left, right, front, back)], emitter("lamp", (32.0, 26.0, 15.5)))
block("short block", [(4.26, 0.65), (4.74, 2.25), (3.16, 2.72), (2.66, 1.14)], 1.65)
block("tall block", [(1.33, 2.47), (2.90, 2.96), (2.42, 4.56), (0.83, 4.06)], 3.30)
camera((WIDTH / 2, -8.0, HEIGHT / 2), (WIDTH / 2, 0, HEIGHT / 2), 38.2)
save()
