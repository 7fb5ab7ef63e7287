"""The report of runs that lack something: no page breaks on what an estimator or a recording leaves out."""

import json
from collections.abc import Mapping

import numpy as np
import pytest

from estimator.bundle import FrameBundle
from estimator.estimate import CameraEstimate, Estimate, Status
from estimator.rig import Rig
from estimator.se3 import SE3
from eval.collect import RunLog
from eval.header import RunHeader
from eval.report import render
from eval.report_data import report_data
from eval.report_tables import number_text
from eval.run_folder import scores_json
from eval.scores import score
from eval.truth import TruthTrack
from tests.unit.eval.tiny_run import RIG, START_NS, TRUE_POSES, run_log, straight, truth_of

HEADER = RunHeader("bare", None, None, "bare")
LOST = SE3(np.full((3, 3), np.nan), np.full(3, np.nan))


def page(log: RunLog, truth: TruthTrack | None) -> str:
    scores = json.loads(json.dumps(scores_json(score(log, truth), HEADER), allow_nan=False))
    return render(scores, json.loads(json.dumps(report_data(log, HEADER, truth), allow_nan=False)))


def bare_log(cameras: Mapping[str, CameraEstimate], rig: Rig = RIG, count: int = 1) -> RunLog:
    """Return a run whose estimator tells nothing but poses, on bundles without images."""
    log = RunLog(rig)
    for index in range(count):
        log.add(FrameBundle(START_NS + index, {}), Estimate(START_NS + index, cameras))
    log.finish(Estimate(START_NS + count - 1, cameras))
    return log


def estimates(pose: SE3, covariance: np.ndarray) -> dict[str, CameraEstimate]:
    return {name: CameraEstimate(pose, covariance, Status.LOST) for name in RIG.cameras}


@pytest.mark.parametrize("truth", [None, truth_of(straight(3))], ids=["no truth", "truth"])
@pytest.mark.parametrize(
    "cameras",
    [{}, estimates(LOST, np.full((6, 6), np.nan)), estimates(SE3(), np.zeros((6, 6)))],
    ids=["no answer", "not a number", "no covariance"],
)
def test_an_estimator_that_says_next_to_nothing_still_gets_a_page(cameras, truth):
    text = page(bare_log(cameras), truth)
    assert "reported no stage times" in text
    assert "reported no match" in text
    assert "cameras were found" in text if truth else "nothing here can check it" in text


def test_a_lost_camera_is_not_called_found_and_its_number_is_unknown():
    text = page(bare_log(estimates(LOST, np.full((6, 6), np.nan))), truth_of(straight(3)))
    assert "0 of 2 cameras were found" in text
    assert "unknown" in text


def test_a_lost_reference_is_marked_like_any_other():
    text = page(bare_log(estimates(SE3(), np.eye(6))), None)
    assert text.count('class="pill lost"') == len(RIG.cameras)


def test_a_rig_of_the_reference_alone_has_a_page():
    alone = Rig("front", {"front": RIG["front"]})
    assert "no camera but the reference" in page(bare_log({}, alone), None)


def test_truth_that_lacks_a_camera_leaves_its_curve_empty():
    path = straight(4)
    full = truth_of(path)
    poses = {name: pose for name, pose in TRUE_POSES.items() if name != "rear"}
    truth = TruthTrack(full.stamps_ns, full.world_from_ego, [(0, poses)])
    curves = report_data(run_log(path), HEADER, truth)["series"]["cameras"]
    assert curves["rear"]["rotation_deg"] == [None] * 4
    assert len(curves["left"]["rotation_deg"]) == 4


@pytest.mark.parametrize(
    ("value", "text"), [(None, "—"), (3.0, "3"), (0.123456, "0.1235"), (123456.7, "123457"), (0.0, "0")]
)
def test_numbers_are_written_for_people(value, text):
    assert number_text(value) == text
