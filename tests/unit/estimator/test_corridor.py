"""Which landmarks are road: those under the car's path."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.corridor import in_corridor, low_landmarks, road_landmarks, seen_from_near
from estimator.corridor_config import CorridorConfig
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import arc, left_side_rig

SCENE = known_scene(left_side_rig(), arc(1.0, 6, 1 / 20), 40)
SEEN = sightings(SCENE)


def test_the_corridor_follows_the_bend() -> None:
    middle = SCENE.world_from_egos[5].apply(np.array([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0]]))
    assert in_corridor(SCENE, middle).tolist() == [True, True, False]
    straight_on = np.array([[5.0, -1.0, 0.0]])
    assert not in_corridor(SCENE, straight_on).any()


def test_the_corridor_ends_shortly_before_and_after_the_path() -> None:
    ahead = SCENE.world_from_egos[5].apply(np.array([[4.0, 0.0, 0.0], [6.0, 0.0, 0.0]]))
    behind = np.array([[-4.0, 0.0, 0.0], [-6.0, 0.0, 0.0]])
    assert in_corridor(SCENE, np.vstack([ahead, behind])).tolist() == [True, False, True, False]


def test_the_corridor_is_as_wide_and_long_as_the_car_is_said_to_be() -> None:
    lorry = replace(SCENE, corridor=CorridorConfig(half_width_m=2.5, beyond_ends_m=8.0, middle_m=3.0))
    ahead = SCENE.world_from_egos[5].apply(np.array([[0.0, 2.0, 0.0], [7.0, 0.0, 0.0]]))
    assert in_corridor(lorry, ahead).all() and not in_corridor(SCENE, ahead).any()


def test_an_unknown_point_is_not_in_the_corridor() -> None:
    assert not in_corridor(SCENE, np.full((2, 3), np.nan)).any()


def test_road_landmarks_are_low_and_under_the_path() -> None:
    chosen = road_landmarks(SCENE, SEEN, 0.05)
    assert chosen.sum() > 20
    assert on_road(SCENE)[chosen].all() and in_corridor(SCENE, SCENE.points_world[chosen]).all()


def test_low_landmarks_may_be_beside_the_path() -> None:
    low = low_landmarks(SCENE, SEEN, 0.05)
    assert (SCENE.points_world[low, 2] < 0.05).all()
    assert low.sum() > road_landmarks(SCENE, SEEN, 0.05).sum() + 20


def test_a_pavement_is_low_but_no_road() -> None:
    points = SCENE.points_world + np.array([0.0, 0.0, 0.12])
    raised = replace(SCENE, points_world=points)
    assert low_landmarks(raised, SEEN, 0.15).any()
    assert not road_landmarks(raised, SEEN, 0.08).any()


def test_only_what_was_seen_steeply_enough_counts() -> None:
    gentle, steep = seen_from_near(SCENE, SEEN, 0.1), seen_from_near(SCENE, SEEN, 0.5)
    assert steep.sum() > 10 and gentle.sum() > steep.sum() and not (steep & ~gentle).any()
    nothing = SEEN.select(np.zeros(len(SEEN), bool))
    assert not seen_from_near(SCENE, nothing).any()
