"""Low beams of cars with their cut-off, and their tail lamps: those of the driven car and of all others.

Other vehicles stop a beam; nothing else does. Seen from above that is enough, since a low beam lies low.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.light.lamps import LightSource
from sim.light.surfaces import Floats
from sim.light.vehicles import Shade, Vehicle, shades_of

_PEAK = 14.0  # illuminance at one metre, as in LightSource
_TAIL = 0.04
_DIP = 0.012  # tangent by which the cut-off lies under the horizon
_CUT_OFF = 0.012  # tangent over which it fades
_ABOVE = 0.015  # of the peak, above the cut-off
_DOWN = 0.05  # tangent over which the beam fades towards the car, so that the road is lit evenly
_HAZY, _HAZY_PEAK = 4.0, 0.25  # how much softer the beam is in fog, and what is left of its peak
_WIDE, _WIDER = 0.30, 0.85  # tangents of the beam's width and of its skirts
_REACH_M = 45.0  # ahead, of what others light
_ASIDE_M, _ASIDE = 2.0, 0.9  # aside of their middle line: at the lamps, and for each metre ahead
_PENUMBRA = 0.02  # tangent over which a shade fades
# What is seen of the lamps themselves: radius, level facing it, share seen from aside.
_FACE_M, _FACE_LEVEL, _TAIL_M, _TAIL_LEVEL, _FACE_ASIDE = 0.085, 420.0, 0.07, 26.0, 0.0
_GLARE = 0.35  # illuminance at one metre before the car that a lamp sheds above its cut-off, for lit fog


def headlight_light(
    car: Vehicle, others: tuple[Vehicle, ...], points_m: Floats, normals: Floats, *, as_one: bool = False
) -> Floats:
    """Return the illuminance by both beams of a car, for (3, ...) world points and normals.

    Args:
        car: Whose beams.
        others: What stops them.
        points_m: (3, ...) world positions.
        normals: (3, ...) unit world normals.
        as_one: Let one lamp in the middle stand for both, up to some distance: cheaper, and good enough for
            beams that are not seen from behind.
    """
    shape = points_m.shape[1:]
    points, normals = points_m.reshape(3, -1), normals.reshape(3, -1)
    total = np.zeros(points.shape[1], np.float32)
    car_from_world = car.world_from_car.inverse()
    turn, shift = car_from_world.rotation.astype(np.float32), car_from_world.translation.astype(np.float32)
    places = car.headlamps_m
    if as_one:
        places = places.mean(axis=0, keepdims=True)
    x = turn[0] @ points + shift[0]
    reached = x > np.float32(car.headlamp_m[0] + 0.1)
    if as_one:
        y = np.abs(turn[1] @ points + shift[1])
        reached &= (x < _REACH_M) & (y < np.float32(_ASIDE_M) + np.float32(_ASIDE) * x)
    ahead = np.flatnonzero(reached)
    points_car = turn @ points[:, ahead] + shift[:, None]
    normals_car = turn @ normals[:, ahead]
    for place in places:
        away = points_car - np.asarray(place, np.float32)[:, None]
        distance2 = np.einsum("ij,ij->j", away, away)
        facing = np.maximum(-np.einsum("ij,ij->j", away, normals_car), 0)
        lit = beam(away) * facing / (distance2 * np.sqrt(distance2))
        for shade in shades_of(_triple(place), car, others):
            lit *= _past(shade, away)
        total[ahead] += lit
    return total.reshape(shape) * np.float32(2 / len(places))


def _past(shade: Shade, away: Floats) -> Floats:
    """Return the share of a lamp's light that gets past a vehicle to (3, N) points seen from it."""
    across = away[1] / away[0]
    from_edge = np.minimum(across - np.float32(shade.right), np.float32(shade.left) - across)
    hidden = np.clip(from_edge / np.float32(_PENUMBRA) + np.float32(0.5), 0, 1)
    return np.asarray(1 - hidden * (away[0] > shade.beyond_m), np.float32)


def hazy_beam(away_ego: Floats) -> Floats:
    """Return the intensity of one beam along (3, ...) directions, blurred as it scatters more than once."""
    ahead = np.maximum(away_ego[0], np.float32(0.05))
    lit = beam(np.stack([ahead, away_ego[1], away_ego[2]]), _HAZY)
    return np.asarray(np.where(away_ego[0] > 0.05, np.float32(_HAZY_PEAK) * lit, np.float32(0)))


def beam(away_ego: Floats, softness: float = 1.0) -> Floats:
    """Return the intensity of one beam along (3, ...) directions in the ego frame that point ahead."""
    across, up = away_ego[1] / away_ego[0], away_ego[2] / away_ego[0] + np.float32(_DIP)
    below = 1 / (1 + np.square(np.minimum(up, 0) / np.float32(softness * _DOWN)))
    edge = np.exp(-np.square(np.maximum(up, 0) / np.float32(softness * _CUT_OFF)))
    above = _ABOVE + (1 - _ABOVE) * edge
    wide = np.exp(-np.square(across / np.float32(_WIDE))) + 0.07 * np.exp(
        -np.abs(across / np.float32(_WIDER))
    )
    return np.asarray(np.float32(_PEAK / 1.07) * below * above * wide, np.float32)


def tail_lamps(car: Vehicle) -> tuple[LightSource, ...]:
    """Return the tail lamps of a car where they are now."""
    back = -car.world_from_car.rotation[:, 0]
    places = car.world_from_car.apply(car.tail_lamps_m)
    return tuple(
        LightSource(_triple(place), _triple(back), _TAIL, (0.05, 0.45), _TAIL_M, _TAIL_LEVEL, _FACE_ASIDE)
        for place in places
    )


def headlamps(car: Vehicle) -> tuple[LightSource, ...]:
    """Return the faces of a car's headlamps, with the little that they shed above their cut-off."""
    ahead = car.world_from_car.rotation[:, 0]
    places = car.world_from_car.apply(car.headlamps_m)
    return tuple(
        LightSource(_triple(place), _triple(ahead), _GLARE, (0.05, 0.45), _FACE_M, _FACE_LEVEL, _FACE_ASIDE)
        for place in places
    )


def _triple(vector: Array) -> tuple[float, float, float]:
    return float(vector[0]), float(vector[1]), float(vector[2])
