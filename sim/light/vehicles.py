"""Cars as the light sees them: where their lamps are, and what of other cars' light they stop.

The driven car and those of the traffic are treated alike. Cyclists and pedestrians stop no light.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from scipy.spatial.transform import Rotation

from estimator.se3 import SE3, Array
from sim.traffic.model import Model
from sim.traffic.traffic import Traffic

_HEAVY_M = 5.5  # what is longer carries its lamps higher
_BODYWORK_M = 0.1  # from the outer face of a wheel's middle to that of the body
_FROM_SIDE_M, _BEHIND_NOSE_M = 0.24, 0.12
_BEAMS_M = (40.0, 48.0)  # from the driven car, where others' beams begin to fade, and have
_SHADED_M, _ASIDE = 35.0, 0.8  # ahead of a lamp, and the tangent aside, from where a shade matters
SEEN_M = 140.0  # beyond, a lamp is no more than what a camera makes of its neighbours


@dataclass(frozen=True, eq=False)
class Vehicle:
    """A car with its lamps on.

    Attributes:
        world_from_car: Of a frame with x ahead, y left, z up, on the ground.
        ends_m: x of its tail and of its nose.
        half_width_m: Of its body.
        headlamp_m: x, y, z of the left one; the right one mirrors it.
        tail_lamp_m: Likewise.
        beams: Share of its beams that is worth working out, 0 to 1.
    """

    world_from_car: SE3
    ends_m: tuple[float, float]
    half_width_m: float
    headlamp_m: tuple[float, float, float]
    tail_lamp_m: tuple[float, float, float]
    beams: float = 1.0

    @property
    def headlamps_m(self) -> Array:
        """(2, 3) positions in its own frame."""
        return np.array(self.headlamp_m) * [[1, 1, 1], [1, -1, 1]]

    @property
    def tail_lamps_m(self) -> Array:
        """(2, 3) positions in its own frame."""
        return np.array(self.tail_lamp_m) * [[1, 1, 1], [1, -1, 1]]


def driven_vehicle(world_from_ego: SE3) -> Vehicle:
    """Return the car that carries the cameras."""
    return Vehicle(world_from_ego, (-1.02, 3.45), 0.9, (3.38, 0.58, 0.66), (-1.02, 0.62, 0.75))


def vehicles_at(traffic: Traffic, time_s: float, around_m: Array) -> tuple[Vehicle, ...]:
    """Return the traffic's vehicles on four wheels that are near a place at a time.

    Args:
        traffic: All that moves.
        time_s: Since the drive began.
        around_m: World position of the driven car.
    """
    found = []
    for troupe in traffic.troupes:
        if not any(model.track_m for model in troupe.models):
            continue
        stance = troupe.stance(time_s)
        away_m = np.linalg.norm(stance.origins_m - around_m, axis=1)
        turns = Rotation.from_euler("ZY", np.column_stack([stance.yaws_rad, stance.pitches_rad])).as_matrix()
        for k in np.flatnonzero(away_m < SEEN_M):
            beams = float(np.interp(away_m[k], _BEAMS_M, (1.0, 0.0)))
            found.append(_vehicle(troupe.models[k], SE3(turns[k], stance.origins_m[k]), beams))
    return tuple(found)


def _vehicle(model: Model, world_from_car: SE3, beams: float) -> Vehicle:
    half, half_width = model.length_m / 2, model.track_m / 2 + _BODYWORK_M
    high = (0.8, 1.0) if model.length_m > _HEAVY_M else (0.72, 0.8)
    y = half_width - _FROM_SIDE_M
    return Vehicle(
        world_from_car,
        (-half, half),
        half_width,
        (half - _BEHIND_NOSE_M, y, high[0]),
        (-half, y, high[1]),
        beams,
    )


@dataclass(frozen=True)
class Shade:
    """What a vehicle hides from a lamp, seen from above.

    Attributes:
        right: Tangent to its right side.
        left: Tangent to its left side.
        beyond_m: From how far ahead it is dark.
    """

    right: float
    left: float
    beyond_m: float


@lru_cache(maxsize=256)  # vehicles are told apart by identity: all views of an instant ask for the same
def shades_of(lamp_m: tuple[float, float, float], car: Vehicle, others: tuple[Vehicle, ...]) -> list[Shade]:
    """Return what others that are near hide from a lamp of a car; ``lamp_m`` is in the car's frame."""
    shades = []
    car_from_world = car.world_from_car.inverse()
    for other in others:
        if other is car:
            continue
        (rear, front), half = other.ends_m, other.half_width_m
        outline = np.array([(rear, half, 0), (rear, -half, 0), (front, -half, 0), (front, half, 0)])
        corners = (car_from_world @ other.world_from_car).apply(outline) - lamp_m
        if 0.3 < corners[:, 0].min() < _SHADED_M:
            sides = corners[:, 1] / corners[:, 0]
            if sides.max() > -_ASIDE and sides.min() < _ASIDE:
                shades.append(Shade(float(sides.min()), float(sides.max()), float(corners[:, 0].mean())))
    return shades
