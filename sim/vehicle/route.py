"""The line a drive follows over the ground, by the distance travelled along it; open or a closed loop."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from estimator.se3 import Array

STEP_M = 0.1
_CHORD_M = 0.4
_CURVATURE_OVER_M = 2.0


@dataclass(frozen=True, eq=False)
class Route:
    """A smooth line, sampled about every ``STEP_M``; an open one goes on straight at both ends.

    Attributes:
        points_m: (N, 2) world xy in the order of travel, all ``step_m`` apart; a loop does not repeat the
            first.
        step_m: Distance between neighbours.
        closed: Whether the first point follows the last.
    """

    points_m: Array
    step_m: float
    closed: bool = False

    @property
    def length_m(self) -> float:
        """Length of an open line, or of one lap."""
        return self.step_m * (len(self.points_m) - (0 if self.closed else 1))

    def point_m(self, along_m: float) -> Array:
        """World xy at a distance from the first point."""
        before, share = self._segment(along_m)
        start, end = self._ends(before)
        return np.asarray(start + share * (end - start))

    def direction(self, along_m: float) -> Array:
        """(2,) unit vector of travel."""
        # A short chord, symmetric about the point: the line's pieces would turn by jerks.
        step = self.point_m(along_m + _CHORD_M / 2) - self.point_m(along_m - _CHORD_M / 2)
        return np.asarray(step / np.hypot(step[0], step[1]))

    def curvature_pm(self, along_m: Array | float) -> Array:
        """Curvature at distances, left positive, as the mean over two metres; zero beyond open ends."""
        table = self._curvatures_pm
        at = np.asarray(along_m, float) / self.step_m
        if self.closed:
            return np.interp(at, np.arange(len(table)), table, period=len(table))
        return np.interp(at, np.arange(len(table)), table, left=0.0, right=0.0)

    def nearest_m(self, position_m: Array, near_m: float) -> float:
        """Distance along at which the line passes a position, sought from a good guess on."""
        for _ in range(2):
            near_m += float((position_m - self.point_m(near_m)) @ self.direction(near_m))
        return near_m

    def _segment(self, along_m: float) -> tuple[int, float]:
        at, count = along_m / self.step_m, len(self.points_m)
        before = int(at // 1.0)
        if not self.closed:
            before = min(max(before, 0), count - 2)  # beyond the ends the share leaves 0..1: straight on
        return before, at - before

    def _ends(self, before: int) -> tuple[Array, Array]:
        count = len(self.points_m)
        return self.points_m[before % count], self.points_m[(before + 1) % count]

    @cached_property
    def _curvatures_pm(self) -> Array:
        """(N,) at the points: the turn between the metres before and after."""
        half = max(1, round(_CURVATURE_OVER_M / 2 / self.step_m))
        padded = self.points_m[np.arange(-half, len(self.points_m) + half) % len(self.points_m)]
        if not self.closed:
            ends = self.step_m * np.arange(1, half + 1)[:, None]
            padded[:half] = self.points_m[0] - ends[::-1] * self._unit(0)
            padded[-half:] = self.points_m[-1] + ends * self._unit(len(self.points_m) - 2)
        before = padded[half:-half] - padded[: -2 * half]
        after = padded[2 * half :] - padded[half:-half]
        turn_rad = np.arctan2(
            before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0], (before * after).sum(axis=1)
        )
        return np.asarray(turn_rad / (half * self.step_m))

    def _unit(self, before: int) -> Array:
        start, end = self._ends(before)
        return np.asarray((end - start) / np.linalg.norm(end - start))


def route_along(line_m: Array, closed: bool = False) -> Route:
    """Sample an (N, 2) polyline evenly; a closed one may repeat its first point at the end or not."""
    if closed and np.linalg.norm(line_m[0] - line_m[-1]) > 1e-6:
        line_m = np.concatenate([line_m, line_m[:1]])
    along_m = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(line_m, axis=0), axis=1))])
    steps = max(1, round(along_m[-1] / STEP_M))
    wanted_m = np.linspace(0.0, along_m[-1], steps + 1)
    points_m = np.stack([np.interp(wanted_m, along_m, line_m[:, axis]) for axis in (0, 1)], axis=1)
    return Route(points_m[:-1] if closed else points_m, float(along_m[-1] / steps), closed)


def backwards_from(route: Route, start_m: float) -> Route:
    """Return the same line travelled the other way, from a point on it on."""
    if route.closed:
        first = round(start_m / route.step_m)
        return Route(np.roll(route.points_m, -first - 1, axis=0)[::-1], route.step_m, True)
    last = min(max(2, round(start_m / route.step_m) + 1), len(route.points_m))
    return Route(route.points_m[:last][::-1], route.step_m)
