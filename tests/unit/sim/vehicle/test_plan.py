"""The planned speed: what it obeys, and that its numbers agree with each other."""

from __future__ import annotations

import numpy as np
import pytest

from sim.vehicle.drive import DriveConfig
from sim.vehicle.plan import SpeedPlan, plan_speed
from sim.vehicle.route import Route
from tests.drives import STRAIGHT, bend, ellipse


def planned(route: Route = STRAIGHT, **settings: object) -> tuple[DriveConfig, SpeedPlan]:
    config = DriveConfig.model_validate(settings)
    return config, plan_speed(config, route)


def test_a_steady_drive_takes_distance_by_speed_and_has_a_bundle_at_both_ends() -> None:
    config, plan = planned(speed_mps=5.0, distance_m=50.0)
    assert plan.duration_s == pytest.approx(10.0, abs=1e-9)
    assert plan.bundle_count(10.0) == 101 == config.bundle_count
    assert plan.bundle_count(config.rate_hz) == config.bundle_count
    assert config.time_s(100) == pytest.approx(10.0)


@pytest.mark.parametrize("speed_mps", [0.2, 1.1, 7.3, 40.0])
@pytest.mark.parametrize("rate_hz", [1.0, 7.0, 30.0])
def test_an_undisturbed_plan_has_the_bundles_that_the_settings_foretell(
    speed_mps: float, rate_hz: float
) -> None:
    config, plan = planned(speed_mps=speed_mps, distance_m=33.0, rate_hz=rate_hz)
    assert plan.bundle_count(rate_hz) == config.bundle_count


@pytest.mark.parametrize("profile", ["steady", "pull_away", "stop_and_go", "crawl", "hard_braking"])
def test_distance_is_the_integral_of_speed_and_ends_at_the_distance_asked_for(profile: str) -> None:
    _, plan = planned(bend(12.0), speed_mps=6.0, distance_m=60.0, profile=profile)
    times_s = np.linspace(0.0, plan.duration_s, 4001)
    speeds_mps = np.array([plan.speed_mps(time_s) for time_s in times_s])
    assert np.trapezoid(speeds_mps, times_s) == pytest.approx(60.0, abs=0.01)
    assert plan.distance_m(plan.duration_s) == pytest.approx(60.0, abs=1e-6)
    assert (speeds_mps >= 0.0).all() and speeds_mps.max() <= 6.0 + 1e-9
    for time_s in np.linspace(0.5, plan.duration_s - 0.5, 50):
        change = (plan.speed_mps(time_s + 0.01) - plan.speed_mps(time_s - 0.01)) / 0.02
        assert plan.acceleration_mps2(time_s) == pytest.approx(change, abs=0.3)


def test_accelerates_and_brakes_within_comfort_except_where_hard_braking_is_asked_for() -> None:
    def extremes(profile: str) -> tuple[float, float]:
        _, plan = planned(speed_mps=10.0, distance_m=120.0, profile=profile)
        felt = [plan.acceleration_mps2(time_s) for time_s in np.arange(0.0, plan.duration_s, 0.05)]
        return min(felt), max(felt)

    assert extremes("stop_and_go") == pytest.approx((-2.2, 1.8), rel=0.05)
    assert extremes("hard_braking") == pytest.approx((-8.0, 1.8), rel=0.05)
    assert extremes("steady") == pytest.approx((0.0, 0.0), abs=1e-9)


def test_stops_where_and_as_long_as_the_profile_says() -> None:
    _, plan = planned(speed_mps=10.0, distance_m=100.0, profile="hard_braking")
    times_s = np.arange(0.0, plan.duration_s, 0.02)
    still_s = [time_s for time_s in times_s if plan.speed_mps(time_s) < 1e-9]
    assert len(still_s) * 0.02 == pytest.approx(1.0, abs=0.05)
    assert plan.distance_m(still_s[0]) == pytest.approx(60.0, abs=0.1)


def test_bends_are_slow_and_only_bends_are() -> None:
    _, plan = planned(bend(12.0), speed_mps=9.0, distance_m=65.0)
    slowest = min(plan.speed_mps(time_s) for time_s in np.arange(0.0, plan.duration_s, 0.05))
    assert slowest == pytest.approx(np.sqrt(2.5 * 12.0), rel=0.03)
    assert plan.speed_mps(0.0) == pytest.approx(9.0)
    _, straight = planned(speed_mps=9.0, distance_m=65.0)
    assert min(straight.speed_mps(t) for t in np.arange(0.0, straight.duration_s, 0.05)) == 9.0


def test_a_loop_is_planned_as_many_times_round_as_the_distance_needs() -> None:
    route = ellipse(30.0, 12.0)
    _, plan = planned(route, speed_mps=9.0, distance_m=3 * route.length_m)
    lap_s = plan.duration_s / 3
    for time_s in np.linspace(1.0, lap_s - 1, 20):
        assert plan.speed_mps(time_s + lap_s) == pytest.approx(plan.speed_mps(time_s), abs=0.3)


def test_a_slippery_road_is_planned_slower_unless_an_acceleration_is_asked_for() -> None:
    dry, icy, told = (
        planned(bend(12.0), speed_mps=8.0, distance_m=60.0, **more)[1].duration_s
        for more in ({}, {"grip": 0.1}, {"grip": 0.1, "lateral_mps2": 2.5})
    )
    assert icy > 1.3 * dry
    assert told < icy
