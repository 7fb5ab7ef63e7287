"""Where a distortion polynomial turns back: beyond it a model describes no lens."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

_FARTHEST = 1e3  # a turn beyond this radius or angle is none: no lens reaches it


@lru_cache(maxsize=256)
def first_turn(slope_in_square: tuple[float, ...]) -> float:
    """Return sqrt of the least positive real root of a polynomial, or infinity where there is none.

    Args:
        slope_in_square: Coefficients, highest power first; the last one is 1.
    """
    # The reciprocals of the roots solve the reversed polynomial, whose leading coefficient is 1: vanishing
    # coefficients do no harm there.
    reciprocals = np.roots(slope_in_square[::-1])
    real = reciprocals.real[np.abs(reciprocals.imag) < 1e-9 * np.abs(reciprocals)]
    largest = float(real.max(initial=0.0))
    return largest**-0.5 if largest > _FARTHEST**-2 else float("inf")
