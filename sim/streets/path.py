"""Where a street runs: a smooth path, and street coordinates (s along it, d to its left) on it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

STEP_M = 0.1


@dataclass(frozen=True, eq=False)
class Path:
    """A curve sampled every ``STEP_M``, from ``start_m`` (which may be negative) on.

    Attributes:
        start_m: Arc length at the first point.
        points_m: (N, 2) world xy.
        headings_rad: (N,) not wrapped.
    """

    start_m: float
    points_m: Array
    headings_rad: Array

    @property
    def end_m(self) -> float:
        """Arc length at the last point."""
        return self.start_m + STEP_M * (len(self.points_m) - 1)

    def heading_rad(self, s_m: Array | float) -> Array:
        """Direction at arc length s."""
        at = (np.asarray(s_m, float) - self.start_m) / STEP_M
        return np.interp(at, np.arange(len(self.headings_rad)), self.headings_rad)

    def point_m(self, s_m: Array | float, d_m: Array | float = 0.0) -> Array:
        """World xy of street coordinates; broadcasts, result (..., 2). Both ends go on straight."""
        s_m, d_m = np.broadcast_arrays(np.asarray(s_m, float), np.asarray(d_m, float))
        at = (s_m - self.start_m) / STEP_M
        index = np.arange(len(self.points_m))
        heading = np.interp(at, index, self.headings_rad)
        beyond = STEP_M * (at - np.clip(at, 0, index[-1]))
        x = np.interp(at, index, self.points_m[:, 0]) + beyond * np.cos(heading) - d_m * np.sin(heading)
        y = np.interp(at, index, self.points_m[:, 1]) + beyond * np.sin(heading) + d_m * np.cos(heading)
        return np.stack([x, y], axis=-1)


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


def straight_path(origin_m: Array, heading_rad: float, length_m: float) -> Path:
    """A straight path from a point on."""
    s_m = np.arange(round(length_m / STEP_M) + 1) * STEP_M
    direction = np.array([np.cos(heading_rad), np.sin(heading_rad)])
    return Path(0.0, np.asarray(origin_m) + s_m[:, None] * direction, np.full(len(s_m), heading_rad))


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
