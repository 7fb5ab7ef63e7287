"""Errors of the car's own path, with evo as the oracle."""

import numpy as np
import pytest
from evo.core import metrics, sync
from evo.core.trajectory import PoseTrajectory3D
from scipy.spatial.transform import Rotation

from estimator.se3 import SE3
from eval.align import align_on_ground
from eval.metric import Missing
from eval.metrics_motion import motion_metrics
from eval.trajectory import Trajectory
from tests.unit.eval.tiny_run import run_log, stamps, straight, truth_of


def winding(count: int) -> list[SE3]:
    """A path of 0.5 m steps with bends, a little heave and roll."""
    pose, path = SE3(), []
    for index in range(count):
        path.append(pose)
        pose = pose.retract(
            np.array([0.002 * np.sin(index), 0, 0.05 * np.sin(index / 9), 0.5, 0, 0.01 * np.cos(index)])
        )
    return path


def noisy(path: list[SE3], scale: float = 1.0) -> list[SE3]:
    rng = np.random.default_rng(1)
    world = SE3.exp(np.array([0.01, 0.02, 2.0, 30.0, -7.0, 1.0]))
    noise = [rng.normal(size=6) * ([0.002] * 3 + [0.02] * 3) for _ in path]
    return [
        (world @ SE3(pose.rotation, scale * pose.translation)).retract(each)
        for pose, each in zip(path, noise, strict=True)
    ]


def evo_trajectory(path: list[SE3]) -> PoseTrajectory3D:
    quaternions = np.array([np.roll(pose.quaternion_xyzw, 1) for pose in path])
    positions = np.array([pose.translation for pose in path])
    return PoseTrajectory3D(positions, quaternions, np.arange(len(path)) * 0.1)


def evo_ate_and_scale(estimated: list[SE3], true: list[SE3]) -> tuple[float, float]:
    reference, answer = sync.associate_trajectories(evo_trajectory(true), evo_trajectory(estimated))
    _, _, scale = evo_trajectory(estimated).align(reference, correct_scale=True)
    answer.align(reference, correct_scale=False)
    error = metrics.APE(metrics.PoseRelation.translation_part)
    error.process_data((reference, answer))
    return error.get_statistic(metrics.StatisticsType.rmse), scale


def test_absolute_error_and_scale_agree_with_evo():
    true = winding(120)
    estimated = noisy(true, scale=1.03)
    ate_m, scale = evo_ate_and_scale(estimated, true)
    values = motion_metrics(run_log(estimated), truth_of(true))
    assert values["motion.ate_m"] == pytest.approx(ate_m, rel=1e-9)
    assert values["motion.scale_error_percent"] == pytest.approx(100 * abs(1 / scale - 1), rel=1e-9)


def test_a_path_in_another_world_has_no_error():
    true = winding(60)
    world = SE3.exp(np.array([0.1, -0.2, 1.5, 10.0, 20.0, 3.0]))
    values = motion_metrics(run_log([world @ pose for pose in true]), truth_of(true))
    assert all(value == pytest.approx(0, abs=1e-6) for value in values.values())


def test_two_percent_too_long_is_two_percent_of_scale_and_of_drift():
    values = motion_metrics(run_log(straight(31, step_m=1.02)), truth_of(straight(31)))
    assert values["motion.scale_error_percent"] == pytest.approx(2.0)
    assert values["motion.rpe_translation_percent"] == pytest.approx(2.0)
    assert values["motion.rpe_rotation_deg_per_m"] == pytest.approx(0.0, abs=1e-9)


def test_a_steady_false_turn_is_its_rate_per_metre():
    turn = SE3.exp(np.array([0, 0, np.radians(0.1), 1.0, 0, 0]))
    estimated = [SE3()]
    for _ in range(30):
        estimated.append(estimated[-1] @ turn)
    values = motion_metrics(run_log(estimated), truth_of(straight(31)))
    assert values["motion.rpe_rotation_deg_per_m"] == pytest.approx(0.1)


def test_a_drive_below_the_shortest_segment_has_no_relative_error():
    values = motion_metrics(run_log(straight(5)), truth_of(straight(5)))
    assert values["motion.rpe_translation_percent"] == Missing(
        "the drive is 4.0 m long; the shortest segment is 5 m"
    )
    assert values["motion.ate_m"] == pytest.approx(0, abs=1e-9)


def test_a_car_that_stands_shows_no_scale():
    values = motion_metrics(run_log(straight(9, 0.0)), truth_of(straight(9, 0.0)))
    assert isinstance(values["motion.scale_error_percent"], Missing)


def test_the_refined_trajectory_is_judged_where_there_is_one():
    true = winding(40)
    refined = list(zip(stamps(40), true, strict=True))
    values = motion_metrics(run_log(noisy(true), trajectory=refined), truth_of(true))
    assert values["motion.ate_m"] == pytest.approx(0, abs=1e-9)


def test_truth_at_other_stamps_is_interpolated():
    true = straight(20)
    truth = truth_of(true)
    late = type(truth)(
        [stamp + 40_000_000 for stamp in truth.stamps_ns], truth.world_from_ego, truth.extrinsics
    )
    moved = [SE3(np.eye(3), pose.translation - [0.4, 0, 0]) for pose in true]
    assert motion_metrics(run_log(moved), late)["motion.ate_m"] == pytest.approx(0, abs=1e-6)


def test_a_pose_between_two_others_turns_and_moves_half_way():
    half = SE3(Rotation.from_euler("z", 90, degrees=True).as_matrix(), np.array([2.0, 0, 0]))
    middle = Trajectory.from_poses([0, 10], [SE3(), half]).at([5]).pose(0)
    assert middle.translation == pytest.approx([1, 0, 0])
    assert np.degrees(middle.angle_rad) == pytest.approx(45)


def test_alignment_for_the_map_turns_only_about_the_vertical():
    true = np.array([pose.translation for pose in straight(9)])
    turn = Rotation.from_euler("z", 70, degrees=True)
    estimated = turn.apply(true) + np.array([1, 2, 3])
    true_from_estimated = align_on_ground(estimated, true)
    assert true_from_estimated.apply(estimated) == pytest.approx(true)
    assert true_from_estimated.rotation[2] == pytest.approx([0, 0, 1])
