"""Rain, drops on glass, flare, channels, and the atmosphere that joins them: same answers in any order."""

import mujoco
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.atmosphere import Atmosphere, grey, needs_channels
from sim.light.channels import split, write_channels
from sim.light.daylight import direction
from sim.light.flare import SUN_LEVEL, Flare, find_sun, mark_sun
from sim.light.instant import Instant
from sim.light.lamps import LightSource
from sim.light.rain import Rain
from sim.light.sprites import add_lamps
from sim.light.surroundings import Surroundings
from sim.light.tunnels import CoveredRoad, TunnelShade
from sim.light.vehicles import Vehicle
from sim.light.weather import WeatherConfig
from sim.light.wet_lens import WetLens
from sim.rendering.view import FAR_M, Picture, View

PINHOLE = Camera("pinhole", (160, 100), (115.0, 115.0), (79.5, 49.5))
AHEAD = SE3(np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]]), np.array([0.0, 0.0, 1.5]))  # looks along x
VIEW = View(PINHOLE, AHEAD)
PARKED = Instant(3.0, SE3(np.eye(3), np.zeros(3)), np.zeros(3))
FAR_AWAY = np.full((100, 160), 100.0, np.float32)
SKY = np.full((100, 160), FAR_M, np.float32)


def picture(depth_m: np.ndarray = FAR_AWAY) -> Picture:
    rgb = np.random.default_rng(0).integers(0, 255, (100, 160, 3)).astype(np.uint8)
    return Picture(rgb, depth_m)


def atmosphere(surroundings: Surroundings | None = None, **weather: float) -> Atmosphere:
    return Atmosphere(WeatherConfig(**weather), surroundings or Surroundings(), {"front": PINHOLE}, 5)


def streaks(rain: Rain, depth_m: np.ndarray, time_s: float, velocity_mps: np.ndarray) -> np.ndarray:
    light = np.zeros((100, 160), np.float32)
    rain.add_streaks(light, VIEW, depth_m, velocity_mps, time_s, 200.0)
    return light


def test_a_plain_day_is_the_picture_s_grey_and_wants_no_depth() -> None:
    plain = atmosphere()
    shown = picture()
    assert not plain.needs_depth
    assert np.array_equal(plain.light(Picture(shown.rgb), VIEW, PARKED), grey(shown.rgb))
    light = np.ones((100, 160), np.float32)
    assert plain.cover(light, "front", 1.0) is light


@pytest.mark.parametrize("effect", ["fog", "rain", "wet_lens", "flare", "night", "dusk"])
def test_the_same_instant_gives_the_same_light_whatever_was_asked_before(effect: str) -> None:
    once, twice = atmosphere(**{effect: 3.0}), atmosphere(**{effect: 3.0})
    later = Instant(4.0, PARKED.world_from_ego, np.ones(3))
    twice.cover(twice.light(picture(), VIEW, later), "front", 4.0)
    first, second = (one.cover(one.light(picture(), VIEW, PARKED), "front", 3.0) for one in (once, twice))
    assert np.array_equal(first, second)


def test_a_strip_of_rows_meets_the_same_fog_as_the_whole_picture() -> None:
    strip = View(Camera("pinhole", (160, 30), (115.0, 115.0), (79.5, 9.5)), AHEAD)
    air, shown = atmosphere(fog=4.0), picture()
    part = Picture(shown.rgb[40:70], FAR_AWAY[40:70])
    assert np.allclose(air.light(part, strip, PARKED), air.light(shown, VIEW, PARKED)[40:70], atol=1e-3)


def test_only_dusk_night_and_dark_tunnels_need_channels() -> None:
    road = CoveredRoad(np.array([[0.0, 0], [9, 0], [9, 9]]), np.zeros((1, 2)), 5.0)
    tunnels = Surroundings(tunnels=(road,))
    assert needs_channels(WeatherConfig(night=1), Surroundings())
    assert needs_channels(WeatherConfig(tunnel=1), tunnels)
    assert not needs_channels(WeatherConfig(tunnel=1), Surroundings())
    assert not needs_channels(WeatherConfig(fog=5, rain=5, flare=5, overcast=5), tunnels)


