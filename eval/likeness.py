"""How much like a real street are these frames: their statistics beside those of two real drives."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from eval.likeness_statistics import Statistics

ALLOWANCE = 0.15  # of the nearer real drive's value
# Two real drives through towns, forward camera, focal length 457 px, rows 81 to 320 of 400, a metre a frame.
REAL_DRIVES: Mapping[str, tuple[float, float]] = {
    "fast20_per_100kpx": (680.0, 1300.0),
    "gftt_per_100kpx": (480.0, 690.0),
    "gradient_mean": (6.8, 9.5),
    "textureless_share": (0.18, 0.26),
    "contrast_std": (55.0, 72.0),
    "spectrum_slope": (-2.6, -2.6),
    "klt_survival_1": (0.70, 0.75),
    "klt_survival_5": (0.44, 0.46),
    "klt_survival_10": (0.25, 0.30),
}


@dataclass(frozen=True)
class Likeness:
    """One statistic of a drive beside the real ones.

    Attributes:
        name: As in ``REAL_DRIVES``.
        mean: Over the frames.
        low: 10th percentile over the frames.
        high: 90th percentile.
        wanted: Range of the real drives, give or take the allowance.
    """

    name: str
    mean: float
    low: float
    high: float
    wanted: tuple[float, float]

    @property
    def inside(self) -> bool:
        """Whether the mean lies in the range."""
        return self.wanted[0] <= self.mean <= self.wanted[1]

    @property
    def spread_inside(self) -> bool:
        """Whether nine frames in ten lie above the range's lower end, and as many below its upper end."""
        return self.wanted[0] <= self.low and self.high <= self.wanted[1]


def compare_with_real(statistics: Statistics) -> list[Likeness]:
    """Return every statistic beside the real drives."""
    return [_compare(name, statistics[name]) for name in REAL_DRIVES]


def _compare(name: str, values: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> Likeness:
    low, high = REAL_DRIVES[name]
    wanted = (low - ALLOWANCE * abs(low), high + ALLOWANCE * abs(high))
    tenth, ninetieth = np.percentile(values, (10, 90))
    return Likeness(name, float(values.mean()), float(tenth), float(ninetieth), wanted)
