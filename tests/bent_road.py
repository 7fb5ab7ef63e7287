"""Scenes whose road is no plane: a flat one bent upwards or downwards along x, cars, walls and all."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from estimator.scene import Scene
from estimator.se3 import SE3, Array

_WHEELBASE_M = 2.7
Height = Callable[[Array], Array]


def crest(bend_per_m: float, at_m: float = 3.0) -> Height:
    """Return the height of a road whose slope falls by so much a metre."""
    return lambda x: np.asarray(-0.5 * bend_per_m * (x - at_m) ** 2)


def bent(scene: Scene, height: Height) -> Scene:
    """Lift everything by the road's height at its x, and put the car on it with both its axles."""
    poses = []
    for pose in scene.world_from_egos:
        x, y, z = pose.translation
        slope = float(height(np.array(x + _WHEELBASE_M)) - height(np.array(x))) / _WHEELBASE_M
        pitch = SE3.exp(np.array([0.0, -np.arctan(slope), 0.0, 0.0, 0.0, 0.0]))
        lifted = np.array([x, y, z + float(height(np.array(x)))])
        poses.append(SE3(pitch.rotation @ pose.rotation, lifted))
    points = scene.points_world + height(scene.points_world[:, 0])[:, None] * np.array([0.0, 0.0, 1.0])
    return replace(scene, world_from_egos=tuple(poses), points_world=points)
