"""Metric scale from the road: the reference camera's height above it is known."""

from __future__ import annotations

import numpy as np

from estimator.observations import Mask
from estimator.se3 import Array

MIN_SUPPORT = 12
_BANDWIDTH = 0.03  # of log height
MIN_SLOPE = 0.1  # nearer than about ten camera heights: beyond, half a degree of pitch moves the road
_OUTSIDE_WEIGHT = 0.1  # of a point that is not in the car's path: it may be pavement


def road_scale(
    points_level: Array, in_path: Mask, camera_height_m: float, prior_sigma: float = np.inf
) -> float | None:
    """Return the factor that puts the road at z = 0 below a camera of known height.

    The road is the densest level among the points below the camera: facades spread over all heights, the
    road does not. Assumes points within reach of the camera's own road patch and a known up direction.

    Args:
        points_level: (N, 3) in a gravity-aligned frame centred in the camera (x forward, z up), any unit.
        in_path: (N,) whether the point lies where the car drives.
        camera_height_m: Height of the camera above the road.
        prior_sigma: Relative standard deviation with which the unit is already believed to be the metre.

    Returns:
        Metres per unit, or None where too few points agree.
    """
    depth = -points_level[:, 2]
    reach = np.hypot(points_level[:, 0], points_level[:, 1])
    slope = depth / np.maximum(reach, 1e-9)
    below = np.isfinite(depth) & (depth > 0) & (slope > MIN_SLOPE)
    if below.sum() < MIN_SUPPORT:
        return None
    weight = np.minimum(slope[below], 0.5) * np.where(in_path[below], 1.0, _OUTSIDE_WEIGHT)
    return densest_scale(depth[below], weight, camera_height_m, _BANDWIDTH, prior_sigma)


def densest_scale(
    depth: Array, weight: Array, camera_height_m: float, bandwidth: float, prior_sigma: float
) -> float | None:
    """Return the factor that puts the densest of (N,) depths below a camera at the camera's height.

    None where too few agree, or where the height is none: a camera in or under the road gives no scale.
    """
    if not camera_height_m > 0:
        return None
    level = np.log(depth)
    grid = np.arange(level.min() - 0.1, level.max() + 0.1, bandwidth / 3)
    distance = (grid[:, None] - level[None]) / bandwidth
    surprise = (grid - np.log(camera_height_m)) / max(prior_sigma, 1e-6)
    density = (np.exp(-0.5 * distance**2) @ weight) * np.exp(-0.5 * surprise**2)
    near = np.abs(distance[int(density.argmax())]) < 2
    if near.sum() < MIN_SUPPORT:
        return None
    return float(camera_height_m / np.exp(np.median(level[near])))
