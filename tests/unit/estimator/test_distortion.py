"""Where distortion polynomials turn back, and their inverses up to there."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.distortion import (
    distort_brown_conrady,
    fold_radius,
    undistort_brown_conrady,
    within_fold_brown_conrady,
)
from estimator.distortion_angle import distorted_angle, fold_angle, undistorted_angle

BARREL = np.array([-0.35, 0.05, 0.0, 0.0, 0.0])


def test_without_distortion_nothing_turns_back() -> None:
    assert fold_radius(np.zeros(5)) == np.inf
    assert fold_angle(np.zeros(4)) == np.pi


def test_the_fold_is_where_the_slope_vanishes() -> None:
    radius = fold_radius(BARREL)
    near = np.array([[radius - 1e-6, 0.0], [radius, 0.0], [radius + 1e-6, 0.0]])
    _, jacobian = distort_brown_conrady(near, BARREL)
    slopes = jacobian[:, 0, 0]
    assert slopes[0] > 0 > slopes[2]
    assert abs(slopes[1]) < 1e-12


def test_the_first_of_two_turns_counts() -> None:
    turns_twice = np.array([-0.5, 0.08, 0.0, 0.0, 0.0])
    beyond = np.array([[3.0, 0.0]])
    _, jacobian = distort_brown_conrady(beyond, turns_twice)
    assert fold_radius(turns_twice) < 1.0 and np.linalg.det(jacobian)[0] > 0
    assert not within_fold_brown_conrady(beyond, jacobian, turns_twice).any()


def test_beyond_reach_there_is_no_inverse() -> None:
    reach = distort_brown_conrady(np.array([[fold_radius(BARREL), 0.0]]), BARREL)[0][0, 0]
    plane = undistort_brown_conrady(np.array([[0.999 * reach, 0.0], [1.001 * reach, 0.0]]), BARREL)
    assert np.isfinite(plane[0]).all()
    assert np.isnan(plane[1]).all()


def test_a_fisheye_s_inverse_ends_at_its_fold() -> None:
    coefficients = np.array([-0.1, 0.0, 0.0, 0.0])
    top = fold_angle(coefficients)
    reach = distorted_angle(np.array([top]), coefficients)[0][0]
    theta = undistorted_angle(np.array([0.0, 0.9 * reach, 1.01 * reach]), coefficients)
    assert theta[0] == 0.0
    assert 0.0 < theta[1] < top
    assert np.isnan(theta[2])


@pytest.mark.parametrize("coefficients", [BARREL, np.array([0.4, 0.1, 0.002, -0.001, 0.0])])
def test_far_corners_are_inverted(coefficients: np.ndarray) -> None:
    plane = np.array([[0.9, 0.6], [-0.8, 0.7], [0.0, 0.0]])
    distorted, _ = distort_brown_conrady(plane, coefficients)
    np.testing.assert_allclose(undistort_brown_conrady(distorted, coefficients), plane, atol=1e-11)


@pytest.mark.parametrize("tiny", [5e-324, -5e-324, 1e-300, -1e-12])
def test_vanishing_coefficients_do_no_harm(tiny: float) -> None:
    coefficients = np.array([-0.3, 0.1, 0.0, 0.0, tiny])
    plane = np.array([[0.5, 0.4], [30.0, 10.0]])
    distorted, _ = distort_brown_conrady(plane, coefficients)
    np.testing.assert_allclose(undistort_brown_conrady(distorted, coefficients), plane, rtol=1e-9)
    assert fold_angle(np.array([0.0, 0.0, 0.0, tiny])) == np.pi
