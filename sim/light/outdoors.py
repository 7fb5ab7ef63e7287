"""Writes everything of the light that is part of the world's model: sun, sky light and skybox."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import mujoco

from sim.light.channels import GlowImage, write_channels
from sim.light.daylight import daylight_of, write_lights
from sim.light.sky import write_sky
from sim.light.weather import WeatherConfig
from sim.seeds import rng_for
from sim.streets.scenery import Skin


def glows_of(skins: Iterable[Mapping[str, Skin]]) -> dict[str, GlowImage]:
    """Return what skins shed, by the name that their textures get."""
    return {
        f"texture_{name}": skin.glow
        for named in skins
        for name, skin in named.items()
        if skin.glow is not None
    }


def write_outdoors(
    spec: mujoco.MjSpec, weather: WeatherConfig, seed: int, glows: Mapping[str, GlowImage] | None = None
) -> None:
    """Add the light of a weather to an otherwise finished world.

    Args:
        spec: The world; textures and colours become channels if ``glows`` is given.
        weather: The weather.
        seed: Draws the clouds.
        glows: What shines by itself, by texture name (``sim.light.channels``); None for pictures of daylight.
    """
    daylight = daylight_of(weather)
    if glows is not None:
        write_channels(spec, glows)
    write_lights(spec, daylight, glows is not None)
    night = min(1.0, weather.night)
    write_sky(spec, daylight, night, glows is not None, rng_for(seed, "weather.sky"))
