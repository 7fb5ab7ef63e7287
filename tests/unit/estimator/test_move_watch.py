"""Windows against what was known before them: who is accused of having moved, and who is not."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.finding import FindingKind
from estimator.move_watch import MoveWatch, MoveWatchConfig
from estimator.se3 import SE3
from estimator.window_config import WindowConfig
from estimator.window_result import ResultConfig, WindowResult, conclude
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig

RIG = left_side_rig()
SCENE = replace(known_scene(RIG, arc(1.0, 10)), stamps_ns=tuple(100_000_000 * k for k in range(10)))
SEEN = sightings(SCENE, noise_px=0.1)
WINDOW = WindowConfig(result=ResultConfig(min_inliers=50))
KNOCK = SE3.exp(np.array([0.0, 0.008, 0.0, 0.01, 0.0, 0.0]))
NOBODY: frozenset[str] = frozenset()


def known(*knocked: str) -> Belief:
    """Return what was known before cameras were knocked to where the scene has them."""
    before = {name: RIG[name].ego_from_cam @ KNOCK.inverse() for name in knocked}
    return Belief(RIG.with_extrinsics(before), 1e-7 * np.eye(12))


def window() -> WindowResult:
    tracked = int(np.sum(~SEEN.handed_over))
    result = conclude(SCENE, SEEN, 1e-7 * np.eye(12), tracked, WINDOW.result)
    assert result is not None
    return result


def watch() -> MoveWatch:
    return MoveWatch(MoveWatchConfig(), WINDOW, 0.002)


def test_a_window_that_agrees_changes_nothing() -> None:
    watching, result = watch(), window()
    assert watching.examine(known(), result, NOBODY).result is result
    assert not watching.in_doubt and not list(watching.findings())


def test_a_camera_that_two_windows_put_elsewhere_has_moved() -> None:
    watching, before = watch(), known("left_rear")
    first = watching.examine(before, window(), NOBODY)
    assert watching.in_doubt == {"left_rear"} and not first.moved
    kept = first.result.belief.rig["left_rear"].ego_from_cam
    np.testing.assert_array_equal(kept.matrix, before.rig["left_rear"].ego_from_cam.matrix)
    second = watching.examine(before, window(), NOBODY)
    assert second.moved == {"left_rear"} and not watching.in_doubt
    off = second.result.belief.rig["left_rear"].ego_from_cam.local(RIG["left_rear"].ego_from_cam)
    assert np.linalg.norm(off[:3]) < 5e-4 and np.linalg.norm(off[3:]) < 0.005
    assert [finding.kind for finding in watching.findings()] == [FindingKind.MOVED_CAMERA]


def test_a_doubt_that_the_next_window_does_not_share_is_dropped() -> None:
    watching = watch()
    watching.examine(known("left_rear"), window(), NOBODY)
    assert [finding.kind for finding in watching.findings()] == [FindingKind.CONTRADICTED]
    assert not watching.examine(known(), window(), NOBODY).moved and not list(watching.findings())


def test_most_cameras_at_once_speak_against_the_reference() -> None:
    watching, result = watch(), window()
    assert watching.examine(known("left_front", "left_rear"), result, NOBODY).result is result
    assert [finding.cameras for finding in watching.findings()] == [("front",)]


def test_a_camera_whose_lens_or_clock_is_blamed_is_not_said_to_have_moved() -> None:
    watching, result = watch(), window()
    assert watching.examine(known("left_rear"), result, frozenset(["left_rear"])).result is result
    assert not list(watching.findings())


def test_while_next_to_nothing_is_known_nothing_can_be_contradicted() -> None:
    watching, result = watch(), window()
    assert watching.examine(Belief.nominal(RIG), result, NOBODY).result is result
