"""Wheel speeds: those of a rolling wheel where it rolls, others where it turns or slips."""

from __future__ import annotations

import numpy as np
import pytest

from sim.vehicle.car_sensors import CarSensors
from sim.vehicle.drive import DriveConfig
from sim.vehicle.inertial import InertialConfig
from sim.vehicle.motion import Motion
from sim.vehicle.route import Route
from sim.vehicle.wheel_sensors import SPEED_STEP_RADPS, WheelSample
from tests.drives import CAR, STRAIGHT, bend


def wheels(
    drive: DriveConfig, route: Route = STRAIGHT, inertial: InertialConfig | None = None, seed: int = 0
) -> list[WheelSample]:
    motion = Motion(drive, route, None, CAR)
    sensors = CarSensors(inertial or InertialConfig(noise=0.0), motion, CAR, seed)
    times_s = np.arange(0.0, motion.plan.duration_s, 0.5)
    return [each for time_s in times_s for each in sensors.until(float(time_s)).wheels]


def test_a_rolling_wheel_turns_by_its_rolling_radius() -> None:
    for each in wheels(DriveConfig(speed_mps=9.0, distance_m=30.0)):
        for wheel, radps in each.speeds_radps.items():
            assert radps * CAR.rolling_radius_m(wheel) == pytest.approx(9.0, abs=0.06)
        assert each.steer_rad == pytest.approx(0.0, abs=1e-4)


def test_outer_wheels_turn_faster_and_the_steering_points_into_the_bend() -> None:
    middle = [each for each in wheels(DriveConfig(), bend(12.0)) if 5.5 < each.time_s < 7.0]
    for each in middle:
        speeds = each.speeds_radps
        assert speeds["rear_right"] / speeds["rear_left"] == pytest.approx(12.77 / 11.23, rel=0.02)
        assert each.steer_rad == pytest.approx(2.7 / 12.0, rel=0.1)


def test_driven_wheels_slip_by_as_much_as_the_push_needs() -> None:
    pushing = [
        each
        for each in wheels(DriveConfig(speed_mps=12.0, distance_m=40.0, profile="pull_away"))
        if 4.0 < each.time_s < 6.0
    ]
    needed = CAR.mass_kg * 1.8 / 2 / (CAR.rear_tyre_share * CAR.tyre.cornering_npr)
    for each in pushing:
        rear_mps = each.speeds_radps["rear_left"] * CAR.rolling_radius_m("rear_left")
        front_mps = each.speeds_radps["front_left"] * CAR.rolling_radius_m("front_left")
        assert rear_mps / front_mps - 1 == pytest.approx(needed, abs=0.01)
    assert len(pushing) == 100


def test_a_standing_car_reads_zero_and_reversing_wheels_turn_backwards() -> None:
    samples = wheels(DriveConfig(speed_mps=2.0, distance_m=10.0, profile="pull_away", reverse=True))
    assert set(samples[0].speeds_radps.values()) == {0.0}
    assert all(radps < -5.0 for radps in samples[-1].speeds_radps.values())


def test_speeds_are_multiples_of_a_step_and_noise_is_seeded() -> None:
    noisy = InertialConfig(noise=2.0)
    one, again, other = (wheels(DriveConfig(distance_m=10.0), inertial=noisy, seed=s) for s in (1, 1, 2))
    said = np.array([list(each.speeds_radps.values()) for each in one])
    np.testing.assert_allclose(said / SPEED_STEP_RADPS, np.round(said / SPEED_STEP_RADPS), atol=1e-9)
    assert [each.speeds_radps for each in one] == [each.speeds_radps for each in again]
    assert [each.speeds_radps for each in one] != [each.speeds_radps for each in other]
    assert np.std(said) == pytest.approx(0.06, rel=0.3)
