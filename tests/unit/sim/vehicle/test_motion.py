"""A drive as a whole: where it starts, what it asks for, what it remembers, and that it adds up."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from estimator.errors import InputError
from estimator.se3 import SE3
from sim.scene import assemble_scene
from sim.stage import Stage
from sim.vehicle.car_state import velocity_in_ego, world_from_ego
from sim.vehicle.drive import DriveConfig
from sim.vehicle.motion import KEPT_S, Motion
from sim.vehicle.route import Route
from tests.drives import CAR, STRAIGHT, Hillside, Ramp, Seen, bend, drive, ellipse, off_route_m
from tests.mounts import left_side_rig


def test_starts_at_the_start_of_the_route_already_at_speed() -> None:
    motion = Motion(DriveConfig(speed_mps=5.0), bend(12.0), None, CAR)
    start = Seen(0.0, motion.state_at(0.0))
    assert 0.0 <= start.world_from_ego.translation[0] < 0.011  # within a physics step
    assert np.abs(start.world_from_ego.translation[1:]).max() < 1e-3
    assert start.velocity_ego_mps[0] == pytest.approx(5.0, abs=0.01)


def test_a_car_that_slides_off_its_road_is_refused() -> None:
    config = DriveConfig(speed_mps=20.0, distance_m=80.0, grip=0.1, lateral_mps2=12.0)
    with pytest.raises(
        InputError, match=r"drive: the car leaves the road after \d+\.\d s; wanted less of drive"
    ):
        drive(config, bend(15.0))


def test_a_car_that_cannot_climb_to_its_start_is_refused() -> None:
    with pytest.raises(InputError, match="drive: the car never gets to its start; wanted"):
        drive(DriveConfig(speed_mps=2.0, distance_m=5.0, grip=0.1), road=Hillside(0.2))


def test_pulls_away_from_a_standstill_at_the_start_of_the_route() -> None:
    _, seen = drive(DriveConfig(speed_mps=8.0, distance_m=40.0, profile="pull_away"))
    assert np.linalg.norm(seen[0].world_from_ego.translation) < 1e-3
    assert np.abs(seen[0].state.qvel).max() < 1e-5
    assert seen[-1].velocity_ego_mps[0] == pytest.approx(8.0, abs=0.1)


@pytest.mark.parametrize("profile", ["steady", "pull_away", "stop_and_go", "crawl", "hard_braking"])
def test_keeps_to_its_plan_within_a_hand_and_drives_the_whole_distance(profile: str) -> None:
    speed_mps, distance_m = (1.2, 12.0) if profile == "crawl" else (8.0, 60.0)
    config = DriveConfig.model_validate(
        {"speed_mps": speed_mps, "distance_m": distance_m, "profile": profile}
    )
    motion, seen = drive(config)
    for each in seen:
        assert each.world_from_ego.translation[0] == pytest.approx(
            motion.plan.distance_m(each.time_s), abs=0.2
        )
    positions_m = np.array([each.world_from_ego.translation[:2] for each in seen])
    driven_m = np.linalg.norm(np.diff(positions_m, axis=0), axis=1).sum()
    assert driven_m == pytest.approx(distance_m, abs=0.5)


def test_stops_completely_and_goes_again() -> None:
    motion, seen = drive(DriveConfig(speed_mps=6.0, distance_m=70.0, profile="stop_and_go"))
    speeds_mps = np.array([each.velocity_ego_mps[0] for each in seen])
    planned_mps = np.array([motion.plan.speed_mps(each.time_s) for each in seen])
    standing = planned_mps == 0.0
    starts = np.flatnonzero(np.diff(standing.astype(int)) == 1)
    assert len(starts) >= 2
    for start in starts:
        halt = [each for each in seen[start + 10 :] if each.time_s < seen[start].time_s + 1.8]
        creep_m = halt[-1].world_from_ego.translation[0] - halt[0].world_from_ego.translation[0]
        assert abs(creep_m) < 1e-4
        assert max(abs(each.velocity_ego_mps[0]) for each in halt) < 1e-3
    assert speeds_mps.max() == pytest.approx(6.0, abs=0.15)


@pytest.mark.parametrize("route", [bend(12.0), STRAIGHT])
def test_reverses_along_the_route_looking_forwards_and_ends_at_its_start(route: Route) -> None:
    config = DriveConfig(speed_mps=2.0, distance_m=45.0, profile="pull_away", reverse=True)
    _, seen = drive(config, route)
    assert np.linalg.norm(seen[0].world_from_ego.translation[:2] - route.point_m(45.0)) < 0.1
    assert all(each.velocity_ego_mps[0] < 0.001 for each in seen)
    assert max(off_route_m(route, each) for each in seen) < 0.15
    assert np.linalg.norm(seen[-1].world_from_ego.translation[:2]) < 0.3
    assert seen[-1].world_from_ego.rotation[0, 0] > 0.999  # it looks along the first direction


@pytest.mark.parametrize("reverse", [False, True])
def test_goes_round_a_loop_again_and_again_without_a_jump(reverse: bool) -> None:
    route = ellipse(25.0, 18.0)
    config = DriveConfig(speed_mps=6.0, distance_m=2.5 * route.length_m, reverse=reverse)
    _, seen = drive(config, route)
    positions_m = np.array([each.world_from_ego.translation[:2] for each in seen])
    steps_m = np.linalg.norm(np.diff(positions_m, axis=0), axis=1)
    assert steps_m.max() < 6.2 * 0.05 and steps_m.min() > 5.0 * 0.05
    assert max(off_route_m(route, each) for each in seen) < 0.2
    assert max(abs(each.yaw_rate_radps) for each in seen) < 0.55


def test_the_last_second_is_remembered_in_any_order_and_no_more() -> None:
    motion = Motion(DriveConfig(), STRAIGHT, None, CAR)
    motion.state_at(3.0)
    early = motion.state_at(3.0 - KEPT_S)
    again = motion.state_at(2.5)
    assert early.qpos[0] == pytest.approx(10.0, abs=0.05) and again.qpos[0] == pytest.approx(12.5, abs=0.05)
    with pytest.raises(ValueError, match="forgotten"):
        motion.state_at(1.5)


def test_a_state_does_not_depend_on_what_was_asked_before() -> None:
    fine, coarse = (Motion(DriveConfig(), bend(12.0), Ramp(0.02), CAR) for _ in range(2))
    for time_s in np.arange(0.0, 3.0, 0.0137):
        fine.state_at(float(time_s))
    for time_s in (2.3, 2.9, 2.4321):
        np.testing.assert_array_equal(fine.state_at(time_s).qpos, coarse.state_at(time_s).qpos)
        np.testing.assert_array_equal(fine.state_at(time_s).qvel, coarse.state_at(time_s).qvel)


def test_velocity_truth_is_the_derivative_of_pose_truth_at_any_instant() -> None:
    scene = assemble_scene(lambda spec: None, bend(14.0), left_side_rig(), Ramp(0.04, 0.05, 12.0))
    stage = Stage(scene, DriveConfig(speed_mps=6.0, distance_m=45.0))
    rng = np.random.default_rng(0)
    step_s = 0.004
    for time_s in np.sort(rng.uniform(0.1, 7.0, 60)):
        before, after = (_pose(stage, float(time_s) + side * step_s) for side in (-1, 1))
        data = stage.at(float(time_s))
        pose, velocity = world_from_ego(data), velocity_in_ego(scene.model, data)
        linear_mps = pose.rotation.T @ (after.translation - before.translation) / (2 * step_s)
        turn = Rotation.from_matrix(before.rotation.T @ after.rotation).as_rotvec() / (2 * step_s)
        np.testing.assert_allclose(linear_mps, velocity[3:], atol=2e-3)
        np.testing.assert_allclose(turn, velocity[:3], atol=5e-3)


def _pose(stage: Stage, time_s: float) -> SE3:
    return world_from_ego(stage.at(time_s))


def test_grip_changes_nothing_while_nothing_slides() -> None:
    """The same drive on dry and on wet road, as long as neither is near its limit."""
    ends = [drive(DriveConfig(speed_mps=4.0, distance_m=30.0, grip=grip))[1][-1].state for grip in (0.6, 1.1)]
    np.testing.assert_allclose(ends[0].qpos, ends[1].qpos, atol=1e-4)
