"""Street furniture wears its paint without stretching it."""

import numpy as np
import pytest

from sim.paint.furniture_parts import SIZE_M
from sim.shapes.furniture import pole


@pytest.mark.parametrize(("height_m", "radius_m"), [(2.7, 0.035), (3.5, 0.06), (5.6, 0.1)])
def test_paint_on_poles_is_as_wide_as_it_is_long(height_m: float, radius_m: float) -> None:
    u_m, v_m = np.ptp(pole(height_m, (radius_m, radius_m)).uvs, axis=0) * SIZE_M
    around, along = u_m / (2 * np.pi * radius_m), v_m / height_m
    assert 0.9 < around / along < 1.1
