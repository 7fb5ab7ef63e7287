"""The line that is driven: even samples, curvature, nearest points, laps."""

from __future__ import annotations

import numpy as np
import pytest

from sim.vehicle.follower import Follower
from sim.vehicle.route import Route, backwards_from, route_along
from tests.drives import CAR, STRAIGHT, bend, ellipse


def test_points_are_evenly_spaced_and_keep_the_ends() -> None:
    route = route_along(np.array([[0.0, 0.0], [3.0, 0.0], [3.0, 4.04]]))
    steps_m = np.linalg.norm(np.diff(route.points_m, axis=0), axis=1)
    assert steps_m.max() < 0.11 and np.median(steps_m) == pytest.approx(route.step_m)
    np.testing.assert_allclose(route.points_m[[0, -1]], [[0.0, 0.0], [3.0, 4.04]])
    assert route.length_m == pytest.approx(7.04)


def test_an_open_route_goes_on_straight_at_both_ends() -> None:
    route = bend(10.0)
    np.testing.assert_allclose(route.point_m(-3.0), [-3.0, 0.0], atol=1e-9)
    end = route.point_m(route.length_m)
    np.testing.assert_allclose(route.point_m(route.length_m + 5.0), end + np.array([0.0, 5.0]), atol=1e-6)


def test_curvature_is_that_of_the_bend_and_zero_beside_it() -> None:
    route = bend(10.0)
    assert route.curvature_pm(28.0) == pytest.approx(0.1, rel=0.01)
    assert abs(float(route.curvature_pm(15.0))) < 1e-9
    assert abs(float(route.curvature_pm(-5.0))) < 1e-9


def test_a_lap_of_a_loop_leads_back_without_a_seam() -> None:
    route = ellipse(20.0, 20.0)
    assert route.length_m == pytest.approx(2 * np.pi * 20.0, rel=1e-3)
    for along_m in (-0.37, 0.0, 0.05, 17.2):
        np.testing.assert_allclose(
            route.point_m(along_m), route.point_m(along_m + 3 * route.length_m), atol=1e-9
        )
    around = np.linspace(-1.0, 1.0, 50)
    np.testing.assert_allclose(route.curvature_pm(around), 0.05, rtol=0.01)


@pytest.mark.parametrize("near_m", [24.0, 27.0, 30.0])
def test_the_nearest_point_is_found_from_a_guess(near_m: float) -> None:
    route = bend(10.0)
    beside = route.point_m(27.0) + 0.4 * np.array([-route.direction(27.0)[1], route.direction(27.0)[0]])
    assert route.nearest_m(beside, near_m) == pytest.approx(27.0, abs=0.1)


@pytest.mark.parametrize("route", [bend(10.0), ellipse(20.0, 15.0)], ids=["open", "loop"])
def test_backwards_is_the_same_line_from_the_other_end(route: Route) -> None:
    back = backwards_from(route, 30.0)
    for along_m in (2.0, 7.0, 28.0):
        np.testing.assert_allclose(back.point_m(along_m), route.point_m(30.0 - along_m), atol=0.06)
        assert back.curvature_pm(along_m) == pytest.approx(-route.curvature_pm(30.0 - along_m), abs=0.01)


@pytest.mark.parametrize("backwards", [False, True])
def test_the_follower_steers_back_to_the_route(backwards: bool) -> None:
    follower = Follower(STRAIGHT, CAR.wheelbase_m, 0.0)
    heading = np.array([-1.0 if backwards else 1.0, 0.0])
    for left_m in (-1.0, 1.0):
        steer_rad = follower.steer_rad(np.array([2.0, left_m]), np.array([5.0, 0.0]), heading)
        # Seen from above the rear must swing to the route: steering acts the other way round in reverse.
        assert np.sign(steer_rad) == (1 if backwards else -1) * np.sign(left_m)
