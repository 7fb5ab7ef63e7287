"""How the car is driven: rolled up to the start of the path at speed, then steered along it."""

from __future__ import annotations

import mujoco
import numpy as np
from pydantic import Field

from estimator.config import Config
from estimator.se3 import SE3, Array
from sim.vehicle.car import CHASSIS, DRIVEN, STEERED, WHEELS, CarConfig, ackermann_rad
from sim.vehicle.follower import Follower

RUN_UP_S = 2.0
_SPEED_GAIN_PS = 2.0  # acceleration asked for, per speed error
_HARDEST_PUSH_MPS2 = 4.0


class DriveConfig(Config):
    """Speed, length and bundle rate of a drive."""

    speed_mps: float = Field(5.0, gt=0.0, le=40.0)
    distance_m: float = Field(50.0, gt=0.0, le=2000.0)
    rate_hz: float = Field(10.0, ge=1.0, le=60.0)

    @property
    def bundle_count(self) -> int:
        """Bundles at both ends of the drive and every period between."""
        return int(self.distance_m / self.speed_mps * self.rate_hz + 1e-6) + 1

    def time_s(self, index: int) -> float:
        """Return when bundle ``index`` is taken, since the drive began."""
        return index / self.rate_hz


def place_rolling(
    model: mujoco.MjModel, data: mujoco.MjData, path_m: Array, speed_mps: float, car: CarConfig
) -> None:
    """Put the car at rest height on the straight before the path, rolling along it."""
    heading = (path_m[1] - path_m[0]) / np.linalg.norm(path_m[1] - path_m[0])
    yaw_rad = float(np.arctan2(heading[1], heading[0]))
    mujoco.mj_resetData(model, data)
    data.qpos[:2] = path_m[0] - speed_mps * RUN_UP_S * heading
    data.qpos[3:7] = [np.cos(yaw_rad / 2), 0, 0, np.sin(yaw_rad / 2)]
    data.qvel[:2] = speed_mps * heading
    for wheel in WHEELS:
        data.joint(f"{wheel}_spin").qvel[0] = speed_mps / car.wheel_radius_m
    mujoco.mj_forward(model, data)


def step(
    model: mujoco.MjModel, data: mujoco.MjData, follower: Follower, speed_mps: float, car: CarConfig
) -> None:
    """Advance the physics by one step under the follower's steering and the speed controller."""
    velocity_ego = velocity_in_ego(model, data)
    angles_rad = ackermann_rad(follower.steer_rad(world_from_ego(data), speed_mps), car)
    for wheel, angle_rad in zip(STEERED, angles_rad, strict=True):
        data.actuator(f"{wheel}_servo").ctrl[0] = np.clip(
            angle_rad, -car.steer_limit_rad, car.steer_limit_rad
        )
    push_mps2 = np.clip(
        _SPEED_GAIN_PS * (speed_mps - velocity_ego[3]), -_HARDEST_PUSH_MPS2, _HARDEST_PUSH_MPS2
    )
    for wheel in DRIVEN:
        torque_nm = car.mass_kg * push_mps2 * car.wheel_radius_m / len(DRIVEN)
        data.actuator(f"{wheel}_motor").ctrl[0] = torque_nm
    mujoco.mj_step(model, data)


def world_from_ego(data: mujoco.MjData) -> SE3:
    """Return the pose of the chassis as MuJoCo computed it last."""
    chassis = data.body(CHASSIS)
    return SE3(chassis.xmat.reshape(3, 3), chassis.xpos)


def velocity_in_ego(model: mujoco.MjModel, data: mujoco.MjData) -> Array:
    """Return the (6,) angular (rad/s) and linear (m/s) velocity of the ego frame, in itself."""
    velocity = np.zeros(6)
    mujoco.mj_objectVelocity(model, data, mujoco.mjtObj.mjOBJ_XBODY.value, data.body(CHASSIS).id, velocity, 1)
    return velocity
