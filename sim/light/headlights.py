"""The car's own lights: two low beams with their cut-off, carried by the chassis, and two tail lamps."""

from __future__ import annotations

import numpy as np

from estimator.se3 import SE3, Array
from sim.light.lamps import LightSource
from sim.light.surfaces import Floats

_PLACES_EGO_M = ((3.38, 0.58, 0.66), (3.38, -0.58, 0.66))
_TAILS_EGO_M = ((-1.02, 0.62, 0.75), (-1.02, -0.62, 0.75))
_PEAK = 14.0  # illuminance at one metre, as in LightSource
_TAIL = 0.04
_DIP = 0.012  # tangent by which the cut-off lies under the horizon
_CUT_OFF = 0.012  # tangent over which it fades
_ABOVE = 0.015  # of the peak, above the cut-off
_DOWN = 0.05  # tangent over which the beam fades towards the car, so that the road is lit evenly
_HAZY, _HAZY_PEAK = 4.0, 0.25  # how much softer the beam is in fog, and what is left of its peak
_WIDE, _WIDER = 0.30, 0.85  # tangents of the beam's width and of its skirts


def headlight_light(world_from_ego: SE3, points_m: Floats, normals: Floats) -> Floats:
    """Return the illuminance by both beams, for (3, ...) world points and normals."""
    shape = points_m.shape[1:]
    points, normals = points_m.reshape(3, -1), normals.reshape(3, -1)
    total = np.zeros(points.shape[1], np.float32)
    ego_from_world = world_from_ego.inverse()
    turn, shift = ego_from_world.rotation.astype(np.float32), ego_from_world.translation.astype(np.float32)
    ahead = np.flatnonzero(turn[0] @ points + shift[0] > np.float32(_PLACES_EGO_M[0][0] + 0.1))
    points_ego = turn @ points[:, ahead] + shift[:, None]
    normals_ego = turn @ normals[:, ahead]
    for place in _PLACES_EGO_M:
        away = points_ego - np.asarray(place, np.float32)[:, None]
        distance2 = np.einsum("ij,ij->j", away, away)
        facing = np.maximum(-np.einsum("ij,ij->j", away, normals_ego), 0)
        total[ahead] += beam(away) * facing / (distance2 * np.sqrt(distance2))
    return total.reshape(shape)


def headlight_places_m(world_from_ego: SE3) -> Array:
    """Return the (2, 3) world positions of the headlights."""
    return world_from_ego.apply(np.array(_PLACES_EGO_M))


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


def tail_lamps(world_from_ego: SE3) -> tuple[LightSource, ...]:
    """Return the tail lamps where they are now."""
    back = -world_from_ego.rotation[:, 0]
    places = world_from_ego.apply(np.array(_TAILS_EGO_M))
    return tuple(
        LightSource((float(x), float(y), float(z)), (float(back[0]), float(back[1]), float(back[2])), _TAIL)
        for x, y, z in places
    )
