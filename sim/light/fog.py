"""Fog and rain in the air: what they take from the light of far things, and what they add.

Koschmieder's law with the true distance along the ray. Where lamps shine, the air around them glows: single
scattering of a point source along the ray, in closed form (Sun et al. 2005, "A practical analytic single
scattering model", without the attenuation inside the integral, which the ray's end stands for).
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from sim.light.headlights import hazy_beam
from sim.light.lamps import LightSource
from sim.light.surfaces import Floats, Surfaces
from sim.light.vehicles import Vehicle
from sim.light.weather import WeatherConfig, on_ladder

_CONTRAST_SEEN = 3.0  # optical thickness at the meteorological range: a contrast of 5 percent
_LAYER_M, _HORIZON_M = 40.0, 400.0  # how thick fog lies over the ground, and how far it goes
_WHITE = 255.0  # levels that illuminance 1 gives on white
_COARSE = 2  # lit air is smooth: every other sample will do
_BEAM_STEPS = 20


def extinction_per_m(weather: WeatherConfig) -> float:
    """Return how much of the light a metre of air takes."""
    fog_range_m = np.array([np.inf, 250.0, 120.0, 65.0, 38.0, 22.0])
    fog = on_ladder(weather.fog, tuple(_CONTRAST_SEEN / fog_range_m))
    return fog + on_ladder(weather.rain, (0.0, 0.0015, 0.003, 0.006, 0.010, 0.016))


def transmission(surfaces: Surfaces, per_m: float) -> Floats:
    """Return (H, W) share of light that arrives; that of the sky comes through a layer of fog."""
    distance = surfaces.depth_m * surfaces.stretch
    sky = surfaces.sky
    up = np.maximum(surfaces.rise[sky], 0) / surfaces.stretch[sky]
    distance[sky] = np.float32(_LAYER_M) / (up + np.float32(_LAYER_M / _HORIZON_M))
    return np.asarray(cv2.exp(distance * np.float32(-per_m)))


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


def headlight_haze(car: Vehicle, surfaces: Surfaces, per_m: float) -> Floats:
    """Return (h, w) levels that a car's beams add.

    Sampled along the ray at equal angles seen from the lamp, which cancels the inverse square (Kulla and
    Fajardo 2012, "Importance sampling techniques for path tracing in participating media").
    """
    rays, reach = _rays(surfaces)
    turn = car.world_from_car.rotation.T.astype(np.float32)
    rays = np.einsum("ij,jhw->ihw", turn, rays)
    total = np.zeros(reach.shape, np.float32)
    for place in car.world_from_car.apply(car.headlamps_m):
        to_lamp = turn @ (place.astype(np.float32) - surfaces.eye_m)
        nearest = np.einsum("i,ihw->hw", to_lamp, rays)
        apart = np.sqrt(np.maximum(float(to_lamp @ to_lamp) - nearest**2, np.float32(0.01)))
        first, last = np.arctan(-nearest / apart), np.arctan((reach - nearest) / apart)
        for share in (np.arange(_BEAM_STEPS, dtype=np.float32) + np.float32(0.5)) / np.float32(_BEAM_STEPS):
            along = nearest + apart * np.tan(first + share * (last - first))
            away = along * rays - to_lamp[:, None, None]
            lit = hazy_beam(away) * np.exp(np.float32(-2 * per_m) * along)
            total += lit * (last - first) / (apart * np.float32(_BEAM_STEPS))
    return _finer(total * np.float32(_WHITE * per_m / 4), surfaces)


def _rays(surfaces: Surfaces) -> tuple[Floats, Floats]:
    """Return (3, h, w) unit rays and (h, w) how far they go, on the coarse grid."""
    away = surfaces.points_m[:, ::_COARSE, ::_COARSE] - surfaces.eye_m[:, None, None]
    reach = np.sqrt(np.einsum("ihw,ihw->hw", away, away))
    return away / reach, reach


def _finer(coarse: Floats, surfaces: Surfaces) -> Floats:
    rows, columns = surfaces.points_m.shape[1:]
    return np.asarray(cv2.resize(coarse, (columns, rows), interpolation=cv2.INTER_LINEAR))
