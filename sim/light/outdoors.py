"""Writes everything of the light that is part of the world's model: sun, sky light and skybox."""

from __future__ import annotations

import mujoco

from sim.light.daylight import daylight_of, write_lights
from sim.light.sky import write_sky
from sim.light.weather import WeatherConfig
from sim.seeds import rng_for


def write_outdoors(spec: mujoco.MjSpec, weather: WeatherConfig, seed: int) -> None:
    """Add the light of a weather to a finished world."""
    daylight = daylight_of(weather)
    write_lights(spec, daylight, False)
    write_sky(spec, daylight, min(1.0, weather.night), False, rng_for(seed, "weather.sky"))
