"""Which landmarks are road: those where the car itself drives.

Pavements, kerbs and parking bays are as flat as the road and a hand's breadth higher; by their look they can
not be told apart. What lies between the wheels can only be road.
"""

from __future__ import annotations

import numpy as np

from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import Array

_HALF_WIDTH_M = 1.4
_BEYOND_ENDS_M = 5.0
_MIN_SLOPE = 0.2


def in_corridor(scene: Scene, points_world: Array) -> Mask:
    """Tell which of (N, 3) points lie under the car's path, or shortly before or after it."""
    poses = scene.world_from_egos
    local = np.stack([pose.inverse().apply(points_world) for pose in poses])
    nearest = np.argmin(np.nan_to_num(np.hypot(local[..., 0], local[..., 1]), nan=np.inf), axis=0)
    ahead, beside = local[nearest, np.arange(len(points_world))][:, :2].T
    with np.errstate(invalid="ignore"):
        return np.asarray((np.abs(beside) < _HALF_WIDTH_M) & (np.abs(ahead) < _BEYOND_ENDS_M))


def seen_from_near(scene: Scene, observations: Observations, min_slope: float = _MIN_SLOPE) -> Mask:
    """Tell which (M,) landmarks some camera saw at least this steeply from above."""
    points = scene.points_world[observations.landmark]
    _, center = scene.pose_arrays(observations.camera, observations.keyframe)
    down = center - points
    slope = down[:, 2] / np.maximum(np.hypot(down[:, 0], down[:, 1]), 1e-9)
    steepest = np.full(len(scene.points_world), -np.inf)
    np.maximum.at(steepest, observations.landmark, np.nan_to_num(slope, nan=-np.inf))
    return np.asarray(steepest > min_slope)


def road_landmarks(scene: Scene, observations: Observations, tolerance_m: float) -> Mask:
    """Return (M,) the landmarks under the car's path within a tolerance of z = 0, seen from near."""
    with np.errstate(invalid="ignore"):
        low = np.abs(scene.points_world[:, 2]) < tolerance_m
    return np.asarray(low & in_corridor(scene, scene.points_world) & seen_from_near(scene, observations))


def low_landmarks(scene: Scene, observations: Observations, tolerance_m: float) -> Mask:
    """Return (M,) the landmarks near z = 0 wherever they are: road, pavement, parking bay."""
    with np.errstate(invalid="ignore"):
        low = np.abs(scene.points_world[:, 2]) < tolerance_m
    return np.asarray(low & seen_from_near(scene, observations))
