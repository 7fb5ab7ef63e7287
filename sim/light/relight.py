"""Light that is not the sky's: street lamps, tunnel lamps, headlights, and what they leave dark.

A picture in channels is put together again: daylight as far as it reaches, lamps on the albedo, what glows.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sim.light.channels import Channels
from sim.light.daylight import daylight_of
from sim.light.headlights import headlamps, headlight_light, tail_lamps
from sim.light.lamps import REACH_M, LightSource, lamp_light
from sim.light.surfaces import Floats, Surfaces
from sim.light.tunnels import CoveredRoad, TunnelShade
from sim.light.vehicles import Vehicle
from sim.light.weather import WeatherConfig, on_ladder

_BOUNCED = 0.05  # illuminance that walls pass on in a tunnel of lamps of full strength
_FACES = 3.0  # times that strength at which a tunnel's lamps look as bright as street lamps
_FARTHEST_M = 140.0  # lamps beyond light nothing that a camera resolves


class Relight:
    """The lamps of one world and how much daylight there is left for them to replace."""

    def __init__(
        self,
        weather: WeatherConfig,
        lamps: Sequence[LightSource],
        tunnel_lamps: Sequence[LightSource],
        tunnels: Sequence[CoveredRoad],
    ) -> None:
        """Lamps come as they would shine on a dark night in a dark tunnel."""
        self._daylight = daylight_of(weather).level
        at_dusk = on_ladder(weather.dusk, (0.0, 0.0, 0.3, 1.0, 1.0, 1.0))
        lit = max(min(1.0, weather.night), at_dusk)
        # The darker the night, the fewer lamps burn, and the dimmer: always the same ones at a severity.
        share = on_ladder(weather.night, (1.0, 1.0, 0.85, 0.7, 0.5, 0.35))
        town = on_ladder(weather.night, (1.0, 1.0, 0.7, 0.5, 0.35, 0.22))
        in_tunnel = on_ladder(weather.tunnel, (0.0, 0.25, 0.18, 0.13, 0.09, 0.06))
        self.lamps = (
            *(dimmed(lamp, lit * town) for lamp in _some(lamps, share) if lit > 0),
            *(_faint(dimmed(lamp, in_tunnel)) for lamp in tunnel_lamps if in_tunnel > 0),
        )
        self.headlights = max(lit, min(1.0, weather.dusk), min(1.0, weather.tunnel))
        self.glow = town * max(lit, 0.6 * min(1.0, weather.dusk))
        self._shade = TunnelShade(tunnels, on_ladder(weather.tunnel, (20.0, 5.0, 4.4, 3.9, 3.5, 3.2)))
        self._bounced = _BOUNCED * in_tunnel
        self._is_shaded = bool(tunnels) and weather.tunnel > 0
        self._tunnel_depth = min(1.0, weather.tunnel)

    def near(self, surfaces: Surfaces) -> list[LightSource]:
        """Return the lamps that matter to a view."""
        eye = surfaces.eye_m
        return [
            lamp for lamp in self.lamps if np.hypot(*(np.array(lamp.position_m[:2]) - eye[:2])) < _FARTHEST_M
        ]

    def daylight(self, surfaces: Surfaces) -> Floats | None:
        """Return the (h, w) share of daylight that reaches each sample; None for all everywhere."""
        if not self._is_shaded:
            return None
        share = self._shade.daylight(surfaces.points_m)
        return np.asarray(1 - np.float32(self._tunnel_depth) * (1 - share))

    def on_cars(self, others: Sequence[Vehicle]) -> list[LightSource]:
        """Return the faces of the lamps of the traffic's cars, as bright as they are now."""
        faces = [lamp for car in others for lamp in (*headlamps(car), *tail_lamps(car))]
        return [replace(lamp, level=self.headlights * lamp.level) for lamp in faces]

    def facing(self, surfaces: Surfaces, others: Sequence[Vehicle]) -> list[LightSource]:
        """Return the headlamps of the traffic that glare into a view, for the air around them."""
        found = []
        for lamp in (lamp for car in others if car.beams > 0 for lamp in headlamps(car)):
            away_m = surfaces.eye_m - np.array(lamp.position_m)
            cosine = float(away_m @ np.array(lamp.aim)) / float(np.linalg.norm(away_m))
            if cosine > 0:
                found.append(dimmed(lamp, self.headlights * cosine))
        return found

    def lamplight(
        self, surfaces: Surfaces, sources: Sequence[LightSource], own: Vehicle, others: Sequence[Vehicle]
    ) -> Floats:
        """Return (h, w) illuminance by all lamps.

        Args:
            surfaces: The view's geometry.
            sources: Lamps of the street.
            own: The driven car.
            others: Cars of the traffic.
        """
        tails = [dimmed(lamp, self.headlights) for lamp in tail_lamps(own)]
        low, high = surfaces.points_m.reshape(3, -1).min(1), surfaces.points_m.reshape(3, -1).max(1)
        lit = [lamp for lamp in (*sources, *tails) if _within(lamp, low, high)]
        total = lamp_light(lit, surfaces.points_m, surfaces.normals)
        near = tuple(car for car in others if car.beams > 0)
        beams = headlight_light(own, near, surfaces.points_m, surfaces.normals)
        for car in near:
            ahead = headlight_light(car, (own, *near), surfaces.points_m, surfaces.normals, as_one=True)
            beams += np.float32(car.beams) * ahead
        return np.asarray(total + np.float32(self.headlights) * beams)

    def together(
        self,
        channels: Channels,
        surfaces: Surfaces,
        daylight: Floats | None,
        lamplight: Floats,
        wet: Floats | None,
    ) -> Floats:
        """Return the (H, W) picture in levels; ``wet`` is the (h, w) share of albedo that is left."""
        level = np.float32(self._daylight)
        by_day: Floats | np.float32 = level
        if daylight is not None:
            lamplight = lamplight + np.float32(self._bounced) * (1 - daylight)
        if daylight is not None or wet is not None:
            left = np.ones_like(lamplight) if wet is None else wet
            reaching = np.asarray(level * left if daylight is None else level * left * daylight, np.float32)
            by_day, lamplight = surfaces.enlarged(reaching), lamplight * left
            by_day[surfaces.sky] = level
        lit = channels.day * by_day + channels.albedo * surfaces.enlarged(lamplight)
        glow = channels.glow
        if self.glow < 1:
            glow = glow * np.where(surfaces.sky, np.float32(1), np.float32(self.glow))
        return np.asarray(lit + glow)


def dimmed(lamp: LightSource, factor: float) -> LightSource:
    """Return a lamp that gives ``factor`` times its light."""
    return replace(lamp, intensity=factor * lamp.intensity)


def _faint(lamp: LightSource) -> LightSource:
    """Return a lamp whose face is as dim as its light."""
    return replace(lamp, level=lamp.level * min(1.0, _FACES * lamp.intensity))


def _some(lamps: Sequence[LightSource], share: float) -> list[LightSource]:
    """Return a share of the lamps, evenly spread."""
    return [lamp for k, lamp in enumerate(lamps) if (k * 0.6180339887) % 1.0 < share]


def _within(lamp: LightSource, low: Floats, high: Floats) -> bool:
    at = np.array(lamp.position_m)
    return bool(((at > low - REACH_M) & (at < high + REACH_M))[:2].all())
