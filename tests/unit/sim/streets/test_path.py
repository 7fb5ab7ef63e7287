"""Paths: where they run, how smoothly, and the street coordinates on them."""

import numpy as np
import pytest

from sim.streets.path import STEP_M, bend_curvature, bend_length_m, path_from_curvature, path_through
from sim.streets.rounded import rounded_path


def bent():
    return path_from_curvature(0.0, bend_curvature(np.arange(0.0, 60.0, STEP_M), 10.0, np.deg2rad(-55), 20.0))


def circle(radius_m: float = 20.0):
    angles = np.linspace(0, 2 * np.pi, 2001)
    return path_through(radius_m * np.stack([np.cos(angles), np.sin(angles)], axis=1), closed=True)


def test_a_bend_turns_by_its_angle_over_its_length() -> None:
    end = 10.0 + bend_length_m(np.deg2rad(-55), 20.0)
    assert bent().heading_rad(9.9) == pytest.approx(0.0, abs=1e-9)
    assert np.rad2deg(bent().heading_rad(end + 0.2)) == pytest.approx(-55.0, abs=0.1)


def test_street_coordinates_keep_their_distance_from_the_path() -> None:
    s_m = np.linspace(0.0, 60.0, 200)
    apart = np.linalg.norm(bent().point_m(s_m, 5.0) - bent().point_m(s_m), axis=1)
    np.testing.assert_allclose(apart, 5.0, atol=1e-9)


def test_beyond_its_ends_an_open_path_goes_on_straight() -> None:
    beyond = bent().point_m(-np.array([0.0, 7.0]))
    np.testing.assert_allclose(beyond[0] - beyond[1], [7.0, 0.0], atol=1e-9)


def test_a_closed_path_goes_round_for_ever() -> None:
    path = circle()
    np.testing.assert_allclose(path.point_m(3.0 + 5 * path.length_m, 2.0), path.point_m(3.0, 2.0), atol=1e-9)
    np.testing.assert_allclose(path.curvature_1pm(np.linspace(0, 300, 50)), 1 / 20.0, rtol=0.05)


def test_projecting_a_point_gives_back_its_street_coordinates() -> None:
    for path in (bent(), circle()):
        s_d = np.column_stack([np.linspace(2.0, 55.0, 40), np.linspace(-4.0, 4.0, 40)])
        np.testing.assert_allclose(path.project(path.point_m(*s_d.T)), s_d, atol=0.02)


def test_the_path_beside_another_keeps_its_distance_and_may_run_against_it() -> None:
    back = bent().offset(3.0, backwards=True)
    np.testing.assert_allclose(bent().project(back.points_m)[:, 1], 3.0, atol=0.02)
    np.testing.assert_allclose(back.points_m[0], bent().point_m(bent().end_m, 3.0), atol=1e-6)


def test_rounded_corners_have_their_radius_and_leave_the_straights_alone() -> None:
    path = rounded_path(np.array([[0.0, 0.0], [40.0, 0.0], [40.0, -40.0]]), (0.0, 8.0, 0.0))
    s_m = np.linspace(1.0, path.end_m - 1.0, 500)
    curvature = path.curvature_1pm(s_m, 0.5)
    assert -1 / 7.5 < curvature.min() < -1 / 8.5
    np.testing.assert_allclose(path.point_m(20.0), [20.0, 0.0], atol=1e-6)
    assert np.abs(np.diff(curvature)).max() < 0.03  # the wheel is not jerked


def test_a_rounded_block_closes_smoothly() -> None:
    corners = np.array([[30.0, 0.0], [30.0, 40.0], [-30.0, 40.0], [-30.0, 0.0]])
    path = rounded_path(corners, (10.0,) * 4, closed=True)
    np.testing.assert_allclose(path.points_m[0], path.points_m[-1], atol=1e-9)
    np.testing.assert_allclose(path.points_m[0], 0.0, atol=1e-6)
    assert path.headings_rad[-1] - path.headings_rad[0] == pytest.approx(2 * np.pi, abs=1e-3)
