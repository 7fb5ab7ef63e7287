"""Wet ground mirrors the same towards the same ray, whatever picture the ray is part of."""

import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.atmosphere import Atmosphere
from sim.light.instant import Instant
from sim.light.mirror import Mirror, wider
from sim.light.surfaces import Floats
from sim.light.surroundings import Surroundings
from sim.light.weather import WeatherConfig
from sim.rendering.view import FAR_M, Picture, View

WALL_M, TALL_M = 6.0, 9.0
PINHOLE = Camera("pinhole", (241, 241), (120.0, 120.0), (120.0, 120.0))  # 90 deg each way
AHEAD = SE3(np.array([[0.0, 0, 1], [-1, 0, 0], [0, -1, 0]]), np.array([0.0, 0.0, 1.5]))  # looks along x
DOWN = SE3(np.array([[0.0, -1, 0], [-1, 0, 0], [0, 0, -1]]), AHEAD.translation)
PARKED = Instant(3.0, SE3(np.eye(3), np.zeros(3)), np.zeros(3))
AIR = Atmosphere(WeatherConfig(rain=5.0), Surroundings(), {"front": PINHOLE}, 5)


def picture(view: View) -> Picture:
    """Return a grey road before a wall of bright and dark bands, under a black sky, ray by ray."""
    width, height = view.pinhole.size_px
    columns, rows = np.meshgrid(np.arange(float(width)), np.arange(float(height)))
    rays_cam = view.pinhole.unproject(np.column_stack([columns.ravel(), rows.ravel()]))
    x, y, z = (rays_cam / rays_cam[:, 2:] @ view.world_from_cam.rotation.T).T
    eye_z = view.world_from_cam.translation[2]
    with np.errstate(divide="ignore"):
        road, wall = np.where(z < 0, eye_z / -z, np.inf), np.where(x > 0, WALL_M / x, np.inf)
        wall[eye_z + np.minimum(wall, FAR_M) * z > TALL_M] = np.inf
    depth_m = np.minimum(np.minimum(road, wall), FAR_M)
    height_m = eye_z + depth_m * z
    bands = 130 + 90 * np.sin(1.5 * height_m) * np.cos(0.8 * depth_m * y)
    level = np.select([depth_m == FAR_M, wall < road], [0.0, bands], 60.0)
    rgb = np.repeat(level.astype(np.uint8).reshape(height, width, 1), 3, axis=2)
    return Picture(rgb, depth_m.reshape(height, width).astype(np.float32))


def mirror(*views: View) -> Mirror:
    around = [wider(view) for view in views]
    return AIR.mirror([picture(view) for view in around], around, PARKED)


def lit(view: View, seen: Mirror | None) -> Floats:
    return AIR.light(picture(view), view, PARKED, seen)


def apart(first: Floats, second: Floats) -> float:
    """How far apart two pictures are but for a few falling drops, whose ends a picture's border cuts off."""
    return float(np.quantile(np.abs(first - second), 0.97))


def test_a_strip_of_rows_mirrors_what_the_whole_picture_does() -> None:
    whole = View(PINHOLE, AHEAD)
    strip = View(Camera("pinhole", (241, 40), PINHOLE.focal_px, (120.0, -50.0)), AHEAD)  # rows 170 to 209
    expected = lit(whole, mirror(whole))[170:210]
    assert apart(expected, lit(whole, None)[170:210]) > 2
    assert apart(expected, lit(strip, mirror(whole))) < 0.5
    assert apart(expected, lit(strip, mirror(strip))) > 1.5  # for lack of the wall


def test_what_one_face_of_a_wide_lens_mirrors_goes_on_in_the_next() -> None:
    ahead, down = View(PINHOLE, AHEAD), View(PINHOLE, DOWN)
    both = mirror(ahead, down)
    assert apart(lit(ahead, None)[-1], lit(ahead, both)[-1]) > 0.5
    assert apart(lit(ahead, both)[-1], lit(down, both)[0]) < 0.2
    assert apart(lit(ahead, both)[-1], lit(down, mirror(down))[0]) > 0.5


def test_a_mirror_holds_for_an_eye_a_little_further_on() -> None:
    whole = View(PINHOLE, AHEAD)
    nearer = View(PINHOLE, SE3(AHEAD.rotation, AHEAD.translation + np.array([0.3, 0.0, 0.0])))
    assert apart(lit(nearer, mirror(whole)), lit(nearer, mirror(nearer))) < 0.6


def test_dry_ground_asks_for_no_pictures() -> None:
    dry = Atmosphere(WeatherConfig(fog=3.0), Surroundings(), {"front": PINHOLE}, 5)
    assert dry.around({"front": View(PINHOLE, AHEAD)}) == {}
    assert set(AIR.around({"front": View(PINHOLE, AHEAD)})) == {"front"}
