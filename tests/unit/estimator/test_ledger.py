"""What is stated of a camera: its status follows the windows' evidence, and what was noticed goes before."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.clock_doubt import ClockDoubt
from estimator.estimate import Status
from estimator.finding import Finding, FindingKind
from estimator.ledger import Ledger, LedgerConfig
from estimator.off_nominal import OffNominal
from estimator.window_result import ResultConfig, WindowResult, conclude
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig

RIG = left_side_rig()
SCENE = replace(known_scene(RIG, arc(1.0, 10)), stamps_ns=tuple(range(10)))
SEEN = sightings(SCENE, noise_px=0.1)
TRACKED = int(np.sum(~SEEN.handed_over))
SURE = Belief(RIG, 1e-8 * np.eye(12))
IN_STEP = ClockDoubt.none(RIG)
NOBODY_MISSED = dict.fromkeys(RIG.cameras, 0)
LIMITS = ResultConfig(min_inliers=50)
SWAPPED = Finding(FindingKind.SWAPPED_CAMERAS, ("left_rear", "front"), "the two are swapped")


def window() -> WindowResult:
    result = conclude(SCENE, SEEN, SURE.covariance, TRACKED, LIMITS)
    assert result is not None
    return result


def statuses(ledger: Ledger, *findings: Finding, missed: dict[str, int] = NOBODY_MISSED) -> dict[str, Status]:
    return {name: c.status for name, c in ledger.cameras(SURE, missed, findings, {}, IN_STEP).items()}


def filled() -> Ledger:
    ledger = Ledger(RIG, LedgerConfig(), OffNominal())
    ledger.add(window())
    return ledger


def test_before_the_first_window_nothing_is_known_and_nothing_is_added_to_the_prior() -> None:
    ledger = Ledger(RIG, LedgerConfig(), OffNominal())
    assert ledger.is_empty and ledger.scale() is None
    assert statuses(ledger) == dict.fromkeys(RIG.cameras, Status.INITIALISING)
    cameras = ledger.cameras(SURE, NOBODY_MISSED, (), {}, IN_STEP)
    np.testing.assert_array_equal(cameras["left_rear"].covariance, SURE.camera_covariance("left_rear"))


def test_a_window_makes_sure_cameras_converged_and_states_the_shared_error_of_scale() -> None:
    ledger = filled()
    assert statuses(ledger) == dict.fromkeys(RIG.cameras, Status.CONVERGED)
    stated = ledger.cameras(SURE, NOBODY_MISSED, (), {}, IN_STEP)["left_rear"].covariance
    assert np.trace(stated[3:, 3:]) > np.trace(SURE.camera_covariance("left_rear")[3:, 3:])


def test_a_camera_in_doubt_is_suspect_and_a_doubted_reference_makes_all_so() -> None:
    own = Finding(FindingKind.CLOCK_OFFSET, ("left_rear",), "its clock is late")
    assert statuses(filled(), own)["left_rear"] is Status.SUSPECT
    assert statuses(filled(), own)["left_front"] is Status.CONVERGED
    assert set(statuses(filled(), SWAPPED).values()) == {Status.SUSPECT}


def test_a_wrong_lens_makes_its_neighbours_weak_until_it_is_corrected() -> None:
    wrong = Finding(FindingKind.WRONG_INTRINSICS, ("left_rear",), "its lens is another")
    assert statuses(filled(), wrong)["left_front"] is Status.WEAK
    assert statuses(filled(), replace(wrong, doubtful=False))["left_front"] is Status.CONVERGED


def test_a_camera_that_went_silent_is_lost_whatever_was_noticed() -> None:
    missed = NOBODY_MISSED | {"left_rear": 50}
    assert statuses(filled(), SWAPPED, missed=missed)["left_rear"] is Status.LOST


def test_a_reference_that_went_silent_is_lost_like_any_other() -> None:
    missed = NOBODY_MISSED | {"front": 50}
    assert statuses(filled(), missed=missed) == dict.fromkeys(RIG.cameras, Status.CONVERGED) | {
        "front": Status.LOST
    }


def test_sightings_add_up_over_windows() -> None:
    once, twice = filled(), filled()
    twice.add(window())
    counts = [
        each.cameras(SURE, NOBODY_MISSED, (), {}, IN_STEP)["left_front"].inlier_count
        for each in (once, twice)
    ]
    assert counts[1] == 2 * counts[0] > 0


def test_a_camera_that_moved_is_told_so_until_it_is_known_again() -> None:
    moved = Finding(FindingKind.MOVED_CAMERA, ("left_rear",), "it moved", doubtful=False)
    ledger = filled()
    assert statuses(ledger, moved)["left_rear"] is Status.CONVERGED
    ledger.forget(["left_rear"])
    assert statuses(ledger, moved)["left_rear"] is Status.MOVED
    assert statuses(ledger, moved)["left_front"] is Status.CONVERGED
    ledger.add(window())
    assert statuses(ledger, moved)["left_rear"] is Status.CONVERGED
