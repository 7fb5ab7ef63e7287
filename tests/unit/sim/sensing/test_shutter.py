from __future__ import annotations

import numpy as np
import pytest

from sim.sensing.exposure import Exposure
from sim.sensing.shutter import BLUR_STEP_PX, STRIP_PX, Shutter, blur_s, slot_count, slots

ROWS = 40
CASES = [Shutter(0.03, 0.0), Shutter(0.0, 0.005), Shutter(0.03, 0.005), Shutter(0.002, 0.02)]


@pytest.mark.parametrize("shutter", CASES)
@pytest.mark.parametrize("count", [1, 3, 8, 24])
def test_a_row_is_the_mean_of_its_own_time_around_its_own_middle(shutter: Shutter, count: int) -> None:
    total, moment_s = np.zeros(ROWS), np.zeros(ROWS)
    for slot in slots(shutter, ROWS, count):
        rows = slice(slot.first, slot.last)
        total[rows] += slot.weights
        moment_s[rows] += slot.weights * (slot.time_s + slot.delay_s)
    assert np.allclose(total, 1)
    expected_s = shutter.readout_s * ((np.arange(ROWS) + 0.5) / ROWS - 0.5)
    assert np.allclose(moment_s, expected_s, atol=1e-9)


def test_a_blur_without_readout_needs_no_row_moved() -> None:
    assert not any(slot.delay_s.any() for slot in slots(Shutter(0.0, 0.005), ROWS, 6))


def test_rolling_rows_are_moved_by_no_more_than_half_a_slot() -> None:
    for slot in slots(Shutter(0.03, 0.0), ROWS, 6):
        assert np.abs(slot.delay_s).max() <= 0.03 / 6 / 2
        assert slot.last - slot.first == pytest.approx(ROWS / 6, abs=1)


@pytest.mark.parametrize("speed_px_s", [50.0, 400.0, 1500.0])
def test_there_are_pictures_enough_for_the_fastest_motion(speed_px_s: float) -> None:
    rolling, blurred = Shutter(0.02, 0.0), Shutter(0.0, 0.01)
    assert speed_px_s * 0.02 / slot_count(rolling, speed_px_s) <= STRIP_PX
    assert speed_px_s * 0.01 / slot_count(blurred, speed_px_s) <= BLUR_STEP_PX


def test_what_stands_still_takes_one_picture() -> None:
    assert slot_count(Shutter(0.03, 0.02), 0.0) == 1


def test_blur_follows_severity_and_exposure_time() -> None:
    times_s = [blur_s(Exposure(), severity) for severity in range(6)]
    assert times_s[0] == 0
    assert (np.diff(times_s) > 0).all()
    assert blur_s(Exposure(0.0014), 2) == 2 * blur_s(Exposure(0.0007), 2)
