"""Vignetting: images darker towards their corners, by the cosine law and by the barrel of the lens."""

from __future__ import annotations

import numpy as np

from sim.sensing.face import GreyImage

_OBLIQUITY = 0.15  # tangent of the ray's angle behind the lens at the image's corner, per severity
_CUT = 0.1  # share of the corner's light that the barrel cuts off, per severity
_CUT_FROM, _CUT_TO = 0.65, 1.08  # of the half diagonal
_DECENTRING = 0.04  # of the half diagonal, at most: lenses are never quite centred


def transmission(size_px: tuple[int, int], severity: float, rng: np.random.Generator) -> GreyImage:
    """Return the (H, W) share of light that a lens lets through; 1 near the middle."""
    width, height = size_px
    half_diagonal_px = np.hypot(width, height) / 2
    offset_px = rng.uniform(-_DECENTRING, _DECENTRING, 2) * half_diagonal_px
    columns = (np.arange(width) - (width - 1) / 2 - offset_px[0]) / half_diagonal_px
    rows = (np.arange(height) - (height - 1) / 2 - offset_px[1]) / half_diagonal_px
    radius2 = columns**2 + rows[:, None] ** 2
    natural = (1 + (_OBLIQUITY * severity) ** 2 * radius2) ** -2  # cos^4 of that angle
    share = np.clip((np.sqrt(radius2) - _CUT_FROM) / (_CUT_TO - _CUT_FROM), 0, 1)
    mechanical = 1 - _CUT * severity * share * share * (3 - 2 * share)
    return np.asarray(natural * mechanical, np.float32)
