"""A line along which actors move, closed into a ring: who leaves its end comes in again at its start.

Both ends of an open lane reach a little further than the lane, into what closes the street there, so that
nobody comes or goes in plain view. u is the way along the ring and grows for ever; s follows from it.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from estimator.se3 import Array
from sim.streets.path import Path

CELL_M = 0.5
HALF_WIDTH_M = {"car": 0.99, "bike": 0.28, "foot": 0.27}
# How far the ends of the longest of a kind, its axles on the path, swing out of it: metres per (1/m).
_SWINGS_M2 = {"car": 3.0, "bike": 0.3, "foot": 0.0}
_BEYOND_M = {"car": 9.0, "bike": 3.0, "foot": 1.5}
_SIDEWAYS_MPS2 = 2.2  # what drivers bear in curves
_EASE_MPS2 = 1.2  # how they slow down before them


@dataclass(frozen=True, eq=False)
class Track:
    """Where actors of one kind move.

    Attributes:
        kind: car, bike or foot.
        path: Its line, in the direction of travel.
        speed_mps: What is moved at where nothing is in the way.
        beyond_m: By how much an open path is prolonged at both ends.
        swings_m2: By how much the body needs more room in curves: metres per (1/m).
        gives_way_m: s of the line behind which to wait for what crosses, or None.
        wraps: Whether who leaves its end comes in again; else the way goes on straight.
    """

    kind: str
    path: Path
    speed_mps: float
    beyond_m: float
    swings_m2: float
    gives_way_m: float | None = None
    wraps: bool = True

    @property
    def closed(self) -> bool:
        return self.path.closed

    @property
    def ring_m(self) -> float:
        """Length of the ring: a whole number of cells."""
        return CELL_M * self.cell_count

    @cached_property
    def cell_count(self) -> int:
        return max(4, round((self.path.length_m + 2 * self.beyond_m) / CELL_M))

    def s_m(self, u_m: ArrayLike) -> Array:
        """Arc length on the path."""
        stretch = (self.path.length_m + 2 * self.beyond_m) / self.ring_m
        u_m = np.mod(u_m, self.ring_m) if self.wraps else np.asarray(u_m, float)
        s_m: Array = self.path.start_m - self.beyond_m + u_m * stretch
        return s_m

    @property
    def stop_cell(self) -> int | None:
        """The cell in which the line lies behind which to wait."""
        return None if self.gives_way_m is None else int(np.searchsorted(self._cell_s_m, self.gives_way_m))

    @cached_property
    def _cell_s_m(self) -> Array:
        return self.s_m((np.arange(self.cell_count) + 0.5) * CELL_M)

    @cached_property
    def cell_points_m(self) -> Array:
        """(N, 2) middle of each cell."""
        return self.path.point_m(self._cell_s_m)

    @cached_property
    def cell_headings_rad(self) -> Array:
        return self.path.heading_rad(self._cell_s_m)

    @cached_property
    def cell_half_widths_m(self) -> Array:
        """(N,) room needed on either side."""
        return self.half_width_m(self._cell_s_m)

    def half_width_m(self, s_m: Array) -> Array:
        """Room needed on either side at arc lengths of the path."""
        bend = np.abs(self.path.curvature_1pm(s_m, 2.0))
        return HALF_WIDTH_M[self.kind] + np.minimum(self.swings_m2 * bend, 0.7)

    @cached_property
    def cell_speeds_mps(self) -> Array:
        """(N,) speed that its curves allow, braked for in time."""
        bend = np.abs(self.path.curvature_1pm(self._cell_s_m, 3.0))
        speeds = np.minimum(self.speed_mps, np.sqrt(_SIDEWAYS_MPS2 / np.maximum(bend, 1e-6)))
        for _ in range(2 if self.closed else 1):
            for k in range(len(speeds) - 1 if self.closed else len(speeds) - 2, -1, -1):
                after = speeds[(k + 1) % len(speeds)]
                speeds[k] = min(speeds[k], np.sqrt(after**2 + 2 * _EASE_MPS2 * CELL_M))
        return np.asarray(speeds)


def track_along(kind: str, path: Path, speed_mps: float, gives_way_m: float | None = None) -> Track:
    """Return the track of a lane."""
    beyond = 0.0 if path.closed else _BEYOND_M[kind]
    return Track(kind, path, speed_mps, beyond, _SWINGS_M2[kind], gives_way_m)
