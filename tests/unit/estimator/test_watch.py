"""What the watches of common views, of the prior and of whole answers say."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.belief import Belief
from estimator.bundle import FrameBundle
from estimator.common_view import CommonViewConfig, CommonViewWatch
from estimator.estimate import Match
from estimator.finding import Finding, FindingKind
from estimator.keyframe import Keyframe
from estimator.off_nominal import OffNominal
from estimator.prior_watch import PriorWatch, PriorWatchConfig
from estimator.rig import Rig, RigPrior
from estimator.road import densest_scale
from estimator.se3 import SE3
from estimator.soundness import is_sound
from estimator.unsolved_watch import UnsolvedWatch, UnsolvedWatchConfig
from estimator.watch import Watch, WatchConfig, doubted
from estimator.window_result import WindowResult
from tests.known_scene import known_scene, sightings
from tests.mounts import PINHOLE, arc, left_side_rig, mounted

RIG = Rig("front", {**left_side_rig().cameras, "second": mounted(PINHOLE, (1.7, -0.3, 1.4), 0.0, 8.0)})
SCENE = known_scene(RIG, arc(1.0, 3))
SEEN = dict.fromkeys(RIG.cameras, 1000)


def matches(a: str, b: str, count: int) -> list[Match]:
    return [Match(a, k, (0.0, 0.0), b, k, (1.0, 1.0)) for k in range(count)]


def moved(degrees: float, metres: float) -> Belief:
    """Return a belief in which one camera is so far from the rig file."""
    pose = RIG["left_rear"].ego_from_cam.retract(np.array([np.deg2rad(degrees), 0, 0, metres, 0, 0]))
    return Belief(RIG.with_extrinsics({"left_rear": pose}), np.eye(18) * 1e-6)


def after_windows(*beliefs: Belief) -> list[Finding]:
    watch = PriorWatch(RIG, PriorWatchConfig(), OffNominal())
    before = Belief.nominal(RIG)
    for belief in beliefs:
        watch.see(before, belief)
        before = belief
    return list(watch.findings())


def test_two_cameras_that_look_alike_must_share_landmarks() -> None:
    watch = CommonViewWatch(RIG, CommonViewConfig())
    watch.see(matches("second", "front", 3), SEEN)
    (finding,) = watch.findings()
    assert finding.cameras == ("front", "second") and finding.doubtful and "recognise 3" in finding.about
    watch.see(matches("second", "front", 60), SEEN)
    assert list(watch.findings()) == []


def test_a_window_in_which_a_camera_saw_little_says_nothing_of_common_views() -> None:
    watch = CommonViewWatch(RIG, CommonViewConfig())
    watch.see([], SEEN | {"second": 20})
    assert list(watch.findings()) == []


def test_an_answer_near_the_rig_file_is_no_finding() -> None:
    assert after_windows(moved(2.0, 0.05)) == []


def test_one_that_the_prior_rules_out_is_in_doubt_until_windows_agree_on_it() -> None:
    far = moved(10.0, 0.3)
    (first,) = after_windows(far)
    assert first.kind is FindingKind.NOMINAL_REJECTED and first.doubtful
    (later,) = after_windows(far, far, moved(10.05, 0.301))
    assert not later.doubtful and "10.1 deg and 301 mm" in later.about


def test_one_that_every_window_sees_elsewhere_stays_in_doubt() -> None:
    (finding,) = after_windows(moved(10.0, 0.3), moved(11.0, 0.3), moved(10.0, 0.2), moved(9.0, 0.3))
    assert finding.doubtful


def test_one_beyond_a_wide_limit_stays_in_doubt_however_many_windows_agree() -> None:
    (finding,) = after_windows(*[moved(40.0, 0.0)] * 5)
    assert finding.doubtful and "too far" in finding.about


def test_a_doubtful_reference_puts_every_camera_in_doubt() -> None:
    of_rear = Finding(FindingKind.SWAPPED_CAMERAS, ("left_rear", "left_front"), "")
    assert doubted([of_rear, replace(of_rear, cameras=("second",), doubtful=False)], RIG) == {
        "left_rear",
        "left_front",
    }
    assert doubted([replace(of_rear, cameras=("front",))], RIG) == set(RIG.cameras)


def test_a_bundle_that_is_not_newer_is_not_admitted() -> None:
    watch = Watch(RIG, WatchConfig(), OffNominal())
    assert watch.admit(FrameBundle(5, {})) is not None
    assert watch.admit(FrameBundle(5, {})) is None and watch.admit(FrameBundle(4, {})) is None
    assert watch.admit(FrameBundle(6, {})) is not None


def test_a_prior_of_nothing_or_everything_stays_within_what_numbers_bear() -> None:
    for prior in (RigPrior(0.0, 0.0), RigPrior(1e9, 1e12)):
        belief = Belief.nominal(replace(RIG, prior=prior))
        assert np.isfinite(np.linalg.inv(belief.covariance)).all()
    usual = Belief.nominal(RIG)
    np.testing.assert_allclose(usual.camera_covariance("second"), RIG.prior.covariance)


def test_a_camera_in_the_road_gives_no_scale() -> None:
    depths = np.full(50, 1.4)
    for height_m in (0.0, -1.0, float("nan")):
        assert densest_scale(depths, np.ones(50), height_m, 0.03, np.inf) is None


def test_numbers_that_are_none_and_covariances_that_are_none_are_unsound() -> None:
    good = WindowResult(moved(0.0, 0.0), {}, {}, 0.1, (), SCENE, sightings(SCENE), 0)
    assert is_sound(good)
    assert not is_sound(replace(good, scene=replace(SCENE, world_from_egos=(SE3(np.full((3, 3), np.nan)),))))
    for covariance in (np.full((18, 18), np.nan), -np.eye(18)):
        assert not is_sound(replace(good, belief=Belief(RIG, covariance)))


def test_windows_that_cannot_be_solved_are_told_until_one_can() -> None:
    watch = UnsolvedWatch("front", UnsolvedWatchConfig())
    window = [Keyframe(k, {}, pose, {}) for k, pose in enumerate(arc(1.0, 11))]
    for _ in range(2):
        watch.see(window, solved=False)
    assert list(watch.findings()) == []
    watch.see(window, solved=False)
    (finding,) = watch.findings()
    assert finding.cameras == ("front",) and not finding.doubtful and "3 windows (30 m)" in finding.about
    watch.see(window, solved=True)
    assert list(watch.findings()) == []
