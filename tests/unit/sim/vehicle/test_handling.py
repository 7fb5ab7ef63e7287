"""How the car moves in bends, under brakes and on ice: the figures a test driver would measure."""

from __future__ import annotations

import numpy as np
import pytest

from sim.vehicle.drive import DriveConfig
from tests.drives import CAR, STRAIGHT, bend, drive, off_route_m


@pytest.mark.parametrize("speed_mps", [1.0, 2.0, 5.0, 8.0])
def test_follows_a_bend_within_0_3_m_at_the_asked_speed(speed_mps: float) -> None:
    route = bend(12.0)
    _, seen = drive(DriveConfig(speed_mps=speed_mps, distance_m=60.0, lateral_mps2=9.0), route)
    assert max(off_route_m(route, each) for each in seen) < 0.3
    assert all(each.velocity_ego_mps[0] == pytest.approx(speed_mps, rel=0.05) for each in seen)
    assert seen[-1].world_from_ego.translation[1] > 20  # it did come out of the bend


def test_leans_out_of_a_left_bend_by_four_to_six_degrees_a_g() -> None:
    _, seen = drive(DriveConfig(speed_mps=8.0, distance_m=80.0, lateral_mps2=9.0), bend(24.0))
    steady = [each for each in seen if 4.6 < each.time_s < 6.2]
    for each in steady:
        lateral_g = each.yaw_rate_radps * 8.0 / 9.81
        assert lateral_g == pytest.approx(8.0**2 / 24 / 9.81, rel=0.05)
        assert 4.0 < each.roll_deg / lateral_g < 6.0


def test_the_rear_axle_slips_outwards_by_the_angle_its_tyres_need() -> None:
    _, seen = drive(DriveConfig(speed_mps=8.0, distance_m=80.0, lateral_mps2=9.0), bend(24.0))
    for each in seen:
        if 4.6 < each.time_s < 6.2:
            forward, left, _ = each.velocity_ego_mps
            lateral_n = 2 * CAR.tyre_load_n("rear_left") / 9.81 * each.yaw_rate_radps * forward
            needed_rad = lateral_n / (2 * CAR.rear_tyre_share * CAR.tyre.cornering_npr)
            assert -left / forward == pytest.approx(needed_rad, rel=0.2)


@pytest.mark.parametrize(("grip", "slides"), [(1.0, False), (0.1, True)])
def test_on_ice_a_bend_driven_too_hard_is_left_and_the_car_turns_less_than_it_steers(
    grip: float, slides: bool
) -> None:
    route = bend(24.0)
    _, seen = drive(DriveConfig(speed_mps=5.0, distance_m=45.0, grip=grip, lateral_mps2=9.0), route)
    in_bend = [each for each in seen if 5.0 < each.time_s < 8.0]
    turned = np.mean([each.yaw_rate_radps * 24.0 / each.velocity_ego_mps[0] for each in in_bend])
    assert (turned < 0.9) == slides
    assert (max(off_route_m(route, each) for each in seen) > 1.0) == slides


def test_by_default_the_driver_slows_as_much_as_ice_demands() -> None:
    route = bend(24.0)
    _, seen = drive(DriveConfig(speed_mps=8.0, distance_m=50.0, grip=0.1), route)
    assert max(off_route_m(route, each) for each in seen) < 0.15
    assert min(each.velocity_ego_mps[0] for each in seen) < 4.0


def test_slows_for_a_bend_to_the_comfortable_acceleration_unless_told_otherwise() -> None:
    route = bend(12.0)
    for lateral_mps2, highest_mps2 in ((None, 2.5), (5.0, 5.0)):
        config = DriveConfig(speed_mps=10.0, distance_m=65.0, lateral_mps2=lateral_mps2)
        _, seen = drive(config, route)
        felt = [each.yaw_rate_radps * each.velocity_ego_mps[0] for each in seen]
        # The line steps from straight to bend at once, which makes the car overshoot for a moment.
        assert np.percentile(felt, 90) == pytest.approx(highest_mps2, rel=0.15)


def test_brakes_hard_with_the_nose_down_one_to_two_degrees_at_four_mps2() -> None:
    _, seen = drive(DriveConfig(speed_mps=12.0, distance_m=60.0, profile="hard_braking"), every_s=0.01)
    speeds = np.array([each.velocity_ego_mps[0] for each in seen])
    slowing_mps2 = -np.gradient(speeds, 0.01)
    pitches = np.array([each.pitch_deg for each in seen])
    hard = slowing_mps2 > 7.0
    assert hard.sum() > 50
    assert 1.0 < np.median(pitches[hard] / slowing_mps2[hard]) * 4.0 < 2.0


def test_squats_when_pulling_away_and_sits_level_when_cruising() -> None:
    _, seen = drive(DriveConfig(speed_mps=10.0, distance_m=80.0, profile="pull_away"))
    assert -1.2 < min(each.pitch_deg for each in seen) < -0.3
    assert abs(seen[-1].pitch_deg) < 0.1


def test_is_stable_at_motorway_speed() -> None:
    _, seen = drive(DriveConfig(speed_mps=40.0, distance_m=400.0), STRAIGHT)
    assert max(abs(each.world_from_ego.translation[1]) for each in seen) < 1e-3
    assert max(abs(each.roll_deg) for each in seen) < 0.01
    assert all(each.velocity_ego_mps[0] == pytest.approx(40.0, abs=0.1) for each in seen)
