#!/usr/bin/python3
"""compare.py REFERENCE.exr TEST.exr: how far a render is from the converged path-traced reference, in one line of JSON.

Both pictures are first clipped at three times the reference's 90th percentile (per channel), so that the edges of
visible lamps, which any change of pixel filter moves, do not drown the rest.
mean_ratio   mean luminance of the test over that of the reference (1 = energy right)
rel_rmse     RMSE over the mean, linear RGB, after a 3x3 box on both (bias shows; filter differences mostly fall out)
rel_p95      95th percentile of the relative luminance error of a 3x3-boxed pixel (floor: 2 % of the mean)
srgb_rmse    RMSE of the sRGB-encoded images, in 8-bit steps, unfiltered
noise        median over pixels of the 3x3 local standard deviation of test minus reference, over the mean: grain that
             an eye sees
"""
import json
import sys

import numpy as np
import OpenImageIO as oiio


def load(path):
    b = oiio.ImageBuf(path)
    a = b.get_pixels(oiio.FLOAT)
    return np.nan_to_num(a[..., :3], nan=1e3, posinf=1e3).astype(np.float64)


def box(a):
    p = np.pad(a, ((1, 1), (1, 1), (0, 0)), "edge")
    return sum(p[i:i + a.shape[0], j:j + a.shape[1]] for i in range(3) for j in range(3)) / 9


def srgb(a):
    a = np.clip(a, 0, 1)
    return 255 * np.where(a <= .0031308, a * 12.92, 1.055 * a ** (1 / 2.4) - .055)


def compare(ref, test):
    if ref.shape != test.shape:
        raise SystemExit(f"sizes differ: {ref.shape} {test.shape}")
    lum = np.array([.2126, .7152, .0722])
    cap = 3 * np.percentile(ref.max(axis=2), 90)
    r, t = np.minimum(ref, cap), np.minimum(test, cap)
    rb, tb = box(r), box(t)
    mean = (rb @ lum).mean()
    rel = np.abs((tb - rb) @ lum) / np.maximum(rb @ lum, .02 * mean)
    d = ((t - r) @ lum)[..., None]
    sd = np.sqrt(np.maximum(box(d * d) - box(d) ** 2, 0))
    return dict(mean_ratio=round(float((t @ lum).mean() / (r @ lum).mean()), 4),
                rel_rmse=round(float(np.sqrt(((tb - rb) ** 2).mean()) / mean), 4),
                rel_p95=round(float(np.percentile(rel, 95)), 4),
                srgb_rmse=round(float(np.sqrt(((srgb(t) - srgb(r)) ** 2).mean())), 2),
                noise=round(float(np.median(sd) / mean), 4))


if __name__ == "__main__":
    print(json.dumps(compare(load(sys.argv[1]), load(sys.argv[2]))))
