"""The benchmark of what weather costs runs, on a dry day and in rain."""

import pytest

from tests.benchmark.weather_costs import cost


@pytest.mark.parametrize("settings", [(), ("weather.rain=4", "weather.night=2")], ids=["dry", "wet night"])
def test_weather_is_timed(settings: tuple[str, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tests.benchmark.weather_costs._GOES", 1)
    spent_ms, rendering_ms, pixels = cost((*settings, "quality=draft", "street.length_m=55"))
    assert spent_ms > 0 and rendering_ms > 0 and pixels > 7 * 640 * 400
