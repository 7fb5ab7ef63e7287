"""What sightings say of a landmark's place, and which leave its depth open."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.landmark_information import indeterminate_landmarks, landmark_information
from estimator.loss import Loss
from estimator.observations import Observations
from tests.known_scene import SIGMA_PX, known_scene, sightings
from tests.mounts import arc, left_side_rig

SCENE = known_scene(left_side_rig(), arc(1.0, 4))
SEEN = sightings(SCENE)
LOSS = Loss(1.0)


def seen_twice() -> Observations:
    """Return the first two sightings of every landmark."""
    rank = np.array([np.sum(SEEN.landmark[:row] == SEEN.landmark[row]) for row in range(len(SEEN))])
    return SEEN.select(rank < 2)


def test_one_ray_says_nothing_along_itself_and_its_angle_across() -> None:
    row = SEEN.select(np.array([0]))
    _, center = SCENE.pose_arrays(row.camera, row.keyframe)
    towards = SCENE.points_world[row.landmark[0]] - center[0]
    information = landmark_information(SCENE, row, LOSS)[row.landmark[0]]
    np.testing.assert_allclose(information @ towards, 0, atol=1e-6)
    focal_px = 180.0
    wanted = (focal_px / SIGMA_PX / np.linalg.norm(towards)) ** 2
    np.testing.assert_allclose(np.linalg.eigvalsh(information)[1:], wanted)


def test_sightings_from_several_places_leave_nothing_open() -> None:
    assert not indeterminate_landmarks(SCENE, SEEN, LOSS).any()


def test_a_landmark_whose_other_sighting_is_wrong_is_open_in_depth() -> None:
    pixels = seen_twice().pixels.copy()
    last = np.flatnonzero(seen_twice().landmark == SEEN.landmark[0])[1]
    pixels[last] += 1000.0
    wrong = replace(seen_twice(), pixels=pixels)
    assert np.flatnonzero(indeterminate_landmarks(SCENE, wrong, LOSS)).tolist() == [SEEN.landmark[0]]


def test_a_landmark_that_nobody_sees_is_not_counted() -> None:
    assert not indeterminate_landmarks(SCENE, SEEN.select(np.zeros(len(SEEN), bool)), LOSS).any()
