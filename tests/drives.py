"""Lines and roads to drive along, and what a driven car did, for tests of the vehicle."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from estimator.se3 import SE3, Array
from sim.vehicle.car import CarConfig
from sim.vehicle.drive import DriveConfig
from sim.vehicle.ground_contact import Road
from sim.vehicle.motion import Motion, MotionState
from sim.vehicle.route import Route, route_along

CAR = CarConfig()
STRAIGHT = route_along(np.array([[0.0, 0.0], [800.0, 0.0]]))


def bend(radius_m: float, lead_m: float = 20.0) -> Route:
    """A straight, a quarter circle to the left, 30 m straight."""
    turn = np.arange(0.1 / radius_m, np.pi / 2, 0.1 / radius_m)[:, None]
    arc = [lead_m, radius_m] + radius_m * np.hstack([np.sin(turn), -np.cos(turn)])
    end, out = [lead_m + radius_m, radius_m], [lead_m + radius_m, radius_m + 30.0]
    return route_along(np.concatenate([[[0.0, 0.0], [lead_m, 0.0]], arc, [end, out]]))


def ellipse(half_length_m: float, half_width_m: float) -> Route:
    """A closed line through the origin along +x."""
    turn = np.linspace(0.0, 2 * np.pi, 2000)
    return route_along(
        np.column_stack([half_length_m * np.sin(turn), half_width_m * (1 - np.cos(turn))]), closed=True
    )


@dataclass(frozen=True)
class Ramp:
    """A road that is level, then climbs with a constant slope, and may have a hump across it."""

    slope: float = 0.0
    hump_m: float = 0.0
    hump_at_m: float = 25.0

    def road_height_m(self, xy_m: Array) -> Array:
        x = np.asarray(xy_m)[..., 0]
        beyond = np.clip(x - 10.0, 0.0, None)
        climb = self.slope * np.where(beyond < 10.0, beyond**2 / 20.0, beyond - 5.0)
        u = np.clip(np.abs(x - self.hump_at_m), 0.0, 1.0)
        return np.asarray(climb + self.hump_m * (0.5 + 0.5 * np.cos(np.pi * u)))


@dataclass(frozen=True)
class Hillside:
    """A road that climbs all the way."""

    slope: float

    def road_height_m(self, xy_m: Array) -> Array:
        return np.asarray(self.slope * np.asarray(xy_m)[..., 0])


@dataclass(frozen=True, eq=False)
class Seen:
    """The car at one instant."""

    time_s: float
    state: MotionState

    @property
    def world_from_ego(self) -> SE3:
        x, y, z, qw, qx, qy, qz = self.state.qpos[:7]
        return SE3(Rotation.from_quat([qx, qy, qz, qw]).as_matrix(), np.array([x, y, z]))

    @property
    def velocity_ego_mps(self) -> Array:
        return self.world_from_ego.rotation.T @ self.state.qvel[:3]

    @property
    def yaw_rate_radps(self) -> float:
        return float(self.state.qvel[5])

    @property
    def pitch_deg(self) -> float:
        """Nose down is positive."""
        return float(-np.degrees(np.arcsin(self.world_from_ego.rotation[2, 0])))

    @property
    def roll_deg(self) -> float:
        """Leaning to the right is positive."""
        return float(np.degrees(np.arcsin(self.world_from_ego.rotation[2, 1])))


def drive(
    config: DriveConfig, route: Route = STRAIGHT, road: Road | None = None, every_s: float = 0.05
) -> tuple[Motion, list[Seen]]:
    """Drive to the end; return the motion and the car at even times."""
    motion = Motion(config, route, road, CAR)
    return motion, list(follow(motion, every_s))


def follow(motion: Motion, every_s: float) -> Iterator[Seen]:
    """Yield the car at even times until its drive is over."""
    for time_s in np.arange(0.0, motion.plan.duration_s, every_s):
        yield Seen(float(time_s), motion.state_at(float(time_s)))


def off_route_m(route: Route, seen: Seen) -> float:
    """Distance of the rear axle from the nearest point of the route."""
    position_m = seen.world_from_ego.translation[:2]
    return float(np.linalg.norm(route.points_m - position_m, axis=1).min())
