"""Weather that cannot be, or that nobody would see: refused rather than drawn as something else."""

from __future__ import annotations

from sim.light.daylight import daylight_of
from sim.light.weather import WeatherConfig

TUNNEL_KINDS = ("tunnel",)  # streets that have one


def check_weather(street_kind: str, weather: WeatherConfig) -> None:
    """Refuse settings of the weather that contradict each other or the street.

    Raises:
        ValueError: What was got and what was wanted, with the dotted path.
    """
    if weather.tunnel > 0 and street_kind not in TUNNEL_KINDS:
        raise ValueError(
            f"weather.tunnel: got {weather.tunnel:g}, wanted 0 where street.kind is {street_kind}, which has "
            f"no tunnel; kinds with one: {', '.join(TUNNEL_KINDS)}"
        )
    if weather.dusk > 0 and weather.night > 0:
        raise ValueError(
            f"weather.dusk: got {weather.dusk:g} with weather.night {weather.night:g}, wanted one of them 0: "
            "the sun has either just set or long been down"
        )
    clouds = [name for name in ("overcast", "fog", "rain") if getattr(weather, name) > 0]
    by_day = not weather.dusk and not weather.night
    if weather.flare > 0 and by_day and daylight_of(weather).sun == 0:
        told = " and ".join(f"weather.{name} {getattr(weather, name):g}" for name in clouds)
        raise ValueError(
            f"weather.flare: got {weather.flare:g}, wanted 0 or thinner clouds: no sun gets through {told}"
        )
