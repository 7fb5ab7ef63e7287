"""What lies between a rendered scene and a lens: lamps, darkness, wet ground, fog and rain.

Every source picture goes through ``Atmosphere.light`` before a lens bends it, and what the lens made of it
through ``Atmosphere.cover``. What ``light`` adds lives in the world, so that cameras, faces of one lens and
instants of one exposure agree. All is a function of time, so that instants may be asked for in any order.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import cv2
import numpy as np

from estimator.camera import Camera
from sim.light.channels import FloatImage, split
from sim.light.daylight import daylight_of
from sim.light.flare import Flare, mark_sun, with_halos
from sim.light.fog import extinction_per_m, headlight_haze, lamp_haze, transmission
from sim.light.instant import Instant
from sim.light.mirror import Mirror, Seen, wider
from sim.light.rain import Rain
from sim.light.relight import Relight
from sim.light.sprites import add_lamps
from sim.light.surfaces import Floats, Surfaces
from sim.light.surroundings import Surroundings
from sim.light.tunnels import TunnelShade
from sim.light.weather import WeatherConfig
from sim.light.wet_lens import WetLens
from sim.light.wet_road import WetRoad
from sim.rendering.view import Picture, RgbImage, View
from sim.seeds import rng_for

_LUMA = np.array([[0.299, 0.587, 0.114]], np.float32)  # ITU-R BT.601
_AIR_LEVEL = 235.0  # of thick fog by day: that of a grey horizon
_RAIN_COMES_IN_M = 3.0  # into a tunnel, carried by wind and wheels
_TOWN_AIR = 0.5  # levels of thick fog by night, between lamps


class Atmosphere:
    """The weather of one world, between its renderer and its lenses."""

    def __init__(
        self, weather: WeatherConfig, surroundings: Surroundings, cameras: Mapping[str, Camera], seed: int
    ) -> None:
        self._weather, self._daylight, self._cameras = weather, daylight_of(weather), cameras
        self.in_channels = needs_channels(weather, surroundings)
        self._extinction_per_m = extinction_per_m(weather)
        self._relight = Relight(weather, surroundings.lamps, surroundings.tunnel_lamps, surroundings.tunnels)
        raining = weather.rain > 0
        self._shelter = TunnelShade(surroundings.tunnels, _RAIN_COMES_IN_M) if raining else None
        self._rain = Rain(weather.rain, rng_for(seed, "weather.rain"), self._shelter) if raining else None
        self._wet_road = WetRoad(weather.rain, rng_for(seed, "weather.puddles")) if raining else None
        seen_sun = self._daylight.sun if weather.flare > 0 else 0.0
        self._flare = Flare(weather.flare, seen_sun) if seen_sun > 0 else None
        self._wet_lenses = {
            name: WetLens(weather.wet_lens, name, seed) for name in (cameras if weather.wet_lens > 0 else ())
        }

    @property
    def needs_depth(self) -> bool:
        """Whether ``light`` wants pictures with depth."""
        return self.in_channels or self._extinction_per_m > 0 or self._flare is not None

    def around(self, views: Mapping[str, View]) -> dict[str, View]:
        """Return the views whose pictures ``mirror`` wants of a camera that has these; none on dry ground."""
        return {} if self._wet_road is None else {name: wider(view) for name, view in views.items()}

    def mirror(self, pictures: Sequence[Picture], views: Sequence[View], instant: Instant) -> Mirror:
        """Return what a camera sees mirrored, from the pictures of its views ``around``."""
        around = []
        for picture, view in zip(pictures, views, strict=True):
            assert picture.depth_m is not None
            surfaces = Surfaces(view, picture.depth_m)
            wet = self._wetness(surfaces)
            assert wet is not None, "nothing is wet"
            light = self._lit(picture.rgb, surfaces, self._relight.daylight(surfaces), wet, view, instant)
            around.append(Seen(view, light, picture.depth_m, surfaces.enlarged(wet)))
        return Mirror(around)

    def light(
        self, picture: Picture, view: View, instant: Instant, mirror: Mirror | None = None
    ) -> FloatImage:
        """Return the (H, W) light of a picture, in levels of a sunny day: 255 is white in full light.

        Night is a small fraction of that, lamps may be above it; exposure is the sensor's affair. Wet ground
        shows what is in ``mirror``, nothing without it.
        """
        if not self.needs_depth:
            level = self._daylight.level
            return grey(picture.rgb) if level == 1.0 else grey(picture.rgb) * np.float32(level)
        assert picture.depth_m is not None
        surfaces = Surfaces(view, picture.depth_m)
        daylight = self._relight.daylight(surfaces)
        wet = self._wetness(surfaces)
        light = self._lit(picture.rgb, surfaces, daylight, wet, view, instant)
        if self._wet_road is not None and wet is not None and mirror is not None:
            strength, calm = self._wet_road.mirroring(wet, surfaces)
            mirrored = mirror.light(surfaces.points_m, surfaces.eye_m, calm)
            light += surfaces.enlarged(strength) * (surfaces.enlarged(mirrored) - light)
        if self._extinction_per_m > 0:
            light = self._through_air(light, surfaces, daylight, instant)
        if self._rain is not None:
            glow = 0.8 * _AIR_LEVEL * self._daylight.level + 4.0 * self._relight.headlights
            self._rain.add_streaks(light, view, picture.depth_m, instant.velocity_mps, instant.time_s, glow)
        if self._flare is not None:
            mark_sun(light, view, picture.depth_m, self._daylight.toward_sun)
        return light

    def cover(self, light: FloatImage, camera: str, time_s: float) -> FloatImage:
        """Return the (H, W) light of a camera's whole image with halos, flare and drops laid over it."""
        if self.in_channels:
            light = with_halos(light, 1.0 + self._weather.flare)
        if self._flare is not None:
            light = self._flare.over(light, self._cameras[camera])
        if camera in self._wet_lenses:
            light = self._wet_lenses[camera].over(light, time_s)
        return light

    def _wetness(self, surfaces: Surfaces) -> Floats | None:
        if self._wet_road is None or self._shelter is None:
            return None
        return self._wet_road.wetness(surfaces, self._shelter.daylight(surfaces.points_m))

    def _lit(
        self,
        rgb: RgbImage,
        surfaces: Surfaces,
        daylight: Floats | None,
        wet: Floats | None,
        view: View,
        instant: Instant,
    ) -> FloatImage:
        left = None if wet is None or self._wet_road is None else self._wet_road.darkened(wet)
        if not self.in_channels:
            light = grey(rgb) * np.float32(self._daylight.level)
            return light if left is None else light * surfaces.enlarged(left)
        sources = self._relight.near(surfaces)
        lamplight = self._relight.lamplight(surfaces, sources, instant.own, instant.vehicles)
        light = self._relight.together(split(rgb), surfaces, daylight, lamplight, left)
        add_lamps(light, [*sources, *self._relight.on_cars(instant.vehicles)], view, surfaces.depth_m)
        return light

    def _through_air(
        self, light: FloatImage, surfaces: Surfaces, daylight: Floats | None, instant: Instant
    ) -> FloatImage:
        per_m = self._extinction_per_m
        arrives = transmission(surfaces, per_m)
        air = np.full_like(light, _AIR_LEVEL * self._daylight.level)
        if daylight is not None:
            air *= surfaces.enlarged(daylight)
        air += np.float32(_TOWN_AIR * min(1.0, self._weather.night))
        result = air + arrives * (light - air)
        if self.in_channels:
            sources = [*self._relight.near(surfaces), *self._relight.facing(surfaces, instant.vehicles)]
            haze = lamp_haze(sources, surfaces, per_m)
            haze += self._relight.headlights * headlight_haze(instant.own, surfaces, per_m)
            result += cv2.resize(haze, light.shape[::-1], interpolation=cv2.INTER_LINEAR)
        return np.asarray(result, np.float32)


def needs_channels(weather: WeatherConfig, surroundings: Surroundings) -> bool:
    """Tell whether lamps matter, so that pictures must come as ``sim.light.channels`` has them."""
    in_tunnel = weather.tunnel > 0 and bool(surroundings.tunnels)
    return weather.dusk > 0 or weather.night > 0 or in_tunnel


def grey(picture: RgbImage) -> FloatImage:
    """Return (H, W) luma of an (H, W, 3) picture, unrounded."""
    return np.asarray(cv2.transform(picture.astype(np.float32), _LUMA))
