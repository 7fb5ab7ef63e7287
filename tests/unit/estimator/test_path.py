"""The path: corrected at keyframes, unbroken between them."""

from __future__ import annotations

import numpy as np

from estimator.path import Path
from estimator.se3 import SE3
from tests.mounts import arc

OLD = arc(0.5, 9)
SHIFT = SE3.exp(np.array([0.01, 0.0, 0.1, 0.2, -0.1, 0.05]))


def path_of(poses: tuple[SE3, ...]) -> Path:
    path = Path()
    for stamp_ns, pose in enumerate(poses):
        path.append(stamp_ns, pose)
    return path


def assert_same(pose: SE3, wanted: SE3) -> None:
    np.testing.assert_allclose(pose.matrix, wanted.matrix, atol=1e-12)


def test_a_start_from_which_no_motion_was_found_is_forgotten() -> None:
    path = Path()
    path.begin(0, OLD[0])
    path.begin(3, OLD[0])
    path.append(4, OLD[1])
    path.begin(9, OLD[1])
    assert [stamp_ns for stamp_ns, _ in path.poses()] == [3, 4, 9]


def test_the_newest_pose_is_the_last_one() -> None:
    assert Path().newest is None
    assert path_of(OLD).newest is OLD[-1]


def test_guessed_bundles_lie_evenly_on_the_way_between_measured_ones() -> None:
    path = path_of(OLD[:2])
    for stamp_ns in (2, 3, 4):
        path.append(stamp_ns, OLD[stamp_ns] @ SHIFT, measured=False)
    assert_same(dict(path.poses())[4], OLD[4] @ SHIFT)
    path.append(5, OLD[5])
    path.append(6, OLD[6])
    for pose, wanted in zip(dict(path.poses()).values(), OLD, strict=False):
        assert_same(pose, wanted)


def test_keyframes_go_where_the_window_found_them() -> None:
    path = path_of(OLD)
    path.correct([2, 6], [SHIFT @ OLD[2], OLD[6]])
    poses = dict(path.poses())
    assert_same(poses[2], SHIFT @ OLD[2])
    assert_same(poses[6], OLD[6])


def test_a_correction_that_all_keyframes_share_keeps_the_steps_between() -> None:
    path = path_of(OLD)
    path.correct([0, 4, 8], [SHIFT @ OLD[index] for index in (0, 4, 8)])
    for (_, pose), old in zip(path.poses(), OLD, strict=True):
        assert_same(pose, SHIFT @ old)


def test_bundles_between_share_out_what_two_keyframes_differ_by() -> None:
    path = path_of(OLD)
    path.correct([0, 4], [OLD[0], SHIFT @ OLD[4]])
    poses = dict(path.poses())
    for index in range(5):
        assert_same(poses[index], SE3.exp(0.25 * index * SHIFT.log()) @ OLD[index])


def test_bundles_beyond_the_last_keyframe_move_along_and_those_before_the_first_stay() -> None:
    path = path_of(OLD)
    path.correct([2, 5], [OLD[2], SHIFT @ OLD[5]])
    poses = dict(path.poses())
    for index in (6, 7, 8):
        assert_same(poses[index], SHIFT @ OLD[index])
    assert_same(poses[1], OLD[1])


def test_the_next_window_leaves_alone_what_the_last_one_corrected() -> None:
    path = path_of(OLD)
    path.correct([0, 4], [OLD[0], SHIFT @ OLD[4]])
    before = dict(path.poses())
    path.correct([4, 8], [before[4], SHIFT @ before[8]])
    after = dict(path.poses())
    for index in range(5):
        assert_same(after[index], before[index])
    assert_same(after[8], SHIFT @ before[8])
