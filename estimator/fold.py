"""Where a distortion polynomial turns back: beyond it a model describes no lens."""

from __future__ import annotations

from functools import lru_cache

import numpy as np


@lru_cache(maxsize=256)
def first_turn(slope_in_square: tuple[float, ...]) -> float:
    """Return sqrt of the least positive real root of a polynomial (highest power first), or infinity."""
    roots = np.roots(slope_in_square)
    real = roots.real[(np.abs(roots.imag) < 1e-9 * np.abs(roots)) & (roots.real > 0)]
    return float(np.sqrt(real.min())) if real.size else float("inf")
