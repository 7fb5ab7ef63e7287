"""A camera whose clock is off exposes at the wrong time, alone, and never goes back in time."""

from typing import Any

import numpy as np
import pytest

from estimator.bundle import Image
from sim.faults.clock_faults import ClockOffset
from sim.faults.own_clocks import CamerasOnClocks


class Recorded:
    """Cameras that note when they exposed."""

    def __init__(self, times_s: dict[str, list[float]], names: Any) -> None:
        self._times_s, self._names = times_s, tuple(names)

    def take(self, stage: Any, renderer: Any, index: int, time_s: float) -> dict[str, Image]:
        for name in self._names:
            self._times_s.setdefault(name, []).append(time_s)
        return {name: np.zeros((2, 2), np.uint8) for name in self._names}


def exposures(*faults: dict[str, Any]) -> dict[str, list[float]]:
    times_s: dict[str, list[float]] = {}
    cameras = CamerasOnClocks(
        dict.fromkeys(("front", "left", "rear")),
        lambda lenses: Recorded(times_s, lenses),
        [ClockOffset(kind="clock_offset", **fault) for fault in faults],
    )
    for index in range(5):
        taken = cameras.take(None, None, index, index / 10)  # type: ignore[arg-type]
        assert list(taken) == ["front", "left", "rear"]
    return times_s


GRID_S = [0.0, 0.1, 0.2, 0.3, 0.4]


def test_without_faults_all_expose_when_due() -> None:
    assert exposures() == {"front": GRID_S, "left": GRID_S, "rear": GRID_S}


def test_a_clock_that_is_ahead_exposes_early_and_alone() -> None:
    times_s = exposures({"camera": "rear", "offset_ms": 20})
    assert times_s["front"] == times_s["left"] == GRID_S
    assert times_s["rear"] == pytest.approx([time_s - 0.02 for time_s in GRID_S])


def test_offsets_of_one_camera_add_up_while_they_last() -> None:
    faults = (
        {"camera": "all", "offset_ms": -10},
        {"camera": ["rear"], "offset_ms": 30, "at_s": 0.2, "duration_s": 0.1},
    )
    times_s = exposures(*faults)
    assert times_s["left"] == pytest.approx([time_s + 0.01 for time_s in GRID_S])
    assert times_s["rear"] == pytest.approx([0.01, 0.11, 0.18, 0.31, 0.41])


def test_a_clock_set_forward_does_not_go_back_in_time() -> None:
    times_s = exposures({"camera": "rear", "offset_ms": 150, "at_s": 0.3})
    assert times_s["rear"] == pytest.approx([0.0, 0.1, 0.2, 0.2, 0.25])
