"""Cameras that show the car where it was a moment ago."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.clocks import Clocks, body_twists
from estimator.se3 import SE3
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig

PATH = arc(0.5, 7)
STAMPS_NS = tuple(range(0, 700_000_000, 100_000_000))
SCENE = known_scene(left_side_rig(), PATH)


def test_a_steady_drive_has_one_velocity() -> None:
    twist = np.array([0.0, 0.0, 5 / 70, 5.0, 0.0, 0.0])
    np.testing.assert_allclose(body_twists(PATH, STAMPS_NS), np.tile(twist, (7, 1)), atol=1e-9)


def test_velocity_follows_a_steady_acceleration_up_to_the_ends() -> None:
    times_s = np.array([0.0, 0.1, 0.3, 0.4, 0.7])
    poses = [SE3(np.eye(3), np.array([t + t * t, 0.0, 0.0])) for t in times_s]
    speed = body_twists(poses, [round(t * 1e9) for t in times_s])[:, 3]
    np.testing.assert_allclose(speed, 1 + 2 * times_s, atol=1e-6)


def test_two_keyframes_give_one_velocity() -> None:
    assert body_twists(PATH[:2], STAMPS_NS[:2])[1, 3] == body_twists(PATH[:2], STAMPS_NS[:2])[0, 3] > 4.9


def test_a_camera_a_bundle_ahead_stands_where_it_stood_a_bundle_ago() -> None:
    late = replace(SCENE, clocks=Clocks(STAMPS_NS, (0.0, 0.1, 0.0)))
    np.testing.assert_allclose(late.camera_pose(1, 3).matrix, SCENE.camera_pose(1, 2).matrix, atol=1e-9)
    np.testing.assert_allclose(late.camera_pose(2, 3).matrix, SCENE.camera_pose(2, 3).matrix, atol=1e-12)


def test_sightings_of_a_late_camera_are_moved_to_where_they_belong() -> None:
    late = replace(SCENE, clocks=Clocks(STAMPS_NS, (0.0, 0.02, -0.01)))
    in_time = late.as_if_in_time(sightings(late))
    assert len(in_time) > 100
    assert np.nanmax(SCENE.residuals_px(in_time)) < 1e-6
