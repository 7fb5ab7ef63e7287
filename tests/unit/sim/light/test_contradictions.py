"""Weather that cannot be is refused; what merely is unusual is not."""

import numpy as np
import pytest

from sim.light.contradictions import TUNNEL_KINDS, check_weather
from sim.light.weather import WeatherConfig
from sim.streets.kinds import PLANS, SHORTEST_M, Ground, draw_network


@pytest.mark.parametrize("kind", PLANS)
def test_a_dark_tunnel_is_taken_by_the_streets_that_have_a_tunnel_and_by_no_other(kind: str) -> None:
    rngs = (np.random.default_rng(1), np.random.default_rng(2))
    assert bool(draw_network(kind, SHORTEST_M[kind][0], Ground(), *rngs).tunnels) == (kind in TUNNEL_KINDS)
    if kind in TUNNEL_KINDS:
        check_weather(kind, WeatherConfig(tunnel=3))
    else:
        with pytest.raises(ValueError, match=rf"^weather\.tunnel: got 3.*{kind}.*kinds with one: tunnel"):
            check_weather(kind, WeatherConfig(tunnel=3))


def test_the_sun_does_not_set_twice() -> None:
    with pytest.raises(ValueError, match=r"^weather\.dusk: got 2 with weather\.night 3, wanted one"):
        check_weather("bend", WeatherConfig(dusk=2, night=3))


@pytest.mark.parametrize(
    ("cover", "told"), [("overcast", "overcast 5"), ("fog", "fog 5"), ("rain", "rain 5")]
)
def test_no_sun_flares_behind_closed_clouds(cover: str, told: str) -> None:
    with pytest.raises(ValueError, match=rf"^weather\.flare: got 2, .*through weather\.{told}"):
        check_weather("bend", WeatherConfig(**{"flare": 2.0, cover: 5.0}))


@pytest.mark.parametrize(
    "weather",
    [
        {"flare": 2, "overcast": 4},
        {"flare": 2, "night": 3},  # halos of lamps
        {"flare": 2, "dusk": 4},
        {"wet_lens": 2},  # spray of others
        {"fog": 3, "rain": 3, "overcast": 1, "night": 2},
    ],
)
def test_what_merely_is_unusual_is_taken(weather: dict[str, float]) -> None:
    check_weather("bend", WeatherConfig(**weather))
