"""The online estimator on a short drive through a street of textured planes: no renderer, exact truth."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from estimator.bundle import FrameBundle
from estimator.estimate import Estimate, Status
from estimator.online import OnlineEstimator
from estimator.scale import ROAD
from tests.canyon_drive import IN_STEP, NOMINAL, PATH, PERIOD_NS, TRUTH, as_bytes, rig_of
from tests.mounts import worst_error

Answers = list[Estimate]


def drive(bundles: Sequence[FrameBundle]) -> Answers:
    """Return the answers to all bundles, and the last one."""
    estimator = OnlineEstimator(NOMINAL, IN_STEP)
    return [*(estimator.update(bundle) for bundle in bundles), estimator.close()]


def without(bundles: Sequence[FrameBundle], missing: dict[int, str]) -> list[FrameBundle]:
    """Return the bundles, some of them without the image of a camera."""
    return [
        FrameBundle(
            bundle.stamp_ns, {name: i for name, i in bundle.images.items() if name != missing.get(index)}
        )
        for index, bundle in enumerate(bundles)
    ]


@pytest.fixture(scope="module")
def answers(bundles: list[FrameBundle]) -> Answers:
    return drive(bundles)


def test_a_wrong_rig_is_put_right(answers: Answers) -> None:
    np.testing.assert_allclose(worst_error(NOMINAL, TRUTH), [2.0, 60.0])
    rotation_deg, translation_mm = worst_error(rig_of(answers[-1]), TRUTH)
    assert rotation_deg < 0.06 and translation_mm < 15


def test_there_is_an_answer_before_the_drive_ends(answers: Answers) -> None:
    rotation_deg, translation_mm = worst_error(rig_of(answers[-2]), TRUTH)
    assert rotation_deg < 0.06 and translation_mm < 15


def test_it_says_that_it_knows_more_than_before(answers: Answers) -> None:
    first, last = answers[0].cameras["left_rear"], answers[-1].cameras["left_rear"]
    assert first.status is Status.INITIALISING and last.status is Status.CONVERGED
    assert (last.sigma < [0.1, 0.1, 0.1, 0.5, 0.5, 0.5] * first.sigma).all()
    assert first.inlier_count == 0 and last.inlier_count > 100


def test_it_says_where_its_metres_come_from_and_what_the_drive_has_shown(answers: Answers) -> None:
    first, last = answers[0], answers[-1]
    assert first.scale is None and not any(first.cameras["left_rear"].observed or ())
    assert last.scale is not None and last.scale.share[ROAD] > 0.5 and last.scale.sigma_percent < 1.0
    for camera in last.cameras.values():
        assert camera.observed is not None
        assert all(camera.observed) or camera.status is not Status.CONVERGED


def test_the_reference_stays_and_has_no_doubt(answers: Answers) -> None:
    for answer in answers:
        front = answer.cameras["front"]
        np.testing.assert_array_equal(front.ego_from_cam.matrix, TRUTH["front"].ego_from_cam.matrix)
        assert not front.covariance.any()


def test_the_path_is_in_metres_and_every_bundle_has_its_pose(answers: Answers) -> None:
    trajectory = dict(answers[-1].trajectory)
    assert sorted(trajectory) == [index * PERIOD_NS for index in range(len(PATH))]
    for index, true in enumerate(PATH):
        error = true.local(trajectory[index * PERIOD_NS])
        assert np.linalg.norm(error[:3]) < np.deg2rad(0.3) and np.linalg.norm(error[3:]) < 0.1


def test_matches_join_cameras_that_share_no_view(answers: Answers) -> None:
    matches = [match for answer in answers for match in answer.matches]
    later = [m for m in matches if {m.camera_a, m.camera_b} == {"left_front", "left_rear"}]
    assert len(later) > 10
    assert all(m.stamp_a_ns != m.stamp_b_ns for m in later)


def test_two_drives_give_the_same_bytes(bundles: list[FrameBundle], answers: Answers) -> None:
    assert as_bytes(drive(bundles)) == as_bytes(answers)


def test_missing_images_cost_little(bundles: list[FrameBundle]) -> None:
    missing = {3: "left_rear", 8: "left_front", 9: "left_front", 12: "left_rear"}
    rotation_deg, translation_mm = worst_error(rig_of(drive(without(bundles, missing))[-1]), TRUTH)
    assert rotation_deg < 0.3 and translation_mm < 50


def test_missing_images_of_the_reference_cost_little(bundles: list[FrameBundle]) -> None:
    missing = dict.fromkeys((0, 7, 8), "front")
    last = drive(without(bundles, missing))[-1]
    rotation_deg, translation_mm = worst_error(rig_of(last), TRUTH)
    assert rotation_deg < 0.3 and translation_mm < 50
    assert last.trajectory[0][0] == PERIOD_NS  # the place of the first bundle is unknown, and not said


def test_a_standing_car_learns_nothing_and_says_so(bundles: list[FrameBundle]) -> None:
    still = [FrameBundle(index * PERIOD_NS, bundles[0].images) for index in range(12)]
    last = drive(still)[-1]
    assert last.world_from_ego is None
    for name in NOMINAL.estimated_names:
        camera = last.cameras[name]
        assert camera.status is Status.INITIALISING
        np.testing.assert_array_equal(camera.ego_from_cam.matrix, NOMINAL[name].ego_from_cam.matrix)
        np.testing.assert_allclose(camera.covariance, NOMINAL.prior.covariance)


def test_bundles_without_any_image_and_no_bundles_at_all_are_no_error(bundles: list[FrameBundle]) -> None:
    assert drive([])[-1].cameras["left_rear"].status is Status.INITIALISING
    empty = [FrameBundle((3 + index) * PERIOD_NS, {}) for index in range(3)]
    last = drive([*bundles[:3], *empty])[-1]
    assert last.stamp_ns == 5 * PERIOD_NS and last.tracks_px["front"].shape == (0, 4)
