"""Light as it is rendered: the sky's sun is where shadows say, and the sky is no wall."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.daylight import direction
from sim.light.outdoors import write_outdoors
from sim.light.weather import WeatherConfig
from sim.rendering.classic import ClassicRenderer
from sim.rendering.quality import write_visual_settings
from sim.rendering.view import FAR_M, Picture, View
from sim.vehicle.car_physics import physics_spec

PINHOLE = Camera("pinhole", (320, 240), (400.0, 400.0), (159.5, 119.5))


def towards(ray_world: np.ndarray) -> SE3:
    """A camera 2 m up whose axis lies 4 deg below a direction."""
    right = np.cross(ray_world, [0.0, 0.0, 1.0])
    right /= np.linalg.norm(right)
    forward = ray_world - 0.07 * np.cross(right, ray_world)
    forward /= np.linalg.norm(forward)
    return SE3(np.column_stack([right, np.cross(forward, right), forward]), np.array([0.0, 0.0, 2.0]))


def rendered(weather: WeatherConfig, pose: SE3, in_channels: bool = False) -> Picture:
    spec = physics_spec()
    spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[60, 60, 1], rgba=[0.5, 0.4, 0.3, 1])
    write_outdoors(spec, weather, 3, {} if in_channels else None)
    write_visual_settings(spec, PINHOLE.size_px)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    with ClassicRenderer(model) as renderer:
        return renderer.render(data, {"view": View(PINHOLE, pose)}, depth=True)["view"]


@pytest.mark.parametrize(("elevation_deg", "azimuth_deg"), [(15.0, 0.0), (30.0, 100.0), (50.0, -140.0)])
def test_the_sun_stands_in_the_sky_where_its_light_comes_from(
    elevation_deg: float, azimuth_deg: float
) -> None:
    sun = direction(elevation_deg, azimuth_deg)
    pose = towards(sun)
    picture = rendered(WeatherConfig(sun_elevation_deg=elevation_deg, sun_azimuth_deg=azimuth_deg), pose)
    brightness = picture.rgb.min(axis=2).astype(float)
    rows, columns = np.nonzero(brightness >= brightness.max() - 2)
    expected_px = PINHOLE.project((pose.rotation.T @ sun)[None])[0]
    assert np.allclose([columns.mean(), rows.mean()], expected_px, atol=3.0)


def test_the_sky_lies_at_the_far_plane_and_the_ground_does_not() -> None:
    picture = rendered(WeatherConfig(), towards(direction(0.0, 20.0)))
    assert picture.depth_m is not None
    assert np.all(picture.depth_m[:80] == FAR_M)
    assert picture.depth_m[-1].max() < 30.0


def test_channels_hold_daylight_glow_and_albedo() -> None:
    picture = rendered(WeatherConfig(night=1.0), towards(direction(0.0, 20.0)), in_channels=True)
    ground = picture.rgb[-1].astype(float)
    grey = 255 * (0.299 * 0.5 + 0.587 * 0.4 + 0.114 * 0.3)
    assert np.allclose(ground[:, 2], grey, atol=1.5)
    assert ground[:, 1].max() == 0
    assert picture.rgb[0, :, 1].min() > 0  # the town's glow on the sky
