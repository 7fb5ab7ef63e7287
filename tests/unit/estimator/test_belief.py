"""The belief about the extrinsics: its prior, its blocks, the shared scale."""

from __future__ import annotations

import numpy as np

from estimator.belief import Belief
from tests.mounts import left_side_rig, shaken

RIG = left_side_rig()
NOMINAL = Belief.nominal(RIG)


def test_the_nominal_sigmas_are_the_norms_of_the_prior() -> None:
    np.testing.assert_allclose(np.diag(NOMINAL.camera_covariance("left_rear"))[0], np.deg2rad(2.0) ** 2 / 3)
    np.testing.assert_allclose(NOMINAL.rotation_sigma_rad("left_front"), np.deg2rad(2.0))
    np.testing.assert_allclose(NOMINAL.translation_sigma_m("left_front"), 0.060)


def test_nothing_is_to_be_learned_of_the_reference() -> None:
    assert NOMINAL.covariance.shape == (12, 12)
    assert not NOMINAL.camera_covariance("front").any()


def test_blocks_are_in_the_order_of_the_rig() -> None:
    belief = Belief(RIG, np.diag(np.arange(1.0, 13.0)))
    assert np.diag(belief.camera_covariance("left_front")).tolist() == [1, 2, 3, 4, 5, 6]
    assert np.diag(belief.camera_covariance("left_rear")).tolist() == [7, 8, 9, 10, 11, 12]


def test_an_error_of_scale_grows_with_the_distance_from_the_reference() -> None:
    stated = Belief(RIG, np.zeros((12, 12))).with_scale_sigma(0.01)
    front = RIG["front"].ego_from_cam.translation
    for name in RIG.estimated_names:
        distance_m = np.linalg.norm(RIG[name].ego_from_cam.translation - front)
        np.testing.assert_allclose(stated.translation_sigma_m(name), 0.01 * distance_m)
        assert stated.rotation_sigma_rad(name) == 0


def test_an_error_of_scale_moves_a_camera_along_the_line_to_the_reference() -> None:
    covariance = Belief(RIG, np.zeros((12, 12))).with_scale_sigma(0.01).camera_covariance("left_rear")
    pose = RIG["left_rear"].ego_from_cam
    line = pose.translation - RIG["front"].ego_from_cam.translation
    in_ego = pose.rotation @ covariance[3:, 3:] @ pose.rotation.T
    np.testing.assert_allclose(in_ego, 1e-4 * np.outer(line, line), atol=1e-15)


def test_the_size_of_the_rig_is_as_sure_as_its_cameras_are() -> None:
    sigma_m, front = 0.03, RIG["front"].ego_from_cam.translation
    lengths_m = [np.linalg.norm(RIG[name].ego_from_cam.translation - front) for name in RIG.estimated_names]
    belief = Belief(RIG, sigma_m**2 * np.eye(12))
    np.testing.assert_allclose(belief.scale_sigma(), sigma_m / np.linalg.norm(lengths_m))


def test_an_error_of_scale_that_all_share_makes_the_size_that_much_less_sure() -> None:
    belief = Belief(RIG, 1e-8 * np.eye(12)).with_scale_sigma(0.004)
    np.testing.assert_allclose(belief.scale_sigma(), 0.004, rtol=1e-3)


def test_cameras_are_known_by_their_rotation_and_the_reference_always() -> None:
    sigmas = np.repeat([0.001, 1.0, 0.01, 1.0], 3)
    assert Belief(RIG, np.diag(sigmas**2)).known_within(0.005) == {"front", "left_front"}
    assert Belief(RIG, np.diag(sigmas**2)).known_within(0.02) == {"front", "left_front", "left_rear"}


def test_a_forgotten_camera_keeps_its_place_and_nothing_else() -> None:
    belief = Belief(RIG, 1e-4 * np.ones((12, 12)) + 1e-3 * np.eye(12))
    wide = np.diag(np.arange(1.0, 7.0))
    forgetful = belief.forgetting(["left_rear"], wide)
    np.testing.assert_array_equal(forgetful.camera_covariance("left_rear"), wide)
    np.testing.assert_array_equal(
        forgetful.camera_covariance("left_front"), belief.camera_covariance("left_front")
    )
    assert not forgetful.covariance[:6, 6:].any() and not forgetful.covariance[6:, :6].any()
    assert forgetful.rig is belief.rig


def test_a_camera_can_be_taken_over_from_another_belief() -> None:
    other = Belief(shaken(RIG, 1.0, 20.0), 7e-4 * np.eye(12))
    mixed = NOMINAL.with_cameras_of(other, ["left_front"])
    assert mixed.rig["left_front"].ego_from_cam is other.rig["left_front"].ego_from_cam
    assert mixed.rig["left_rear"].ego_from_cam is RIG["left_rear"].ego_from_cam
    np.testing.assert_array_equal(mixed.camera_covariance("left_front"), 7e-4 * np.eye(6))
