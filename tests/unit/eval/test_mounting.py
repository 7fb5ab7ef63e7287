"""How a camera's mounting is put in words."""

import numpy as np
import pytest

from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from eval.mounting import car_rows, is_left_of, roll_pitch_yaw_deg, view_fan_ego
from tests.unit.eval.tiny_run import CAMERA, looking


def test_a_camera_that_looks_ahead_has_no_angles():
    assert roll_pitch_yaw_deg(looking(0, 1, 0), looking(0, 1, 0)) == pytest.approx((0, 0, 0), abs=1e-9)


def test_yaw_is_positive_to_the_left_and_pitch_positive_downwards():
    left = looking(30, 0, 0)
    assert roll_pitch_yaw_deg(left, left) == pytest.approx((0, 0, 30))
    down = looking(0, 0, 0) @ SE3.exp(
        np.array([-np.radians(10), 0, 0, 0, 0, 0])
    )  # about the camera's x, right
    assert down.rotation[2, 2] < 0  # its view sinks
    assert roll_pitch_yaw_deg(down, down) == pytest.approx((0, 10, 0))


def test_angles_of_nearly_equal_poses_are_nearly_equal():
    assert roll_pitch_yaw_deg(looking(-179.9, 0, 0), looking(179.9, 0, 0))[2] == pytest.approx(180.1)


def test_the_rows_follow_the_car_whatever_the_cameras_are_called():
    places = {"g": (180, -1, 0), "b": (1, 2, 0.1), "a": (62, 1, 0.9), "c": (3, 2, -0.25), "d": (-60, 1, -0.9)}
    places |= {"e": (150, 0, 0.9), "f": (-152, 0, -0.9)}
    rig = Rig("b", {name: MountedCamera(CAMERA, looking(*place)) for name, place in places.items()})
    assert car_rows(rig) == (["a", "b", "c", "d"], ["e", "g", "f"])


def test_the_fan_opens_as_wide_as_the_view():
    apex, *arc = view_fan_ego(CAMERA, looking(0, 2, 0))
    assert apex == pytest.approx([2, 0])
    half_deg = np.degrees(np.arctan(32 / 40))
    assert np.degrees(np.arctan2(arc[0][1], arc[0][0] - 2)) == pytest.approx(half_deg)


def test_images_lie_side_by_side_as_the_views_do():
    front, left, right = looking(0, 2, 0.1), looking(60, 1, 0.9), looking(-60, 1, -0.9)
    assert is_left_of(left, front) and is_left_of(front, right)
    assert not is_left_of(front, left) and not is_left_of(right, front)
    assert is_left_of(front, looking(2, 2, -0.25))  # beside it and nearly parallel
    assert is_left_of(
        looking(180, -2, 0), looking(150, 0.6, 0.9)
    )  # looking back, the car's left is to the right
