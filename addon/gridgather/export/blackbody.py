"""Colour of a glowing body."""

import numpy as np


def blackbody(kelvin: float) -> tuple[float, float, float]:
    """Linear Rec.709 of Planck's spectrum at a temperature in kelvin, with luminance 1.

    Colour matching functions: the analytic fit of [WYMAN13, eq. 4], CIE 1931 2 degrees, within 1 % of the tables.
    """
    nanometres = np.arange(360.0, 831.0, 5.0)
    metres = nanometres * 1e-9
    exponent = 1.438777e-2 / (metres * max(kelvin, 500.0))  # hc / (wavelength k T), second radiation constant in m K
    spectrum = metres**-5.0 / np.expm1(exponent)
    xyz = np.array([np.sum(spectrum * _response(nanometres, lobes)) for lobes in _LOBES])
    rgb = _XYZ_TO_REC709 @ (xyz / xyz[1])
    return tuple(float(max(value, 0.0)) for value in rgb)


# (height, centre [nm], 1/width below and above the centre [1/nm]) of each lobe of x, y, z.
_LOBES = (
    ((0.362, 442.0, 0.0624, 0.0374), (1.056, 599.8, 0.0264, 0.0323), (-0.065, 501.1, 0.0490, 0.0382)),
    ((0.821, 568.8, 0.0213, 0.0247), (0.286, 530.9, 0.0613, 0.0322)),
    ((1.217, 437.0, 0.0845, 0.0278), (0.681, 459.0, 0.0385, 0.0725)),
)
_XYZ_TO_REC709 = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)


def _response(nanometres, lobes):
    total = np.zeros_like(nanometres)
    for height, centre, below, above in lobes:
        offset = (nanometres - centre) * np.where(nanometres < centre, below, above)
        total += height * np.exp(-0.5 * offset * offset)
    return total
