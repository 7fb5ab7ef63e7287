"""Polylines with rounded corners, smooth enough to be driven: how paths turn at junctions, round blocks."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.ndimage import uniform_filter1d

from estimator.se3 import Array
from sim.streets.path import STEP_M, Path, path_through

RAMP_M = 2.0  # over which a turn sets in: nobody jerks the wheel


def rounded_path(
    corners_m: Array,
    radii_m: Sequence[float],
    closed: bool = False,
    start_m: float = 0.0,
    ramp_m: float = RAMP_M,
) -> Path:
    """Return the path along straight lines joined by arcs.

    Args:
        corners_m: (K, 2). Of an open line the first and last are its ends.
        radii_m: K radii; those of open ends are ignored.
        closed: Whether the last corner is joined to the first; the path then starts half-way between them.
        start_m: Arc length at its first point.
        ramp_m: Over which each arc sets in.
    """
    corners = np.asarray(corners_m, float)
    middle = (corners[-1] + corners[0]) / 2
    before = np.vstack([corners[-1], corners[:-1]])
    after = np.vstack([corners[1:], corners[:1]])
    pieces = [
        corner[None] if not closed and k in (0, len(corners) - 1) else _arc(last, corner, then, radius)
        for k, (last, corner, then, radius) in enumerate(zip(before, corners, after, radii_m, strict=True))
    ]
    line = np.vstack([middle, *pieces, middle]) if closed else np.vstack(pieces)
    return smoothed(path_through(line, closed, start_m), ramp_m)


def _arc(before_m: Array, corner_m: Array, after_m: Array, radius_m: float) -> Array:
    """Points of the arc that touches both legs of a corner."""
    back, ahead = before_m - corner_m, after_m - corner_m
    back, ahead = back / np.linalg.norm(back), ahead / np.linalg.norm(ahead)
    half = np.arccos(np.clip(back @ ahead, -1, 1)) / 2
    if np.pi / 2 - half < 1e-3:
        return corner_m[None]
    bisector = (back + ahead) / np.linalg.norm(back + ahead)
    center = corner_m + bisector * radius_m / np.sin(half)
    first = corner_m + back * radius_m / np.tan(half) - center
    turn = np.sign(-back[0] * ahead[1] + back[1] * ahead[0]) * (np.pi - 2 * half)
    angles = np.linspace(0, turn, max(4, round(abs(turn) * radius_m / STEP_M)))
    cos, sin = np.cos(angles), np.sin(angles)
    return np.asarray(
        center + np.stack([cos * first[0] - sin * first[1], sin * first[0] + cos * first[1]], axis=1)
    )


def smoothed(path: Path, ramp_m: float = RAMP_M) -> Path:
    """Let curvature ramp up and down; straight stretches stay where they are."""
    width = 2 * round(ramp_m / path.step_m / 2) + 1  # odd, or the path would shift
    points = path.points_m
    if path.closed:
        ring = uniform_filter1d(uniform_filter1d(points[:-1], width, 0, mode="wrap"), width, 0, mode="wrap")
        return path_through(np.vstack([ring, ring[:1]]), True, path.start_m)
    reach = np.arange(width + 1, 0, -1)[:, None]
    padded = np.vstack(
        [
            points[0] - reach * (points[1] - points[0]),
            points,
            points[-1] + reach[::-1] * (points[-1] - points[-2]),
        ]
    )
    soft = uniform_filter1d(uniform_filter1d(padded, width, 0, mode="nearest"), width, 0, mode="nearest")
    soft = soft[width + 1 : -(width + 1)]
    return path_through(np.vstack([points[:1], soft[1:-1], points[-1:]]), False, path.start_m)
