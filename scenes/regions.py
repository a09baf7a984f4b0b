#!/usr/bin/python3
"""regions.py SCENE REFERENCE.exr TEST.exr: is each wall, floor, ceiling and big object as bright as it should be?

A region is what one object covers in the picture. Pixels within one pixel of a region's border are left out (filters
differ there), pixels of lamps too, and regions that are then below SMALLEST of the picture.

Both pictures show the same reflectance at a pixel, so what they differ by there is irradiance: the last columns tell
how far it is off, either way, at half of a region's points and at nine tenths of them. A point is the mean of 3x3
pixels, as truths have noise of their own.
"""
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
import scene_files as files
from compare import box, load

SMALLEST = 0.005  # of the picture
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


class Region(NamedTuple):
    name: str
    pixels: int
    expected: float  # mean luminance of the truth
    found: float
    ratio: float
    half: float  # of its points' irradiance is this much off or less, as a share of the truth
    most: float  # nine tenths


def regions_file(name):
    """The .npz of a scene's regions at the truth's size, made by region_masks.py when the scene has changed."""
    path = files.BUILD / "scenes" / f"{name}-{files.scene_hash(name)}-regions.npz"
    return files.made(path, [files.scene_file(name), "--python", files.SCENES / "region_masks.py"], files.TRUTH_PERCENT)


def inner_masks(masks):
    """{object name: (height, width) bool} of what is compared."""
    index = masks["index"].astype(int)
    padded = np.pad(index, 1, "edge")
    height, width = index.shape
    inner = ~masks["emitting"]
    for y in range(3):
        for x in range(3):
            inner &= padded[y:y + height, x:x + width] == index
    found = {str(name): inner & (index == i) for i, name in enumerate(masks["names"])}
    return {name: mask for name, mask in sorted(found.items()) if mask.mean() >= SMALLEST}


def regions_report(reference, test, masks):
    """[Region] for pictures (height, width, 3). masks: what numpy.load gives for a regions file."""
    if reference.shape != test.shape or reference.shape[:2] != masks["index"].shape:
        raise files.SceneError(f"sizes differ: {reference.shape} {test.shape} {masks['index'].shape}")
    rows = []
    near_reference, near_test = box(reference) @ LUMINANCE, box(test) @ LUMINANCE
    errors = np.abs(near_test / np.maximum(near_reference, 1e-9) - 1)
    for name, mask in inner_masks(masks).items():
        expected, found = (float((picture[mask] @ LUMINANCE).mean()) for picture in (reference, test))
        half, most = (float(share) for share in np.percentile(errors[mask], (50, 90)))
        rows.append(Region(name, int(mask.sum()), expected, found, found / max(expected, 1e-9), half, most))
    return rows


def worst_region(rows):
    """The row whose ratio is farthest from 1, in either direction."""
    return max(rows, key=lambda row: abs(np.log(max(row.ratio, 1e-9))))


def main(arguments):
    if len(arguments) != 3:
        print(__doc__)
        return 2
    masks = np.load(regions_file(arguments[0]))
    print(f"{'region':24} {'pixels':>7} {'reference':>10} {'test':>10} {'ratio':>7} {'half':>7} {'most':>7}")
    for row in regions_report(load(arguments[1]), load(arguments[2]), masks):
        print(f"{row.name:24} {row.pixels:7} {row.expected:10.5f} {row.found:10.5f} {row.ratio:7.4f}"
              f" {row.half:7.3f} {row.most:7.3f}")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main(sys.argv[1:]))
    except files.SceneError as error:
        sys.exit(str(error))
