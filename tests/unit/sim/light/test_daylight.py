"""How much daylight there is in a weather."""

import numpy as np
import pytest
from pydantic import ValidationError

from sim.light.daylight import daylight_of, direction
from sim.light.weather import WeatherConfig, on_ladder


def test_a_plain_day_is_full_day() -> None:
    plain = daylight_of(WeatherConfig())
    assert (plain.sun, plain.grey, plain.dusk, plain.level) == (1.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize("effect", ["overcast", "dusk", "night", "fog", "rain"])
def test_daylight_only_falls_with_severity(effect: str) -> None:
    levels = [daylight_of(WeatherConfig(**{effect: s})).level for s in np.linspace(0, 5, 21)]
    suns = [daylight_of(WeatherConfig(**{effect: s})).sun for s in np.linspace(0, 5, 21)]
    assert np.all(np.diff(levels) < 0)
    assert np.all(np.diff(suns) <= 0)


def test_directions_count_from_x_to_the_left_and_up() -> None:
    assert np.allclose(direction(0, 90), [0, 1, 0], atol=1e-12)
    assert np.allclose(direction(90, 0), [0, 0, 1], atol=1e-12)


def test_a_ladder_is_straight_between_its_rungs() -> None:
    assert on_ladder(1.5, (0.0, 1.0, 3.0, 4.0, 5.0, 6.0)) == 2.0


@pytest.mark.parametrize(
    "effect", ["overcast", "dusk", "night", "tunnel", "fog", "rain", "wet_lens", "flare"]
)
@pytest.mark.parametrize("severity", [-0.1, 5.1])
def test_a_severity_beyond_the_ladder_is_refused(effect: str, severity: float) -> None:
    with pytest.raises(ValidationError, match=effect):
        WeatherConfig(**{effect: severity})
