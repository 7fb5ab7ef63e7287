"""Where a street runs: a smooth path, and street coordinates (s along it, d to its left) on it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from estimator.se3 import Array

STEP_M = 0.1


@dataclass(frozen=True, eq=False)
class Path:
    """A curve sampled every ``step_m``, from ``start_m`` (which may be negative) on.

    Attributes:
        start_m: Arc length at the first point.
        points_m: (N, 2) world xy.
        headings_rad: (N,) not wrapped.
        step_m: Arc length between two points.
        closed: Whether the last point is the first one again, so that s may grow for ever.
    """

    start_m: float
    points_m: Array
    headings_rad: Array
    step_m: float = STEP_M
    closed: bool = False

    @property
    def end_m(self) -> float:
        """Arc length at the last point."""
        return self.start_m + self.length_m

    @property
    def length_m(self) -> float:
        """From the first point to the last; once round if closed."""
        return self.step_m * (len(self.points_m) - 1)

    def heading_rad(self, s_m: Array | float) -> Array:
        """Direction at arc length s."""
        return np.interp(self._at(s_m), np.arange(len(self.headings_rad)), self.headings_rad)

    def point_m(self, s_m: Array | float, d_m: Array | float = 0.0) -> Array:
        """World xy of street coordinates; broadcasts, result (..., 2). Open ends go on straight."""
        s_m, d_m = np.broadcast_arrays(np.asarray(s_m, float), np.asarray(d_m, float))
        at = self._at(s_m)
        index = np.arange(len(self.points_m))
        heading = np.interp(at, index, self.headings_rad)
        beyond = self.step_m * (at - np.clip(at, 0, index[-1]))
        x = np.interp(at, index, self.points_m[:, 0]) + beyond * np.cos(heading) - d_m * np.sin(heading)
        y = np.interp(at, index, self.points_m[:, 1]) + beyond * np.sin(heading) + d_m * np.cos(heading)
        return np.stack([x, y], axis=-1)

    def curvature_1pm(self, s_m: Array | float, over_m: float = 1.0) -> Array:
        """Turn per metre around s, positive to the left."""
        s_m = np.asarray(s_m, float)
        turn = self.heading_rad(s_m + over_m / 2) - self.heading_rad(s_m - over_m / 2)
        return np.asarray((turn + np.pi) % (2 * np.pi) - np.pi) / over_m

    def project(self, points_m: Array) -> Array:
        """Street coordinates (..., 2) of world points: s of the nearest point of the path, d to its left.

        Points beyond an open end get an s beyond it.
        """
        points_m = np.asarray(points_m, float)
        _, index = self._tree.query(points_m)
        away = points_m - self.points_m[index]
        heading = self.headings_rad[index]
        along = away[..., 0] * np.cos(heading) + away[..., 1] * np.sin(heading)
        left = away[..., 1] * np.cos(heading) - away[..., 0] * np.sin(heading)
        return np.stack([self.start_m + self.step_m * index + along, left], axis=-1)

    def offset(
        self, d_m: float, start_m: float | None = None, end_m: float | None = None, backwards: bool = False
    ) -> Path:
        """Return the path beside this one, from one s to another; ``backwards`` runs against this one."""
        start = self.start_m if start_m is None else start_m
        end = self.end_m if end_m is None else end_m
        s_m = np.linspace(start, end, max(2, round((end - start) / STEP_M) + 1))
        points = self.point_m(s_m, d_m)
        whole = self.closed and start_m is None and end_m is None
        return path_through(points[::-1] if backwards else points, whole)

    def _at(self, s_m: Array | float) -> Array:
        """Index, with fraction, of an arc length."""
        at: Array = (np.asarray(s_m, float) - self.start_m) / self.step_m
        return np.mod(at, len(self.points_m) - 1) if self.closed else at

    @cached_property
    def _tree(self) -> cKDTree:
        return cKDTree(self.points_m)


def path_from_curvature(start_m: float, curvature_1pm: Array) -> Path:
    """Integrate a curvature sampled every ``STEP_M``; the path runs through the origin along +x at s = 0."""
    turned = np.cumsum(curvature_1pm) * STEP_M
    zero = round(-start_m / STEP_M)
    headings = turned - turned[zero]
    # Midpoint rule: the heading half-way between two samples carries the step.
    middle = (headings[1:] + headings[:-1]) / 2
    steps = STEP_M * np.stack([np.cos(middle), np.sin(middle)], axis=1)
    points = np.vstack([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
    return Path(start_m, points - points[zero], headings)


def path_through(points_m: Array, closed: bool = False, start_m: float = 0.0) -> Path:
    """Return the path along a polyline, sampled anew at equal steps.

    Args:
        points_m: (N, 2); the last of a closed one repeats the first.
        closed: Whether it comes back to where it started.
        start_m: Arc length at the first point.
    """
    along_m = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points_m, axis=0), axis=1))])
    count = max(1, round(along_m[-1] / STEP_M))
    s_m = np.linspace(0.0, along_m[-1], count + 1)
    points = np.stack([np.interp(s_m, along_m, points_m[:, axis]) for axis in (0, 1)], axis=1)
    padded = np.vstack([points[-2], points, points[1]]) if closed else points
    ahead = np.gradient(padded, axis=0)[1:-1] if closed else np.gradient(points, axis=0)
    headings = np.unwrap(np.arctan2(ahead[:, 1], ahead[:, 0]))
    return Path(start_m, points, headings, along_m[-1] / count, closed)


def straight_path(origin_m: Array, heading_rad: float, length_m: float) -> Path:
    """A straight path from a point on."""
    count = round(length_m / STEP_M)
    s_m = np.linspace(0.0, length_m, count + 1)
    direction = np.array([np.cos(heading_rad), np.sin(heading_rad)])
    points = np.asarray(origin_m) + s_m[:, None] * direction
    return Path(0.0, points, np.full(len(s_m), heading_rad), length_m / count)


def bend_curvature(
    s_m: Array, start_m: float, angle_rad: float, radius_m: float, ramp_m: float = 4.0
) -> Array:
    """Curvature of one bend with linear ramps, in 1/m at each s; the bend turns by exactly ``angle_rad``."""
    plateau = abs(angle_rad) * radius_m - ramp_m
    rise = np.clip((s_m - start_m) / ramp_m, 0, 1)
    fall = np.clip((start_m + 2 * ramp_m + plateau - s_m) / ramp_m, 0, 1)
    result: Array = np.sign(angle_rad) / radius_m * np.minimum(rise, fall)
    return result


def bend_length_m(angle_rad: float, radius_m: float, ramp_m: float = 4.0) -> float:
    """How much road a bend takes, ramps included."""
    return abs(angle_rad) * radius_m + ramp_m
