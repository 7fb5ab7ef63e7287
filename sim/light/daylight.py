"""What a sky of some weather sheds: direct sun, light from above and around, and how much of it in all."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import ArrayLike

from estimator.se3 import Array
from sim.light.weather import WeatherConfig, on_ladder

_SUN_DISTANCE_M = 150.0
_CLEAR_SUN = np.array([1.22, 1.17, 1.07])
_CLEAR_AMBIENT, _GREY_AMBIENT = np.array([0.41, 0.42, 0.44]), np.array([0.72, 0.72, 0.72])
_CLEAR_ABOVE, _GREY_ABOVE = np.array([0.14, 0.15, 0.17]), np.array([0.38, 0.38, 0.38])
_DUSK_LOSS = 0.4  # of what the ground gets: only a part of the sky is still bright
_CLEAR_OPPOSITE = np.array([0.31, 0.32, 0.34])
_DAY_CHANNEL = np.array([1.0, 0.0, 0.0])  # see sim.light.channels
_LUMA = np.array([0.299, 0.587, 0.114])


@dataclass(frozen=True, eq=False)
class Daylight:
    """The sky's light.

    Attributes:
        toward_sun: (3,) world direction to the sun.
        sun: Direct light as a share of a clear day's.
        grey: How overcast the sky is, 0 to 1.
        dusk: How far the sun has gone, 0 to 1.
        level: All daylight, sky included, relative to what the lights are set to; a clear day's is 1.
    """

    toward_sun: Array
    sun: float
    grey: float
    dusk: float
    level: float


def daylight_of(weather: WeatherConfig) -> Daylight:
    """Work out the daylight; fog and rain bring their own clouds."""
    clouds = max(
        weather.overcast,
        float(np.interp(weather.fog, [0, 1, 5], [0, 2.5, 5])),
        float(np.interp(weather.rain, [0, 1, 5], [0, 3.0, 5])),
    )
    through_clouds = on_ladder(clouds, (1.0, 0.72, 0.45, 0.22, 0.07, 0.0))
    set_already = on_ladder(weather.dusk, (1.0, 0.3, 0.06, 0.0, 0.0, 0.0)) * max(0.0, 1.0 - weather.night)
    level = (
        on_ladder(clouds, (1.0, 0.92, 0.83, 0.74, 0.65, 0.56))
        * on_ladder(weather.dusk, (1.0, 0.5, 0.3, 0.19, 0.125, 0.085))
        * on_ladder(weather.night, (1.0, 0.012, 0.007, 0.0035, 0.0018, 0.0008))
    )
    return Daylight(
        direction(weather.sun_elevation_deg, weather.sun_azimuth_deg),
        through_clouds * set_already,
        clouds / 5.0,
        min(1.0, weather.dusk / 2.0),
        level,
    )


def direction(elevation_deg: float, azimuth_deg: float) -> Array:
    """Return the (3,) unit world vector of a direction."""
    elevation, azimuth = np.deg2rad([elevation_deg, azimuth_deg])
    return np.array(
        [np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)]
    )


def write_lights(spec: mujoco.MjSpec, daylight: Daylight, in_channels: bool) -> None:
    """Add sun and fill light; ``in_channels``: only to the channel that daylight has (sim.light.channels)."""
    up, clear = daylight.toward_sun, 1.0 - daylight.grey
    around = clear * (1.0 - daylight.dusk)  # the blue sky away from the sun is brighter than a grey one

    def tint(color: Array) -> Array:
        return np.asarray(_LUMA @ color * _DAY_CHANNEL if in_channels else color)

    fading = 1.0 - _DUSK_LOSS * daylight.dusk
    ambient = (_GREY_AMBIENT + around * (_CLEAR_AMBIENT - _GREY_AMBIENT)) * fading
    above = (_GREY_ABOVE + around * (_CLEAR_ABOVE - _GREY_ABOVE)) * fading
    spec.visual.headlight.active = 1
    spec.visual.headlight.ambient = tint(ambient) + ([0.0, 1.0, 1.0] if in_channels else [0.0, 0.0, 0.0])
    spec.visual.headlight.diffuse = [0.0, 0.0, 0.0]
    spec.visual.headlight.specular = [0.0, 0.0, 0.0]
    if daylight.sun > 0:
        shine = tint(np.full(3, 0.3)) * daylight.sun
        _add_light(spec, "sun", _SUN_DISTANCE_M * up, -up, tint(_CLEAR_SUN) * daylight.sun, shine)
    _add_light(spec, "sky_above", (0, 0, 50), (0, 0, -1), tint(above))
    if around > 0:
        away = np.array([-up[0], -up[1], 0.35])
        away /= np.linalg.norm(away)
        _add_light(spec, "sky_opposite", (0, 0, 50), -away, tint(_CLEAR_OPPOSITE) * around)


def _add_light(
    spec: mujoco.MjSpec,
    name: str,
    pos: ArrayLike,
    toward: ArrayLike,
    diffuse: ArrayLike,
    shine: ArrayLike | None = None,
) -> None:
    """Add a light from far away; with ``shine``, its highlights, it casts shadows."""
    spec.worldbody.add_light(
        name=name,
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        pos=pos,
        dir=toward,
        diffuse=diffuse,
        ambient=[0.0, 0.0, 0.0],
        specular=[0.0, 0.0, 0.0] if shine is None else shine,
        castshadow=shine is not None,
    )
