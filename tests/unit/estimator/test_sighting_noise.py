"""What is stated of a sighting follows from how well its patch fits."""

from __future__ import annotations

import numpy as np

from estimator.align import Aligned
from estimator.sighting_noise import SightingNoise

NOISE = SightingNoise(factor=5.0, floor_px=0.1, ceiling_px=2.0)


def stated(sigma_px: list[float]) -> list[float]:
    count = len(sigma_px)
    return NOISE.sigma_px(Aligned(np.zeros((count, 2)), np.ones(count), np.array(sigma_px))).tolist()


def test_a_sighting_that_fits_worse_has_less_to_say() -> None:
    assert stated([0.04, 0.08]) == [0.2, 0.4]


def test_none_is_trusted_without_limit_and_none_not_at_all() -> None:
    assert stated([0.0, 9.0]) == [0.1, 2.0]


def test_what_was_not_aligned_has_no_sigma() -> None:
    assert np.isnan(stated([np.nan])).all()
