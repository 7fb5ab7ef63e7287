"""Tracks of keyframes become landmarks."""

from __future__ import annotations

import numpy as np

from estimator.keyframe import Keyframe, gather_observations
from estimator.observations import Observations
from estimator.se3 import SE3
from tests.mounts import left_side_rig

RIG = left_side_rig()


def keyframe(**ids: list[int]) -> Keyframe:
    """Return a keyframe whose cameras hold tracks; a track's pixel is (its id, 0)."""
    tracks = {name: (np.array(i), np.column_stack([i, np.zeros(len(i))])) for name, i in ids.items()}
    return Keyframe(0, {}, SE3(), tracks)


def gathered() -> Observations:
    keyframes = [keyframe(front=[3, 5], left_front=[3]), keyframe(front=[5, 9], left_rear=[3])]
    return gather_observations(keyframes, RIG, 0.5)


def test_a_track_is_one_landmark_through_all_keyframes() -> None:
    seen = gathered()
    of_five = seen.select((seen.camera == 0) & (seen.pixels[:, 0] == 5))
    assert len(set(of_five.landmark.tolist())) == 1 and of_five.keyframe.tolist() == [0, 1]


def test_equal_ids_of_two_cameras_are_two_landmarks() -> None:
    seen = gathered()
    of_three = seen.select(seen.pixels[:, 0] == 3)
    assert of_three.camera.tolist() == [0, 1, 2] and len(set(of_three.landmark.tolist())) == 3


def test_landmarks_are_numbered_without_gaps() -> None:
    seen = gathered()
    assert sorted(set(seen.landmark.tolist())) == list(range(5))
    assert (seen.sigma_px == 0.5).all() and not seen.handed_over.any()


def test_only_landmarks_of_enough_views_are_kept() -> None:
    often = gathered().of_enough_views(2)
    assert often.pixels[:, 0].tolist() == [5, 5]
    assert len(often.of_enough_views(3)) == 0 and len(often.of_enough_views(3).of_enough_views(2)) == 0


def test_joining_is_one_after_the_other() -> None:
    seen = gathered()
    both = seen.join(seen.select(np.array([0])))
    assert len(both) == len(seen) + 1
    np.testing.assert_array_equal(both.pixels[-1], seen.pixels[0])
