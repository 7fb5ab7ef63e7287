"""Whole streets full of traffic: nobody runs into anybody, motion is continuous, knobs keep to themselves."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from sim.traffic.config import TrafficConfig
from sim.traffic.fleet import CAR_KINDS
from sim.traffic.troupe import Troupe
from sim.vehicle.drive import DriveConfig, Profile
from tests.traffic_streets import drive_through, overlapping

BUSY = TrafficConfig(cars=4, cyclists=4, pedestrians=4)
JAM = TrafficConfig(cars=5, cyclists=5, pedestrians=5)


def places(troupe: Troupe, time_s: float) -> np.ndarray:
    return troupe.stance(time_s).origins_m


@pytest.mark.parametrize(
    ("kind", "traffic"),
    [
        ("bend", BUSY),
        ("crossroads", JAM),
        ("t_junction", BUSY),
        ("roundabout", BUSY),
        ("loop", BUSY),
        ("motorway", TrafficConfig(cars=3)),
    ],
)
def test_nobody_runs_into_anybody(kind: str, traffic: TrafficConfig) -> None:
    drive = drive_through(kind, traffic, DriveConfig(speed_mps=6.0, distance_m=70.0))
    for time_s in np.arange(0.0, 12.0, 0.75):
        assert overlapping(drive.outlines_m(float(time_s))) == []


@pytest.mark.parametrize("profile", ["stop_and_go", "pull_away", "hard_braking", "crawl"])
def test_the_lane_bears_any_way_of_driving(profile: Profile) -> None:
    drive = drive_through("bend", BUSY, DriveConfig(speed_mps=7.0, distance_m=60.0, profile=profile), seed=1)
    for time_s in np.arange(0.0, min(24.0, drive.plan.duration_s), 1.5):
        assert overlapping(drive.outlines_m(float(time_s))) == []


def test_no_vehicle_comes_twice_on_a_lane_before_all_have_come() -> None:
    traffic = drive_through("crossroads", BUSY, DriveConfig(distance_m=40.0)).traffic
    own_lane, driving = (troupe for troupe in traffic.troupes if troupe.name in ("car_own_lane", "car"))
    kinds = len(CAR_KINDS)
    assert len(own_lane.models) > 4 and len(driving.models) > 8
    for troupe in (own_lane, driving):
        for track in np.unique(troupe.track):
            names = [m.name for m, at in zip(troupe.models, troupe.track, strict=True) if at == track]
            assert len(set(names[:kinds])) == len(names[:kinds])


def test_who_backs_up_finds_the_lane_free() -> None:
    drive = drive_through("bend", BUSY, DriveConfig(speed_mps=2.0, distance_m=20.0, reverse=True))
    for time_s in np.arange(0.0, 10.0, 1.0):
        assert overlapping(drive.outlines_m(float(time_s))) == []


def test_nobody_jumps_between_two_rows_of_a_shutter() -> None:
    drive = drive_through("crossroads", BUSY, DriveConfig(distance_m=40.0))
    for troupe in drive.traffic.troupes:
        for start_s in (0.0, 3.1, 7.77):
            steps = [places(troupe, start_s + 0.004 * k) for k in range(12)]
            moved = np.array([np.linalg.norm(b - a, axis=1) for a, b in itertools.pairwise(steps)])
            comes_in_again = moved.max(axis=0) > 10.0
            assert moved[:, ~comes_in_again].max() < 0.004 * 12.0
            assert comes_in_again.mean() < 0.1


def test_asking_in_another_order_changes_nothing() -> None:
    drive = DriveConfig(distance_m=40.0)
    one, other = (drive_through("bend", BUSY, drive).traffic for _ in range(2))
    times = [0.0, 0.5, 4.0, 4.004, 7.0]
    for troupe in other.troupes:
        for time_s in reversed(times):
            places(troupe, time_s)
    for first, second in zip(one.troupes, other.troupes, strict=True):
        for time_s in times:
            np.testing.assert_array_equal(places(first, time_s), places(second, time_s))


def test_a_longer_drive_begins_like_a_short_one() -> None:
    short, long = (
        drive_through("crossroads", BUSY, DriveConfig(distance_m=distance)).traffic
        for distance in (20.0, 70.0)
    )
    for first, second in zip(short.troupes, long.troupes, strict=True):
        np.testing.assert_allclose(places(first, 2.0), places(second, 2.0), atol=1e-9)


def test_more_of_one_kind_leaves_those_it_gives_way_to_alone() -> None:
    def cars_and_cyclists(cyclists: float, pedestrians: float) -> list[np.ndarray]:
        config = TrafficConfig(cars=3, cyclists=cyclists, pedestrians=pedestrians)
        crowd = drive_through("crossroads", config, DriveConfig(distance_m=40.0)).traffic
        return [places(troupe, 5.0) for troupe in crowd.troupes[:3]]

    quiet, with_people, with_bikes = (cars_and_cyclists(*of) for of in ((2, 0), (2, 4), (5, 0)))
    for one, other in zip(quiet, with_people, strict=True):
        np.testing.assert_array_equal(one, other)
    for one, other in zip(quiet[:2], with_bikes[:2], strict=True):
        np.testing.assert_array_equal(one, other)


@pytest.mark.parametrize("kind", ["cars", "cyclists", "pedestrians"])
def test_a_higher_degree_is_denser(kind: str) -> None:
    counts = []
    for degree in (0, 0.5, 2, 3.5, 5):
        crowd = drive_through("bend", TrafficConfig(**{kind: degree}), DriveConfig()).traffic
        counts.append(sum(len(troupe.models) for troupe in crowd.troupes))
    assert counts[0] == 0
    assert counts == sorted(counts)
    assert counts[-1] > 2 * counts[2] > 0


def test_some_pass_close_by_the_cameras() -> None:
    drive = drive_through("bend", TrafficConfig(cyclists=4), DriveConfig(distance_m=60.0))
    riders = next(troupe for troupe in drive.traffic.troupes if troupe.name == "cyclist")
    nearest = [
        np.linalg.norm(places(riders, t)[:, :2] - drive.route.point_m(drive.plan.distance_m(t)), axis=1).min()
        for t in np.arange(0.0, 12.0, 0.25)
    ]
    assert min(nearest) < 2.4  # from the middle of the car: 1.5 m from a camera on its side


def test_traffic_round_a_block_never_dries_up() -> None:
    drive = drive_through("loop", TrafficConfig(cars=3), DriveConfig(distance_m=1500.0))
    cars = next(troupe for troupe in drive.traffic.troupes if troupe.name == "car")
    moved = [np.linalg.norm(places(cars, t + 2.0) - places(cars, t), axis=1) for t in (280.0, 290.0, 298.0)]
    assert (np.max(moved, axis=0) > 0.5).mean() > 0.6
