"""Fog and rain in the air: what they take from the light of far things, and what they add.

Koschmieder's law with the true distance along the ray. Where lamps shine, the air around them glows: single
scattering of a point source along the ray, in closed form (Sun et al. 2005, "A practical analytic single
scattering model", without the attenuation inside the integral, which the ray's end stands for).
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from estimator.se3 import SE3
from sim.light.headlights import beam, headlight_places_m
from sim.light.lamps import LightSource
from sim.light.surfaces import Floats, Surfaces
from sim.light.weather import WeatherConfig, on_ladder
from sim.rendering.view import FAR_M

_CONTRAST_SEEN = 3.0  # optical thickness at the meteorological range: a contrast of 5 percent
_LAYER_M, _HORIZON_M = 40.0, 400.0  # how thick fog lies over the ground, and how far it goes
_WHITE = 255.0  # levels that illuminance 1 gives on white
_COARSE = 2  # lit air is smooth: every other sample will do
_BEAM_STEPS_M = np.array([0.8, 1.6, 3.0, 5.0, 8.0, 12.0, 18.0, 27.0, 40.0], np.float32)


def extinction_per_m(weather: WeatherConfig) -> float:
    """Return how much of the light a metre of air takes."""
    fog_range_m = np.array([np.inf, 250.0, 120.0, 65.0, 38.0, 22.0])
    fog = on_ladder(weather.fog, tuple(_CONTRAST_SEEN / fog_range_m))
    return fog + on_ladder(weather.rain, (0.0, 0.0015, 0.003, 0.006, 0.010, 0.016))


def transmission(surfaces: Surfaces, per_m: float) -> Floats:
    """Return (H, W) share of light that arrives; that of the sky comes through a layer of fog."""
    distance = surfaces.depth_m * surfaces.stretch
    # Over their own far depth the sky's samples rise as steeply as their rays do.
    rise = (surfaces.points_m[2] - surfaces.eye_m[2]) / np.float32(FAR_M)
    up = np.maximum(surfaces.enlarged(rise), 0) / surfaces.stretch
    through_layer = np.float32(_LAYER_M) / (up + np.float32(_LAYER_M / _HORIZON_M))
    return np.asarray(np.exp(-np.float32(per_m) * np.where(surfaces.sky, through_layer, distance)))


def lamp_haze(sources: Sequence[LightSource], surfaces: Surfaces, per_m: float) -> Floats:
    """Return (h, w) levels that the lit air before each surface adds, by lamps."""
    rays, reach = _rays(surfaces)
    total = np.zeros(reach.shape, np.float32)
    for source in sources:
        to_lamp = np.asarray(source.position_m, np.float32) - surfaces.eye_m
        nearest = np.einsum("i,ihw->hw", to_lamp, rays)
        apart = np.sqrt(np.maximum(float(to_lamp @ to_lamp) - nearest**2, 0.04))
        spread = np.arctan((reach - nearest) / apart) + np.arctan(nearest / apart)
        dimmed = np.exp(-per_m * float(np.linalg.norm(to_lamp)))
        total += np.float32(source.intensity * dimmed) * spread / apart
    return _finer(total * np.float32(_WHITE * per_m / 4), surfaces)


def headlight_haze(world_from_ego: SE3, surfaces: Surfaces, per_m: float) -> Floats:
    """Return (h, w) levels that the car's own beams add: sampled along the ray."""
    rays, reach = _rays(surfaces)
    total = np.zeros(reach.shape, np.float32)
    turn = world_from_ego.inverse().rotation.astype(np.float32)
    rays_ego = np.einsum("ij,jhw->ihw", turn, rays)
    for place in headlight_places_m(world_from_ego):
        start = turn @ (surfaces.eye_m - place.astype(np.float32))
        before = np.float32(0)
        for step in _BEAM_STEPS_M:
            away = start[:, None, None] + step * rays_ego
            length = np.clip(reach - before, 0, step - before)
            before = step
            ahead = away[0] > 0.3
            away[0] = np.maximum(away[0], 0.3)
            distance2 = np.einsum("ihw,ihw->hw", away, away)
            lit = beam(away.reshape(3, -1)).reshape(distance2.shape) / distance2
            total += np.where(ahead, lit * length * np.exp(-per_m * 2 * step), 0)
    return _finer(total * np.float32(_WHITE * per_m / 4), surfaces)


def _rays(surfaces: Surfaces) -> tuple[Floats, Floats]:
    """Return (3, h, w) unit rays and (h, w) how far they go, on the coarse grid."""
    away = surfaces.points_m[:, ::_COARSE, ::_COARSE] - surfaces.eye_m[:, None, None]
    reach = np.sqrt(np.einsum("ihw,ihw->hw", away, away))
    return away / reach, reach


def _finer(coarse: Floats, surfaces: Surfaces) -> Floats:
    rows, columns = surfaces.points_m.shape[1:]
    return np.asarray(cv2.resize(coarse, (columns, rows), interpolation=cv2.INTER_LINEAR))
