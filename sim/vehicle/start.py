"""Put the car on its route before a drive: on its wheels, on whatever slope, rolling or standing."""

from __future__ import annotations

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.vehicle.car import WHEELS, CarConfig
from sim.vehicle.ground_contact import Road
from sim.vehicle.route import Route


def place_on_route(
    model: mujoco.MjModel,
    data: mujoco.MjData,
    route: Route,
    along_m: float,
    backwards: bool,
    speed_mps: float,
    road: Road | None,
    car: CarConfig,
) -> None:
    """Put the rear axle over a point of the route, the car as high and as tilted as the road there.

    Args:
        model: The physics of the car.
        data: Its state, which is reset.
        route: In the order of travel.
        along_m: Where on the route.
        backwards: Whether the car looks against the direction of travel.
        speed_mps: Along the direction of travel; the wheels roll with it.
        road: What the wheels stand on; None for the plane z = 0.
        car: The car's sizes.
    """
    sign = -1.0 if backwards else 1.0
    forward, origin_m = sign * route.direction(along_m), route.point_m(along_m)
    height_m, rotation = _stance(origin_m, forward, road, car)
    mujoco.mj_resetData(model, data)
    data.qpos[:3] = [*origin_m, height_m]
    mujoco.mju_mat2Quat(data.qpos[3:7], rotation.ravel())
    data.qvel[:3] = sign * speed_mps * rotation[:, 0]
    for wheel in WHEELS:
        data.joint(f"{wheel}_spin").qvel[0] = sign * speed_mps / car.rolling_radius_m(wheel)
    mujoco.mj_forward(model, data)


def _stance(origin_m: Array, forward: Array, road: Road | None, car: CarConfig) -> tuple[float, Array]:
    """Return height and (3, 3) rotation of a car whose wheels stand on the road."""
    left = np.array([-forward[1], forward[0]])
    arms_m = np.array([car.wheel_position_m(wheel)[:2] for wheel in WHEELS])
    wheels_m = origin_m + arms_m[:, :1] * forward + arms_m[:, 1:] * left
    heights_m = np.zeros(len(WHEELS)) if road is None else road.road_height_m(wheels_m)
    slope, tilt, height_m = np.linalg.lstsq(np.column_stack([arms_m, np.ones(4)]), heights_m, rcond=None)[0]
    ahead = np.array([*forward, slope]) / np.hypot(1.0, slope)
    up = np.cross(ahead, np.array([*left, tilt]))
    up /= np.linalg.norm(up)
    return float(height_m), np.stack([ahead, np.cross(up, ahead), up], axis=1)
