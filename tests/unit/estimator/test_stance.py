"""How much the body of a car moves on its springs, from how the car drives."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.se3 import SE3
from estimator.stance import StanceConfig, acceleration_mps2
from tests.mounts import arc

STEP_NS = 200_000_000


def stamps(count: int) -> tuple[int, ...]:
    return tuple(index * STEP_NS for index in range(count))


def braking(from_mps: float, by_mps2: float, count: int) -> list[SE3]:
    times_s = np.array(stamps(count)) * 1e-9
    return [SE3(np.eye(3), np.array([from_mps * t - 0.5 * by_mps2 * t**2, 0.0, 0.0])) for t in times_s]


def test_steady_straight_driving_is_calm() -> None:
    np.testing.assert_allclose(acceleration_mps2(braking(5.0, 0.0, 8), stamps(8)), 0, atol=1e-9)


def test_a_circle_pulls_by_speed_squared_over_radius() -> None:
    np.testing.assert_allclose(acceleration_mps2(arc(1.0, 10, 1 / 20), stamps(10)), 5.0**2 / 20, rtol=0.01)


@pytest.mark.parametrize("by_mps2", [3.0, -2.0])
def test_braking_and_speeding_up_count_alike(by_mps2: float) -> None:
    felt = acceleration_mps2(braking(8.0, by_mps2, 8), stamps(8))
    np.testing.assert_allclose(felt, abs(by_mps2), rtol=1e-6)


def test_only_the_keyframes_around_the_brakes_count() -> None:
    calm = braking(5.0, 0.0, 12)
    hard = [SE3(p.rotation, calm[-1].translation + p.translation) for p in braking(5.0, 3.0, 8)][1:]
    felt = acceleration_mps2([*calm, *hard], stamps(19))
    np.testing.assert_allclose(felt[:10], 0, atol=1e-9)
    np.testing.assert_allclose(felt[13:], 3.0, rtol=1e-6)


def test_a_car_that_brakes_to_a_stand_and_drives_off_again_was_calm_at_no_time() -> None:
    meters = np.arange(0.0, 12.6, 1.0)
    before_s = (np.sqrt(2 * 12.5 / 2.5) - np.sqrt(2 * (12.5 - meters) / 2.5))[:, None]  # from 7.9 m/s to 0
    away_s = before_s[-1] + 30 + before_s[-1] - before_s[::-1]
    times_s = np.concatenate([before_s, away_s]).ravel()
    places_m = np.concatenate([meters, 25.0 - meters[::-1]])
    poses = [SE3(np.eye(3), np.array([place, 0.0, 0.0])) for place in places_m]
    felt = acceleration_mps2(poses, (times_s * 1e9).astype(np.int64).tolist())
    np.testing.assert_allclose(felt, 2.5, atol=0.8)


@pytest.mark.parametrize("stamps_ns", [(), (0, 0, 0, 0), (3, 2, 1, 0)])
def test_without_stamps_that_rise_a_car_counts_as_calm(stamps_ns: tuple[int, ...]) -> None:
    np.testing.assert_array_equal(acceleration_mps2(braking(5.0, 3.0, 4), stamps_ns), 0.0)


def test_a_body_that_dives_keeps_its_height_in_the_middle_of_the_wheelbase() -> None:
    covariance = StanceConfig().covariance(3.0, 1.35)
    dive_rad = 0.02  # nose down: seen from the body, the road rises ahead
    held = np.array([0, -dive_rad, 0, 0, 0, -1.35 * dive_rad])
    sunk = np.array([0, -dive_rad, 0, 0, 0, 0.0])
    assert held @ np.linalg.solve(covariance, held) < 1.0 < 2 < sunk @ np.linalg.solve(covariance, sunk)


def test_a_calm_car_stands_as_the_settings_say_and_a_hard_driven_one_less_surely() -> None:
    config, middle = StanceConfig(), np.array([0, -1.35, 0, 0, 0, 1.0])  # the height there
    calm, hard = (config.covariance(by_mps2, 1.35) for by_mps2 in (0.0, 4.0))
    np.testing.assert_allclose(np.sqrt(np.diag(calm))[[0, 1, 5]], [0.01, 0.01, 0.01])
    assert np.sqrt(middle @ (hard - calm) @ middle) == pytest.approx(4 * config.height_m_per_mps2)
    assert np.sqrt(hard[0, 0]) == pytest.approx(np.hypot(0.01, 4 * config.tilt_rad_per_mps2))
