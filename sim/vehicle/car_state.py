"""Reading pose and velocity of the car out of a MuJoCo state."""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.se3 import SE3, Array
from sim.vehicle.car import CHASSIS


def world_from_ego(data: mujoco.MjData) -> SE3:
    """Return the pose of the chassis as MuJoCo computed it last."""
    chassis = data.body(CHASSIS)
    return SE3(chassis.xmat.reshape(3, 3), chassis.xpos)


def velocity_in_ego(model: mujoco.MjModel, data: mujoco.MjData) -> Array:
    """Return the (6,) angular (rad/s) and linear (m/s) velocity of the ego frame, in itself."""
    velocity = np.zeros(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY.value, data.body(CHASSIS).id, velocity, 1)
    return velocity
