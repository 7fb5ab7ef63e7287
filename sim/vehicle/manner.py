"""How hard a driver accelerates and brakes, and where he stops: what sets the drive profiles apart."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.vehicle.car import GRAVITY_MPS2
from sim.vehicle.drive import DriveConfig

_COMFORT_LATERAL_MPS2 = 2.5
_LATERAL_SHARE, _BRAKE_SHARE, _PUSH_SHARE = 0.6, 0.5, 0.3  # of the grip; two wheels push, four brake
_HARD_BRAKING_MPS2 = 8.0


@dataclass(frozen=True)
class Stop:
    """A standstill at a distance from the start, for a time."""

    at_m: float
    for_s: float


@dataclass(frozen=True)
class Manner:
    """Limits in m/s2, how long a pedal takes to be pressed, and the standstills of a drive."""

    push_mps2: float
    brake_mps2: float
    lateral_mps2: float
    pedal_s: float
    stops: tuple[Stop, ...]


def manner_of(config: DriveConfig) -> Manner:
    """Return the manner of a drive."""
    grip_mps2 = config.grip * GRAVITY_MPS2
    push, brake = min(1.8, _PUSH_SHARE * grip_mps2), min(2.2, _BRAKE_SHARE * grip_mps2)
    lateral = config.lateral_mps2 or min(_COMFORT_LATERAL_MPS2, _LATERAL_SHARE * grip_mps2)
    end_m, speed = config.distance_m, config.speed_mps
    if config.profile == "pull_away":
        return Manner(push, brake, lateral, 0.6, (Stop(0.0, 1.0),))
    if config.profile == "stop_and_go":
        between_m = speed**2 / 2 * (1 / push + 1 / brake) + 1.5 * speed
        stops = tuple(Stop(float(at_m), 2.0) for at_m in np.arange(between_m, end_m, between_m))
        return Manner(push, brake, lateral, 0.6, (Stop(0.0, 1.0), *stops))
    if config.profile == "crawl":
        halt = Stop(end_m / 2, 1.5)
        return Manner(min(push, 0.6), min(brake, 0.8), lateral, 0.5, (Stop(0.0, 1.0), halt))
    if config.profile == "hard_braking":
        return Manner(push, _HARD_BRAKING_MPS2, lateral, 0.25, (Stop(0.6 * end_m, 1.0),))
    return Manner(push, brake, lateral, 0.6, ())


def cruising_mps(config: DriveConfig, along_m: Array) -> Array:
    """Return the speed wanted on a straight, by distance; only who gropes along varies it."""
    if config.profile == "crawl":
        return np.asarray(config.speed_mps * (0.7 + 0.3 * np.cos(along_m * 2 * np.pi / 7.0)))
    return np.full(along_m.shape, config.speed_mps)