def test_a_picture_in_channels_comes_apart_again() -> None:
    spec = mujoco.MjSpec()
    image = np.full((4, 4, 3), (200, 100, 50), np.uint8)
    flat = mujoco.mjtTexture.mjTEXTURE_2D
    texture = spec.add_texture(name="t", type=flat, width=4, height=4, nchannel=3)
    texture.data = image.tobytes()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[1, 0, 0], rgba=[0.2, 0.4, 0.6, 1])
    write_channels(spec, {"t": np.full((4, 4), 30, np.uint8)})
    channels = split(np.frombuffer(texture.data, np.uint8).reshape(4, 4, 3))
    luma = 0.299 * 200 + 0.587 * 100 + 0.114 * 50
    assert np.allclose(channels.day, luma, atol=0.6)
    assert np.allclose(channels.albedo, luma, atol=0.6)
    assert np.allclose(channels.glow, 30, atol=0.5)
    assert spec.geoms[0].rgba[1] == 0


def test_drops_behind_a_wall_are_not_seen() -> None:
    rain = Rain(5.0, np.random.default_rng(1))
    assert streaks(rain, FAR_AWAY, 1.0, np.zeros(3)).max() > 10
    assert streaks(rain, np.full_like(FAR_AWAY, 0.4), 1.0, np.zeros(3)).max() == 0


def test_no_rain_falls_in_a_tunnel() -> None:
    outline = np.array([[-50.0, -8], [50, -8], [50, 8], [-50, 8]])
    road = CoveredRoad(outline, np.array([[-50.0, 0], [50, 0]]), 5.0)
    sheltered, open_sky = (
        Rain(5.0, np.random.default_rng(0), TunnelShade(tunnels, 3.0)) for tunnels in ((road,), ())
    )
    bare = Rain(5.0, np.random.default_rng(0))
    assert streaks(sheltered, FAR_AWAY, 3.0, np.zeros(3)).max() == 0
    assert np.array_equal(
        streaks(open_sky, FAR_AWAY, 3.0, np.zeros(3)), streaks(bare, FAR_AWAY, 3.0, np.zeros(3))
    )


def test_driving_lengthens_streaks_beside_the_car() -> None:
    left = View(PINHOLE, SE3(np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]), np.array([0.0, 0.0, 1.5])))
    rain = Rain(3.0, np.random.default_rng(1))
    wet = []
    for speed_mps in (0.0, 20.0):
        light = np.zeros((100, 160), np.float32)
        rain.add_streaks(light, left, FAR_AWAY, np.array([speed_mps, 0, 0]), 1.0, 200.0)
        wet.append((light > 0).sum())
    assert wet[1] > 1.5 * wet[0]


def test_drops_on_glass_move_little_in_a_moment_and_differ_by_camera() -> None:
    light = picture().rgb[..., 0].astype(np.float32)
    front, rear = WetLens(4.0, "front", 5), WetLens(4.0, "rear", 5)
    now, soon, much_later = (front.over(light, time_s) for time_s in (2.0, 2.001, 12.0))
    assert np.abs(now - soon).mean() < 0.05 * np.abs(now - much_later).mean()
    assert not np.array_equal(now, rear.over(light, 2.0))


def test_a_wetter_lens_hides_more() -> None:
    light = picture().rgb[..., 0].astype(np.float32)
    changed = [(WetLens(s, "front", 5).over(light, 2.0) != light).mean() for s in (0.0, 1.0, 3.0, 5.0)]
    assert changed[0] == 0
    assert np.all(np.diff(changed) > 0)


