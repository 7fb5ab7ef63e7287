"""SE3 as a value, and its agreement with gtsam."""

from __future__ import annotations

import gtsam
import numpy as np
import pytest

from estimator.se3 import SE3, skew

TANGENT = np.array([0.3, -0.2, 0.5, 1.0, -2.0, 0.7])


def to_gtsam(pose: SE3) -> gtsam.Pose3:
    return gtsam.Pose3(gtsam.Rot3(pose.rotation), pose.translation)


def test_exp_and_log_are_gtsam_s() -> None:
    pose = gtsam.Pose3.Expmap(TANGENT)
    np.testing.assert_allclose(SE3.exp(TANGENT).matrix, pose.matrix(), atol=1e-12)
    np.testing.assert_allclose(SE3.exp(TANGENT).log(), gtsam.Pose3.Logmap(pose), atol=1e-12)


def test_the_adjoint_is_gtsam_s() -> None:
    pose = SE3.exp(TANGENT)
    np.testing.assert_allclose(pose.adjoint(), to_gtsam(pose).AdjointMap(), atol=1e-12)


def test_the_perturbation_is_gtsam_s() -> None:
    pose, step = SE3.exp(TANGENT), np.array([0.01, 0.02, -0.03, 0.1, -0.2, 0.3])
    moved = to_gtsam(pose).compose(gtsam.Pose3.Expmap(step))
    np.testing.assert_allclose(pose.retract(step).matrix, moved.matrix(), atol=1e-12)


def test_b_is_moved_to_a() -> None:
    a_from_b = SE3.from_quaternion_xyzw(
        np.array([0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5)]), np.array([1.0, 2.0, 3.0])
    )
    np.testing.assert_allclose(a_from_b.apply(np.array([[1.0, 0.0, 0.0]])), [[1.0, 3.0, 3.0]], atol=1e-12)


def test_small_angles_keep_their_digits() -> None:
    for angle_rad in (1e-12, 1e-8, 0.9e-5, 1.1e-5, 1e-4):
        tangent = np.array([0.0, 0.0, angle_rad, 1.0, 1.0, 1.0])
        np.testing.assert_allclose(SE3.exp(tangent).log(), tangent, rtol=1e-12, atol=1e-16)


def test_half_a_turn_survives() -> None:
    tangent = np.array([0.0, np.pi - 1e-9, 0.0, 1.0, 2.0, 3.0])
    np.testing.assert_allclose(SE3.exp(tangent).log(), tangent, atol=1e-7)


def test_quaternions_are_unit_with_a_positive_w() -> None:
    pose = SE3.from_quaternion_xyzw(np.array([0.2, 0.4, -0.4, -0.8]) * 3, np.zeros(3))
    np.testing.assert_allclose(pose.quaternion_xyzw, [-0.2, -0.4, 0.4, 0.8], atol=1e-12)


def test_values_cannot_be_changed() -> None:
    with pytest.raises(ValueError, match="read-only"):
        SE3().translation[0] = 1.0


def test_later_changes_of_the_input_do_not_reach_the_pose() -> None:
    translation = np.zeros(3)
    pose = SE3(np.eye(3), translation)
    translation[0] = 1.0
    assert pose.translation[0] == 0.0


def test_wrong_shapes_are_refused() -> None:
    with pytest.raises(ValueError, match="needs"):
        SE3(np.eye(4), np.zeros(3))


def test_skew_is_the_cross_product() -> None:
    a, b = np.array([1.0, 2.0, 3.0]), np.array([-4.0, 5.0, 0.5])
    np.testing.assert_allclose(skew(a) @ b, np.cross(a, b))
