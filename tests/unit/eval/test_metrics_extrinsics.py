"""Extrinsic errors: final, worst, median, and at set distances."""

import numpy as np
import pytest

from estimator.se3 import SE3
from eval.errors import pose_error, tangent_error
from eval.metric import Missing
from eval.metrics_extrinsics import checkpoint_index, extrinsic_metrics
from tests.unit.eval.tiny_run import RIG, camera_estimates, off_by, run_log, straight, truth_of


def test_error_is_the_angle_of_the_relative_rotation_and_the_distance_of_the_centres():
    true = SE3.exp(np.array([0.3, -0.2, 1.0, 1.0, 2.0, 3.0]))
    error = pose_error(true.retract(off_by(0.5, 40)), true)
    assert error.rotation_deg == pytest.approx(0.5)
    assert error.translation_mm == pytest.approx(40, rel=1e-4)


def test_tangent_error_undoes_the_perturbation():
    estimated = SE3.exp(np.array([0.3, -0.2, 1.0, 1.0, 2.0, 3.0]))
    tangent = np.array([0.01, 0.02, -0.03, 0.1, 0.2, -0.3])
    assert tangent_error(estimated, estimated.retract(tangent)) == pytest.approx(tangent)


def test_final_error_is_that_of_close_and_not_of_the_last_update():
    path = straight(5)
    log = run_log(
        path, lambda index: {"left": off_by(2, 200)}, final=camera_estimates({"left": off_by(0.1, 8)})
    )
    values = extrinsic_metrics(log, truth_of(path))
    assert values["extrinsics.left.rotation_deg"] == pytest.approx(0.1)
    assert values["extrinsics.left.translation_mm"] == pytest.approx(8, rel=1e-3)


def test_worst_and_median_take_each_quantity_by_itself():
    path = straight(3)
    errors = {"left": off_by(0.4, 1), "rear": off_by(0.2, 5)}
    values = extrinsic_metrics(run_log(path, final=camera_estimates(errors)), truth_of(path))
    assert values["extrinsics.worst.rotation_deg"] == pytest.approx(0.4)
    assert values["extrinsics.worst.translation_mm"] == pytest.approx(5, rel=1e-3)
    assert values["extrinsics.median.rotation_deg"] == pytest.approx(0.3)


def test_the_reference_counts_for_nothing():
    path = straight(3)
    values = extrinsic_metrics(
        run_log(path, final=camera_estimates({"front": off_by(9, 900)})), truth_of(path)
    )
    assert values["extrinsics.worst.rotation_deg"] == pytest.approx(0, abs=1e-6)
    assert not any("front." in key for key in values)


def test_the_error_at_10_m_is_the_online_one_of_the_first_bundle_there():
    path = straight(15)
    log = run_log(path, lambda index: {"rear": off_by(10 - 0.5 * index, 100)})
    values = extrinsic_metrics(log, truth_of(path))
    assert values["extrinsics.rear.rotation_deg.at_10m"] == pytest.approx(10 - 0.5 * 10)


def test_a_distance_beyond_the_drive_is_missing_with_the_length_of_the_drive():
    path = straight(15)
    value = extrinsic_metrics(run_log(path), truth_of(path))["extrinsics.worst.rotation_deg.at_20m"]
    assert value == Missing("the drive is 14.0 m long")


@pytest.mark.parametrize(("last_m", "index"), [(49.96, 99), (49.4, 99), (48.0, None)])
def test_a_drive_that_ends_one_frame_short_still_has_its_checkpoint(last_m, index):
    assert checkpoint_index(50, np.linspace(0, last_m, 100)) == index


def test_distance_is_that_of_the_true_path_even_if_the_estimated_one_is_too_long():
    log = run_log(straight(15, step_m=2.0))
    assert (
        "14.0 m"
        in extrinsic_metrics(log, truth_of(straight(15)))["extrinsics.worst.rotation_deg.at_20m"].reason
    )


def test_truth_that_starts_before_the_first_bundle_adds_no_distance():
    truth = truth_of(straight(21))
    log = run_log(straight(11))
    shifted = type(truth)(
        [stamp - 1_000_000_000 for stamp in truth.stamps_ns], truth.world_from_ego, truth.extrinsics
    )
    assert "10.0 m" in extrinsic_metrics(log, shifted)["extrinsics.worst.rotation_deg.at_20m"].reason


def test_a_camera_that_the_truth_lacks_makes_the_worst_unknown():
    path = straight(3)
    truth = truth_of(path)
    poses = {name: pose for name, pose in truth.extrinsics[0][1].items() if name != "rear"}
    values = extrinsic_metrics(
        run_log(path), type(truth)(truth.stamps_ns, truth.world_from_ego, [(0, poses)])
    )
    assert values["extrinsics.worst.rotation_deg"] == Missing("the truth does not hold camera 'rear'")
    assert isinstance(values["extrinsics.left.rotation_deg"], float)


def test_a_pose_that_is_not_finite_has_an_infinite_error():
    lost = SE3(np.full((3, 3), np.nan), np.zeros(3))
    assert not pose_error(lost, RIG["rear"].ego_from_cam).is_finite
