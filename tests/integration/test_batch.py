"""The batch estimator on a short drive through a street of textured planes."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.batch import BatchConfig, BatchEstimator
from estimator.bundle import FrameBundle
from estimator.estimate import Estimate, Status
from estimator.finding import FindingKind
from estimator.online import OnlineEstimator
from estimator.window_result import ResultConfig
from tests.canyon_drive import IN_STEP, NOMINAL, PATH, PERIOD_NS, TRUTH, as_bytes, rig_of
from tests.mounts import worst_error


def drive(bundles: list[FrameBundle], config: BatchConfig | None = None) -> Estimate:
    """Return the last answer."""
    estimator = BatchEstimator(NOMINAL, config or BatchConfig(online=IN_STEP))
    for bundle in bundles:
        estimator.update(bundle)
    return estimator.close()


@pytest.fixture(scope="module")
def answer(bundles: list[FrameBundle]) -> Estimate:
    return drive(bundles)


def test_a_wrong_rig_is_put_right(answer: Estimate) -> None:
    rotation_deg, translation_mm = worst_error(rig_of(answer), TRUTH)
    assert rotation_deg < 0.06 and translation_mm < 15
    assert all(camera.status is Status.CONVERGED for camera in answer.cameras.values())


def test_the_path_is_in_metres_and_every_bundle_has_its_pose(answer: Estimate) -> None:
    trajectory = dict(answer.trajectory)
    assert sorted(trajectory) == [index * PERIOD_NS for index in range(len(PATH))]
    for index, true in enumerate(PATH):
        error = true.local(trajectory[index * PERIOD_NS])
        assert np.linalg.norm(error[:3]) < np.deg2rad(0.3) and np.linalg.norm(error[3:]) < 0.1


def test_two_drives_give_the_same_bytes(bundles: list[FrameBundle], answer: Estimate) -> None:
    assert as_bytes([drive(bundles)]) == as_bytes([answer])


def test_a_drive_in_segments_is_put_right_too(bundles: list[FrameBundle]) -> None:
    rotation_deg, translation_mm = worst_error(
        rig_of(drive(bundles, BatchConfig(segment_keyframes=10))), TRUTH
    )
    assert rotation_deg < 0.15 and translation_mm < 30


def test_while_the_car_drives_the_answers_are_the_online_ones(bundles: list[FrameBundle]) -> None:
    online, batch = OnlineEstimator(NOMINAL), BatchEstimator(NOMINAL)
    for bundle in bundles[:13]:
        expected, got = online.update(bundle), batch.update(bundle)
        for name, camera in expected.cameras.items():
            np.testing.assert_array_equal(got.cameras[name].ego_from_cam.matrix, camera.ego_from_cam.matrix)


def test_a_standing_car_learns_nothing_and_says_so(bundles: list[FrameBundle]) -> None:
    last = drive([FrameBundle(index * PERIOD_NS, bundles[0].images) for index in range(12)])
    for name in NOMINAL.estimated_names:
        assert last.cameras[name].status is Status.INITIALISING
        np.testing.assert_array_equal(
            last.cameras[name].ego_from_cam.matrix, NOMINAL[name].ego_from_cam.matrix
        )


def test_no_bundles_are_no_error() -> None:
    assert drive([]).cameras["left_rear"].status is Status.INITIALISING


def test_a_refined_drive_is_as_unsure_as_its_lenses(bundles: list[FrameBundle]) -> None:
    refining = IN_STEP.model_copy(update={"refine": "intrinsics"})
    online = OnlineEstimator(NOMINAL, refining)
    for bundle in bundles:
        online.update(bundle)
    expected, got = online.close(), drive(bundles, BatchConfig(online=refining))
    for name in NOMINAL.estimated_names:
        np.testing.assert_allclose(got.cameras[name].sigma, expected.cameras[name].sigma, rtol=0.02)


def test_segments_that_cannot_be_adjusted_are_told(bundles: list[FrameBundle]) -> None:
    window = IN_STEP.window.model_copy(update={"result": ResultConfig(min_inliers=100_000)})
    last = drive(bundles, BatchConfig(online=IN_STEP.model_copy(update={"window": window})))
    assert (
        last.cameras["left_rear"].status is Status.INITIALISING and not last.findings
    )  # online learnt nothing
    batch = BatchEstimator(NOMINAL, BatchConfig(online=IN_STEP))
    for bundle in bundles:
        batch.update(bundle)
    batch.config = BatchConfig(online=IN_STEP.model_copy(update={"window": window}))
    last = batch.close()
    (told,) = last.findings
    assert told.kind is FindingKind.UNSOLVED_WINDOWS and "1 of 1 segments" in told.about
    assert last.cameras["left_rear"].status is Status.CONVERGED
