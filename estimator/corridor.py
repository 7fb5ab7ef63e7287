"""Which landmarks are road: those where the car itself drives.

Pavements, kerbs and parking bays are as flat as the road and a hand's breadth higher; by their look they can
not be told apart. What lies between the wheels can only be road.
"""

from __future__ import annotations

import numpy as np

from estimator.observations import Index, Mask, Observations
from estimator.scene import Scene
from estimator.se3 import Array

_MIN_SLOPE = 0.2


def nearest_keyframe(scene: Scene, points_world: Array) -> Index:
    """Return for (N, 3) points the (N,) keyframe at which the middle of the car came nearest."""
    return _beside_the_car(scene, points_world)[0]


def road_up(scene: Scene, points_world: Array) -> Array:
    """Return (N, 3) unit normals of the road under points: upright for the car where it stood nearest."""
    ups = np.stack([pose.rotation[:, 2] for pose in scene.world_from_egos])
    return np.asarray(ups[nearest_keyframe(scene, points_world)])


def road_height_m(scene: Scene, points_world: Array) -> Array:
    """Return (N,) heights over the ground that the car stood on where it stood nearest."""
    return np.asarray(_beside_the_car(scene, points_world)[1][:, 2])


def in_corridor(scene: Scene, points_world: Array) -> Mask:
    """Tell which of (N, 3) points lie under the car's path, or shortly before or after it."""
    ahead, beside = _beside_the_car(scene, points_world)[1][:, :2].T
    limits = scene.corridor
    with np.errstate(invalid="ignore"):
        return np.asarray((np.abs(beside) < limits.half_width_m) & (np.abs(ahead) < limits.beyond_ends_m))


def _beside_the_car(scene: Scene, points_world: Array) -> tuple[Index, Array]:
    """Return (N,) the keyframes where the car came nearest to points, and (N, 3) the points in its frame."""
    local = np.stack([pose.inverse().apply(points_world) for pose in scene.world_from_egos])
    distance_m = np.hypot(local[..., 0] - scene.corridor.middle_m, local[..., 1])
    nearest = np.argmin(np.nan_to_num(distance_m, nan=np.inf), axis=0)
    return nearest, local[nearest, np.arange(len(points_world))]


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
    """Return (M,) the landmarks under the car's path within a tolerance of the road, seen from near."""
    low = low_landmarks(scene, observations, tolerance_m)
    return np.asarray(low & in_corridor(scene, scene.points_world))


def low_landmarks(scene: Scene, observations: Observations, tolerance_m: float) -> Mask:
    """Return (M,) the landmarks near the road's level wherever they are: road, pavement, parking bay."""
    with np.errstate(invalid="ignore"):
        low = np.abs(road_height_m(scene, scene.points_world)) < tolerance_m
    return np.asarray(low & seen_from_near(scene, observations))
