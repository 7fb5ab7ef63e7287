"""The ground under each wheel: a plane of its own, moved with it to where the tyre meets the road.

A wheel of radius R over the heights z(u) along its rolling direction stands at the height of the highest
circle, ``max over u of z(u) + sqrt(R^2 - u^2)``; the u that wins tells the slope. So a wheel climbs a kerb's
edge before its centre is over it and bridges what is narrower than itself. The tyre's footprint is averaged
before.

Reference: Schmeitz 2004, "A semi-empirical three-dimensional model of the pneumatic tyre rolling over
arbitrarily uneven road surfaces", ch. 4 (enveloping).
"""

from __future__ import annotations

from typing import Protocol

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.vehicle.car import CHASSIS, WHEELS, CarConfig
from sim.vehicle.car_physics import STEP_S

_SPACING_M = 0.05
_REACH = 5  # samples to either side of the contact that can touch the tyre
_FOOTPRINT = 3  # samples over which the tyre's belt averages along, and as wide as the tyre across
_SAMPLE_EVERY_M = 0.2  # of travel; between, height and normal change evenly
_LOOK_AHEAD_STEPS = 10  # short enough that where the wheels will be is known to a millimetre


_QUARTER_TURN = np.array([[0.0, 1.0], [-1.0, 0.0]])  # times a row: that row turned left


def _sampling(count: int) -> tuple[Array, Array]:
    """Return the times in s to sample at, and the (steps, count) weights that interpolate to every step."""
    steps = np.arange(_LOOK_AHEAD_STEPS)
    at = np.linspace(0.0, _LOOK_AHEAD_STEPS - 1, count)
    return STEP_S * at, np.stack([np.interp(steps, at, unit) for unit in np.eye(count)], axis=1)


_SAMPLINGS = tuple(_sampling(count) for count in range(2, _LOOK_AHEAD_STEPS + 1))


class Road(Protocol):
    """Where the wheels roll."""

    def road_height_m(self, xy_m: Array) -> Array:
        """Height of the road's surface, (...), at (..., 2) world positions."""


class GroundContact:
    """The patches under the four wheels of one car on one road."""

    def __init__(self, model: mujoco.MjModel, road: Road, car: CarConfig) -> None:
        self._road = road
        self._chassis = int(model.body(CHASSIS).id)
        self._wheels = [int(model.body(f"{wheel}_wheel").id) for wheel in WHEELS]
        self._patches = [int(model.body(f"{wheel}_patch").mocapid[0]) for wheel in WHEELS]
        self._radii_m = np.array([car.free_radius_m(wheel) for wheel in WHEELS])
        half_m = car.tyre_width_m / 2
        self._across_m = np.array([-0.6 * half_m, 0.6 * half_m])
        reach = _REACH + _FOOTPRINT // 2
        self._along_m = _SPACING_M * np.arange(-reach, reach + 1)
        inner_m = _SPACING_M * np.arange(-_REACH, _REACH + 1)
        self._circles_m = np.sqrt(self._radii_m[:, None] ** 2 - inner_m**2) - self._radii_m[:, None]
        self._positions_m = self._quaternions = np.empty((1, 4, 0))

    def follow(self, data: mujoco.MjData, step: int) -> None:
        """Put the patches under the wheels for the step with that number."""
        ahead = step % _LOOK_AHEAD_STEPS
        if ahead == 0:
            self._look_ahead(data)
        data.mocap_pos[self._patches] = self._positions_m[ahead]
        data.mocap_quat[self._patches] = self._quaternions[ahead]

    def _look_ahead(self, data: mujoco.MjData) -> None:
        """Find the patches for the next steps, from where the wheels are and how they move."""
        centers_m = data.xpos[self._wheels, :2]
        arms_m = centers_m - data.xpos[self._chassis, :2]
        velocities_mps = data.qvel[:2] + data.qvel[5] * (arms_m @ _QUARTER_TURN)
        travel_m = STEP_S * _LOOK_AHEAD_STEPS * float(np.abs(velocities_mps).max())
        at_s, shares = _SAMPLINGS[min(int(travel_m / _SAMPLE_EVERY_M), len(_SAMPLINGS) - 1)]
        axles = data.xmat[self._wheels].reshape(-1, 3, 3)[:, :2, 1]
        left = axles / np.hypot(axles[:, :1], axles[:, 1:])
        positions_m, normals = self._patches_at(centers_m + at_s[:, None, None] * velocities_mps, left)
        self._positions_m = _blend(shares, positions_m)
        self._quaternions = _upright_to(_blend(shares, normals))

    def _patches_at(self, centers_m: Array, left: Array) -> tuple[Array, Array]:
        """Return a point and the normal of each patch, (K, 4, 3), for wheel centres (K, 4, 2)."""
        forward = np.stack([left[:, 1], -left[:, 0]], axis=1)
        offsets_m = self._along_m[:, None, None, None] * forward + self._across_m[:, None, None] * left
        around_m = centers_m[:, None, None] + offsets_m  # (K, along, across, 4, 2)
        heights_m = self._road.road_height_m(around_m).transpose(0, 3, 2, 1)  # (K, 4, across, along)
        envelope_m, slope = self._envelope(heights_m.sum(2) / len(self._across_m))
        middle = heights_m[..., _REACH : _REACH + _FOOTPRINT].sum(-1) / _FOOTPRINT
        tilt = (middle[..., 1] - middle[..., 0]) / (self._across_m[1] - self._across_m[0])
        normals = np.empty((*slope.shape, 3))
        normals[..., :2] = -slope[..., None] * forward - tilt[..., None] * left
        normals[..., 2] = 1.0
        normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
        points_m = np.concatenate([centers_m, (envelope_m + self._radii_m)[..., None]], axis=-1)
        return points_m - self._radii_m[:, None] * normals, normals

    def _envelope(self, heights_m: Array) -> tuple[Array, Array]:
        """Return how high the unloaded tyre's lowest point stands, and the slope it stands on, (K, 4)."""
        summed = np.cumsum(heights_m, axis=-1)
        belt_m = summed[..., _FOOTPRINT - 1 :].copy()
        belt_m[..., 1:] -= summed[..., :-_FOOTPRINT]
        circles_m = belt_m / _FOOTPRINT + self._circles_m
        best = circles_m[..., 1:-1].argmax(-1) + 1
        instant, wheel = np.ogrid[: best.shape[0], : best.shape[1]]
        low, top, high = (circles_m[instant, wheel, best + step] for step in (-1, 0, 1))
        bend = np.minimum(low - 2 * top + high, -1e-9)
        share = np.minimum(np.maximum((low - high) / (2 * bend), -1.0), 1.0)
        contact_m = _SPACING_M * (best - _REACH + share)
        slope = contact_m / np.sqrt(self._radii_m**2 - contact_m**2)
        return top - (low - high) ** 2 / (8 * bend), slope


def _blend(shares: Array, values: Array) -> Array:
    return np.asarray((shares @ values.reshape(len(values), -1)).reshape(-1, *values.shape[1:]))


def _upright_to(normals: Array) -> Array:
    """Return the w x y z quaternions that turn +z to (..., 3) normals."""
    quaternions = np.stack(
        [1 + normals[..., 2], -normals[..., 1], normals[..., 0], np.zeros(normals.shape[:-1])], axis=-1
    )
    return np.asarray(quaternions / np.linalg.norm(quaternions, axis=-1, keepdims=True))