def test_the_sun_is_marked_and_found_where_it_stands() -> None:
    light = np.full((100, 160), 200.0, np.float32)
    toward_sun = direction(8.0, 5.0)
    mark_sun(light, VIEW, SKY, toward_sun)
    found = find_sun(light, PINHOLE)
    assert found is not None
    expected_px = PINHOLE.project((AHEAD.rotation.T @ toward_sun)[None])[0]
    assert np.allclose(found[0], expected_px, atol=0.5)
    assert found[1] > 0.5
    assert light.max() <= SUN_LEVEL


def test_a_hidden_sun_makes_no_flare() -> None:
    light = np.full((100, 160), 200.0, np.float32)
    mark_sun(light, VIEW, FAR_AWAY, direction(8.0, 5.0))
    assert Flare(5.0, 1.0).over(light, PINHOLE) is light


def test_no_sun_is_seen_once_it_has_set() -> None:
    dark = Picture(np.zeros((100, 160, 3), np.uint8), SKY)
    air = atmosphere(flare=3.0, night=2.0, sun_elevation_deg=8.0, sun_azimuth_deg=5.0)
    assert air.cover(air.light(dark, VIEW, PARKED), "front", 3.0).max() < 10


def test_clouds_dim_the_disc_of_the_sun() -> None:
    def disc(sun: float) -> float:
        light = np.full((100, 160), 100.0, np.float32)
        mark_sun(light, VIEW, SKY, direction(8.0, 5.0))
        return float(Flare(1.0, sun).over(light, PINHOLE).max())

    assert disc(0.07) < 300 < disc(1.0)


def test_the_worse_the_lens_the_more_the_sun_spills() -> None:
    light = np.full((100, 160), 100.0, np.float32)
    mark_sun(light, VIEW, SKY, direction(8.0, 5.0))
    veils = [Flare(severity, 1.0).over(light, PINHOLE).mean() for severity in range(6)]
    assert np.all(np.diff(veils) > 0)


def test_a_lamp_shows_unless_something_stands_before_it() -> None:
    lamp = LightSource((20.0, 0.0, 4.0), (0.0, 0.0, -1.0), 1.0)
    shown, hidden = np.zeros((100, 160), np.float32), np.zeros((100, 160), np.float32)
    add_lamps(shown, [lamp], VIEW, FAR_AWAY)
    add_lamps(hidden, [lamp], VIEW, np.full_like(FAR_AWAY, 5.0))
    assert shown.max() > 20
    assert hidden.max() == 0


def test_other_cars_light_the_night_and_leave_the_day_as_it_is() -> None:
    turned = SE3(np.diag([-1.0, -1.0, 1.0]), np.array([20.0, 2.0, 0.0]))
    oncoming = Vehicle(turned, (-2.2, 2.2), 0.9, (2.1, 0.66, 0.7), (-2.2, 0.66, 0.8))
    meeting = Instant(3.0, PARKED.world_from_ego, np.zeros(3), (oncoming,))
    shown = picture(np.full((100, 160), 30.0, np.float32))
    for effect in ("night", "dusk"):
        air = atmosphere(**{effect: 4.0})
        alone, met = (air.light(shown, VIEW, instant) for instant in (PARKED, meeting))
        assert met.max() > alone.max() + 100
        assert (met < 0.9 * alone).any()  # in its shade
    by_day = atmosphere(fog=2.0)
    assert np.array_equal(by_day.light(shown, VIEW, meeting), by_day.light(shown, VIEW, PARKED))


def test_a_dusk_without_lamps_is_lit_all_the_same() -> None:
    assert atmosphere(dusk=1.0).light(picture(), VIEW, PARKED).mean() > 1


def test_night_leaves_what_no_lamp_reaches_nearly_black() -> None:
    shown = picture()
    shown.rgb[..., 1] = 0
    dark = atmosphere(night=3.0).light(shown, VIEW, PARKED)
    assert 0 < dark.mean() < 0.1 * shown.rgb[..., 0].mean()
