"""Positions of many actors sampled at equal steps, and at any instant between."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array


class Trajectories:
    """A growing table of way (m) and speed (m/s) of N actors; between its rows acceleration is constant."""

    def __init__(self, start_s: float, step_s: float, way_m: Array, speed_mps: Array) -> None:
        self.start_s, self.step_s = start_s, step_s
        self._way_m, self._speed_mps = [way_m.copy()], [speed_mps.copy()]

    @property
    def newest_s(self) -> float:
        return self.start_s + self.step_s * (len(self._way_m) - 1)

    def append(self, way_m: Array, speed_mps: Array) -> None:
        """Add the state one step later: ``way_m`` is the last plus the mean of both speeds times the step."""
        self._way_m.append(way_m.copy())
        self._speed_mps.append(speed_mps.copy())

    def at(self, time_s: float) -> tuple[Array, Array]:
        """Return (N,) way and (N,) speed at a time within the table; before it, as at its start."""
        at = max((time_s - self.start_s) / self.step_s, 0.0)
        row = min(int(at), len(self._way_m) - 2) if len(self._way_m) > 1 else 0
        way, speed = self._way_m[row], self._speed_mps[row]
        if len(self._way_m) == 1:
            return way, speed
        since = (at - row) * self.step_s
        push = (self._speed_mps[row + 1] - speed) / self.step_s
        return way + speed * since + push * since**2 / 2, np.asarray(speed + push * since)
