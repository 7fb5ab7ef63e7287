"""When a bundle becomes a keyframe."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.keyframe import Keyframe
from estimator.odometry import Odometry, OdometryConfig
from estimator.se3 import SE3
from estimator.window_pace import PaceConfig, is_keyframe
from tests.mounts import left_side_rig

CONFIG = PaceConfig(spacing_m=1.0, turn_rad=0.2)
LAST = Keyframe(0, {}, SE3(), {})


def odometry_after(moved_m: float, turned_rad: float = 0.0, step_m: float = 0.0) -> Odometry:
    odometry = Odometry(left_side_rig()["front"], OdometryConfig())
    pose = SE3.exp(np.array([0.0, 0.0, turned_rad, moved_m, 0.0, 0.0]))
    odometry.correct(pose, 1.0)
    odometry._last_step = SE3(np.eye(3), np.array([step_m, 0.0, 0.0]))
    return odometry


def test_the_first_bundle_is_a_keyframe() -> None:
    assert is_keyframe([], odometry_after(0.0), CONFIG)


def test_a_standing_car_makes_none() -> None:
    assert not is_keyframe([LAST], odometry_after(0.0), CONFIG)


@pytest.mark.parametrize(("moved_m", "wanted"), [(0.70, False), (0.79, False), (0.81, True), (1.2, True)])
def test_the_bundle_nearest_to_the_spacing_is_taken(moved_m: float, wanted: bool) -> None:
    assert is_keyframe([LAST], odometry_after(moved_m, step_m=0.4), CONFIG) is wanted


@pytest.mark.parametrize(("turned_rad", "wanted"), [(0.19, False), (0.21, True), (-0.21, True)])
def test_a_turn_makes_one_sooner(turned_rad: float, wanted: bool) -> None:
    assert is_keyframe([LAST], odometry_after(0.1, turned_rad), CONFIG) is wanted
