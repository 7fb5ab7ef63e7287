"""What clocks leave open is stated until the way the car moves has shown them."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.clock_doubt import ClockDoubt
from estimator.estimate import Status
from estimator.finding import FindingKind
from estimator.lens_config import LensConfig
from estimator.lens_watch import LensWatch
from estimator.window_config import WindowConfig
from tests.mounts import arc
from tests.watched_drives import BEND, LATE, NOMINAL, STRAIGHT, stated, watched

IN_STEP = LensConfig(clocks_in_step=True)
SOUND, LATE_ON_STRAIGHT = watched(STRAIGHT, STRAIGHT), watched(STRAIGHT, STRAIGHT, ahead_s=LATE)
SOUND_WITH_BEND = watched(STRAIGHT, BEND)


def off_in_sigmas(watch: LensWatch, name: str) -> float:
    camera = stated(watch)[name]
    error = camera.ego_from_cam.local(NOMINAL[name].ego_from_cam)
    return float(np.sqrt(error @ np.linalg.solve(camera.covariance, error) / 6))


@pytest.mark.parametrize("watch", [SOUND, LATE_ON_STRAIGHT])
def test_on_a_straight_no_camera_is_converged_as_its_clock_may_be_late(watch: LensWatch) -> None:
    for name in NOMINAL.estimated_names:
        camera = stated(watch)[name]
        assert camera.status is Status.WEAK and camera.weak_axes == ("forward",)


def test_a_camera_that_a_late_clock_moved_along_the_way_lies_within_what_is_stated() -> None:
    error = NOMINAL["left_rear"].ego_from_cam.local(LATE_ON_STRAIGHT.belief.rig["left_rear"].ego_from_cam)
    assert np.linalg.norm(error[3:]) > 0.08
    assert off_in_sigmas(LATE_ON_STRAIGHT, "left_rear") < 1.0


def test_a_late_clock_that_the_bend_shows_makes_its_camera_suspect_and_its_pose_as_unsure_as_it_is() -> None:
    watch = watched(STRAIGHT, BEND, ahead_s=LATE)
    assert stated(watch)["left_rear"].status is Status.SUSPECT
    assert off_in_sigmas(watch, "left_rear") < 1.5


def test_a_bend_shows_that_clocks_are_right_and_hardly_widens_what_is_stated() -> None:
    in_step = watched(STRAIGHT, BEND, config=IN_STEP)
    for name, camera in stated(SOUND_WITH_BEND).items():
        assert camera.status is Status.CONVERGED and camera.weak_axes == ()
        assert (camera.sigma[3:] < stated(in_step)[name].sigma[3:] + 0.002).all()


def test_on_one_steady_bend_a_late_clock_looks_like_a_turned_mount_too() -> None:
    assert {"yaw", "forward"} <= set(stated(watched(BEND))["left_rear"].weak_axes)


def test_clocks_that_are_said_to_be_in_step_leave_nothing_open() -> None:
    watch = watched(STRAIGHT, STRAIGHT, config=IN_STEP)
    assert {camera.status for camera in stated(watch).values()} == {Status.CONVERGED}
    assert not watch.doubt.covariance.any() and not watch.doubt.hidden.any()


def test_a_late_clock_is_told_even_where_clocks_were_said_to_be_in_step() -> None:
    (finding,) = watched(STRAIGHT, BEND, ahead_s=LATE, config=IN_STEP).findings
    assert finding.kind is FindingKind.CLOCK_OFFSET


def test_another_speed_shows_clocks_as_a_bend_does() -> None:
    slower = arc(0.5, 9, 0.0)
    assert stated(watched(STRAIGHT, slower))["left_rear"].status is Status.CONVERGED


def test_before_the_first_window_anything_is_open_and_nothing_is_added() -> None:
    doubt = LensWatch(NOMINAL, LensConfig(), WindowConfig(), "none").doubt
    assert np.diag(doubt.hidden).min() > 1.0 and not doubt.covariance.any()
    assert not ClockDoubt.none(NOMINAL).hidden.any()


def test_a_corrected_clock_is_not_counted_twice() -> None:
    corrected = watched(STRAIGHT, BEND, ahead_s=LATE, refine="clocks")
    assert np.sqrt(np.diag(corrected.doubt.covariance)).max() < 0.001
    assert stated(corrected)["left_rear"].status is Status.CONVERGED
