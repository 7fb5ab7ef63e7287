"""Fog and lit air, by distance along the ray; tunnels keep daylight out."""

import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.fog import extinction_per_m, headlight_haze, lamp_haze, transmission
from sim.light.lamps import LightSource
from sim.light.surfaces import Surfaces
from sim.light.tunnels import CoveredRoad, TunnelShade
from sim.light.vehicles import driven_vehicle
from sim.light.weather import WeatherConfig
from sim.rendering.view import View

PINHOLE = Camera("pinhole", (61, 41), (30.0, 30.0), (30.0, 20.0))
AHEAD = SE3(np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]]), np.array([0.0, 0.0, 1.5]))  # looks along x


def facing_wall(depth_m: float) -> Surfaces:
    return Surfaces(View(PINHOLE, AHEAD), np.full((41, 61), depth_m, np.float32))


def test_light_is_lost_by_distance_along_the_ray_not_by_depth() -> None:
    arrives = transmission(facing_wall(20.0), 0.05)
    assert np.isclose(arrives[20, 30], np.exp(-1.0), rtol=1e-5)
    assert np.isclose(arrives[20, 60], np.exp(-np.sqrt(2.0)), rtol=1e-5)


def test_five_percent_of_contrast_are_left_at_the_range_of_the_fog() -> None:
    assert np.isclose(np.exp(-65.0 * extinction_per_m(WeatherConfig(fog=3))), 0.05, rtol=0.01)


def test_clear_air_takes_nothing() -> None:
    assert extinction_per_m(WeatherConfig()) == 0


def test_air_glows_around_a_lamp_and_not_where_a_wall_hides_it() -> None:
    lamp = LightSource((10.0, 0.0, 1.5), (-1.0, 0.0, 0.0), 2.0)
    beyond, before = lamp_haze([lamp], facing_wall(30.0), 0.05), lamp_haze([lamp], facing_wall(3.0), 0.05)
    assert beyond[7, 10] > 5 * beyond[0, 0] > 0
    assert beyond[7, 10] > 5 * before[7, 10]


def test_beams_show_in_fog_from_behind_the_lamps_only() -> None:
    car = driven_vehicle(SE3(np.eye(3), np.array([-3.0, 0.0, 0.0])))
    facing_back = driven_vehicle(SE3(np.diag([-1.0, -1, 1]), np.zeros(3)))
    ahead = headlight_haze(car, facing_wall(40.0), 0.05)
    assert ahead.max() > 1.0
    assert headlight_haze(facing_back, facing_wall(40.0), 0.05).max() < 0.05 * ahead.max()


def test_daylight_fades_from_portal_to_middle_and_is_whole_outside() -> None:
    outline = np.array([[0.0, -4.0], [80.0, -4.0], [80.0, 4.0], [0.0, 4.0]])
    shade = TunnelShade([CoveredRoad(outline, np.array([[0.0, 0.0], [80.0, 0.0]]), 5.0)], 5.0)
    x = np.array([-20.0, 1.0, 10.0, 40.0, 40.0], np.float32)
    z = np.array([0.0, 0.0, 0.0, 0.0, 7.0], np.float32)
    outside, mouth, inside, middle, on_top = shade.daylight(np.stack([x, 0 * x, z])[:, None])[0]
    assert outside == on_top == 1
    assert 1 > mouth > inside > middle > 0
