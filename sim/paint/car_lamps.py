"""Which texels of a painted car are its lamps, and how they shine when it drives at night."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sim.paint.canvas import RgbImage
from sim.paint.car_layout import FRONT_AT_M, REAR_AT_M, SIZE_M, WIDE_M

_HEADLAMP_LEVEL, _TAIL_LAMP_LEVEL = 230, 40  # of a sunny day's levels
_ACROSS_M = 0.55  # from either side, in which lamps sit
_BAND_M = (1.2, 1.65)  # below the top of an end, likewise


def car_lamp_glow(image: RgbImage) -> npt.NDArray[np.uint8]:
    """Return (H, W) the level of the light that each texel of a driving car sheds at night."""
    glow = np.zeros(image.shape[:2], np.uint8)
    color = image.astype(int)
    white = color.min(axis=2) > 195
    red = (color[..., 0] > 150) & (color[..., 1:].max(axis=2) < 45)
    for at, lamp, level in ((FRONT_AT_M, white, _HEADLAMP_LEVEL), (REAR_AT_M, red, _TAIL_LAMP_LEVEL)):
        for left in (at[0], at[0] + WIDE_M - _ACROSS_M):
            area = _area(image, left, at[1])
            glow[area] = np.where(lamp[area], level, 0)
    return glow


def _area(image: RgbImage, left_m: float, top_m: float) -> tuple[slice, slice]:
    per_m = np.array(image.shape[:2]) / np.array(SIZE_M)[::-1]
    low, high = (top_m + offset for offset in _BAND_M)
    rows = slice(round(low * per_m[0]), round(high * per_m[0]))
    return rows, slice(round(left_m * per_m[1]), round((left_m + _ACROSS_M) * per_m[1]))
