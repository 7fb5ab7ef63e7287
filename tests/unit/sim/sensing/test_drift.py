"""How fast pictures drift, from depth and motion: against points projected a moment later."""

from __future__ import annotations

import mujoco
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.rendering.view import FAR_M, View
from sim.sensing.body_boxes import BodyBoxes
from sim.sensing.drift import Drift
from sim.vehicle.cameras import world_from_cam

PINHOLE = Camera("pinhole", (64, 40), (50.0, 50.0), (31.5, 19.5))
CAM_FROM_FACE = SE3.exp(np.array([0.0, 0.3, 0.0, 0.0, 0.0, 0.0]))
DEPTH_M = 5.0
XML = """<mujoco><worldbody>
  <body name="car"><freejoint/><geom type="box" size="1 1 1" pos="0 0 -5"/>
    <camera name="eye" pos="0.2 0.1 0.3" xyaxes="0 -1 0 0 0 1"/></body>
  <body name="other" mocap="true"><geom type="box" size="0.6 0.6 0.6" contype="0"/></body>
</worldbody></mujoco>"""


class StraightStage:
    """A car that turns and drives, and another that crosses."""

    def __init__(self) -> None:
        self.model = mujoco.MjModel.from_xml_string(XML)
        self._data = mujoco.MjData(self.model)

    def at(self, time_s: float) -> mujoco.MjData:
        self._data.qpos[:] = [6 * time_s, 1 * time_s, 0, np.cos(0.2 * time_s), 0, 0, np.sin(0.2 * time_s)]
        middle = np.array([4.9, -1.2, 0.3])
        self._data.mocap_pos[0] = middle + np.array([1.0, 5.0, 0.5]) * time_s
        turn_rad = 0.8 * time_s
        self._data.mocap_quat[0] = [np.cos(turn_rad / 2), 0, 0, np.sin(turn_rad / 2)]
        mujoco.mj_kinematics(self.model, self._data)
        mujoco.mj_camlight(self.model, self._data)
        return self._data


def drift_of(stage: StraightStage, depth_m: Array) -> tuple[Array, View]:
    drift = Drift(stage, 0.0, ("eye",), BodyBoxes(stage.model))  # type: ignore[arg-type]
    view = View(PINHOLE, world_from_cam(stage.at(0.0), "eye") @ CAM_FROM_FACE)
    return drift.pixel_rates("eye", view, CAM_FROM_FACE, depth_m.astype(np.float32)), view


def pixels_and_points(view: View, depth_m: Array) -> tuple[Array, Array]:
    columns, rows = np.meshgrid(np.arange(64.0), np.arange(40.0))
    pixels = np.column_stack([columns.ravel(), rows.ravel()])
    rays = PINHOLE.unproject(pixels)
    return pixels, view.world_from_cam.apply(rays * (depth_m.ravel() / rays[:, 2])[:, None])


def expected_rates(stage: StraightStage, points: Array, body: str | None) -> Array:
    """Return (N, 2) px/s of world points that move with a body, by projecting them before and after."""
    step_s, seen = 1e-4, []
    now = stage.at(0.0).body(body or "world")
    points_body = (points - now.xpos) @ now.xmat.reshape(3, 3)
    for time_s in (-step_s, step_s):
        data = stage.at(time_s)
        there = data.body(body or "world")
        points_then = points_body @ there.xmat.reshape(3, 3).T + there.xpos
        view_from_world = (world_from_cam(data, "eye") @ CAM_FROM_FACE).inverse()
        seen.append(PINHOLE.project(view_from_world.apply(points_then)))
    return (seen[1] - seen[0]) / (2 * step_s)


def test_what_stands_drifts_by_the_cameras_motion() -> None:
    stage = StraightStage()
    depth_m = np.full((40, 64), 12.0)
    rates, view = drift_of(stage, depth_m)
    _, points = pixels_and_points(view, depth_m)
    assert np.allclose(rates.reshape(-1, 2), expected_rates(stage, points, None), atol=0.02)


def test_a_body_in_the_picture_drifts_by_its_own_motion_too() -> None:
    stage = StraightStage()
    depth_m = np.full((40, 64), DEPTH_M)
    rates, view = drift_of(stage, depth_m)
    _, points = pixels_and_points(view, depth_m)
    inside = (np.abs(points - [4.9, -1.2, 0.3]) < 0.6).all(1)
    assert 50 < inside.sum() < 1500
    assert np.allclose(
        rates.reshape(-1, 2)[inside], expected_rates(stage, points[inside], "other"), atol=0.02
    )
    outside = (np.abs(points - [4.9, -1.2, 0.3]) > 0.7).any(1)
    assert np.allclose(rates.reshape(-1, 2)[outside], expected_rates(stage, points[outside], None), atol=0.02)


def test_the_cars_own_body_stays_where_it_is() -> None:
    """Points in the car's own box, which lies below the camera."""
    stage = StraightStage()
    drift = Drift(stage, 0.0, ("eye",), BodyBoxes(stage.model))  # type: ignore[arg-type]
    cam_from_face = SE3.exp(np.array([-np.pi / 2, 0.0, 0.0, 0.0, 0.0, 0.0]))  # straight down
    view = View(PINHOLE, world_from_cam(stage.at(0.0), "eye") @ cam_from_face)
    assert view.world_from_cam.rotation[2, 2] == pytest.approx(-1)
    rates = drift.pixel_rates("eye", view, cam_from_face, np.full((40, 64), 5.0, np.float32))
    assert np.abs(rates[15:25, 25:38]).max() < 1e-2


def test_the_sky_does_not_care_how_far_the_car_drives() -> None:
    stage = StraightStage()
    rates, _ = drift_of(stage, np.full((40, 64), FAR_M))
    turning_px_s = 0.4 * 50
    assert np.abs(rates).max() < 2 * turning_px_s
