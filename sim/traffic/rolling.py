"""How the parts of vehicles on four wheels move: wheels turn with the way driven, and steer."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.se3 import Array
from sim.traffic.model import Model
from sim.traffic.pose import PITCH, YAW, X, Y, Z


def rolling(travelled_m: Array, curvature_1pm: Array, models: Sequence[Model]) -> Array:
    """Return (N, 5, 5) part poses: body, rear left, rear right, front left and front right wheel.

    Args:
        travelled_m: (N,) way driven so far.
        curvature_1pm: (N,) of the way under the vehicle, positive to the left.
        models: One a vehicle.
    """
    axles = np.array([model.axles_m for model in models]).reshape(-1, 2)
    half_track = np.array([model.track_m / 2 for model in models])
    radius = np.array([model.wheel_m for model in models])
    poses = np.zeros((len(models), 5, 5))
    for axle in (0, 1):
        for k, side in enumerate((1.0, -1.0)):
            wheel = 1 + 2 * axle + k
            poses[:, wheel, X], poses[:, wheel, Y] = axles[:, axle], side * half_track
            poses[:, wheel, Z], poses[:, wheel, PITCH] = radius, travelled_m / radius
    steer = np.arctan(curvature_1pm * (axles[:, 1] - axles[:, 0]))
    poses[:, 3:, YAW] = steer[:, None]
    return poses
