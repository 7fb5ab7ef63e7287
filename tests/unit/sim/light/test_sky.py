"""The sky: where the sun is, what clouds do to it, and that its faces are the world's directions."""

import mujoco
import numpy as np
import pytest

from sim.light.daylight import daylight_of
from sim.light.sky import night_glow, sky_colors, sky_rays, write_sky
from sim.light.weather import WeatherConfig
from sim.paint.noise import fractal

FACE_PX = 256
RAYS = sky_rays(FACE_PX)
CLOUDS = fractal(np.random.default_rng(0), (64, 128), (12, 20), 5, 0.55)
LUMA = np.array([0.299, 0.587, 0.114])


def grey_sky(**weather: float) -> np.ndarray:
    return sky_colors(RAYS, daylight_of(WeatherConfig(**weather)), CLOUDS) @ LUMA


def test_rays_are_unit_and_point_everywhere() -> None:
    assert np.allclose(np.linalg.norm(RAYS, axis=-1), 1)
    assert np.allclose(RAYS.reshape(-1, 3).mean(0), 0, atol=1e-12)


def test_the_third_face_is_overhead_and_the_first_looks_along_x() -> None:
    faces = RAYS.reshape(6, FACE_PX, FACE_PX, 3)
    middle = faces[:, FACE_PX // 2, FACE_PX // 2]
    assert middle[2, 2] > 0.99
    assert middle[0, 0] > 0.99


@pytest.mark.parametrize(("elevation_deg", "azimuth_deg"), [(10, 0), (25, 90), (60, -130)])
def test_the_brightest_place_is_where_the_sun_stands(elevation_deg: float, azimuth_deg: float) -> None:
    weather = WeatherConfig(sun_elevation_deg=elevation_deg, sun_azimuth_deg=azimuth_deg)
    sky = sky_colors(RAYS, daylight_of(weather), np.full_like(CLOUDS, -1.0)) @ LUMA
    brightest = RAYS.reshape(-1, 3)[np.argmax(sky)]
    assert brightest @ daylight_of(weather).toward_sun > np.cos(np.radians(2.0))


def test_clouds_hide_the_sun_and_level_the_sky() -> None:
    above = RAYS[..., 2] > 0.1
    spread = [grey_sky(overcast=severity)[above].std() for severity in (0, 2, 5)]
    assert spread[0] > spread[1] > spread[2]
    assert daylight_of(WeatherConfig(overcast=5)).sun == 0


def test_dusk_glows_where_the_sun_went_down() -> None:
    sky = grey_sky(dusk=3, sun_azimuth_deg=0)
    low = (RAYS[..., 2] > 0.02) & (RAYS[..., 2] < 0.1)
    west, east = low & (RAYS[..., 0] > 0.9), low & (RAYS[..., 0] < -0.9)
    assert sky[west].mean() > 1.5 * sky[east].mean()


def test_a_town_glows_most_near_the_horizon() -> None:
    glow = night_glow(np.array([[[1.0, 0.0, 0.02]], [[0.0, 0.0, 1.0]]]), CLOUDS)[:, 0]
    assert glow[0] > 2 * glow[1] > 0


def test_each_street_has_its_own_clouds_and_the_same_ones_again() -> None:
    def sky(seed: int) -> bytes:
        spec = mujoco.MjSpec()
        write_sky(spec, daylight_of(WeatherConfig()), 0.0, False, np.random.default_rng(seed))
        return bytes(spec.textures[0].data)

    assert sky(1) == sky(1)
    assert sky(1) != sky(2)
