"""Scale and level from the road under a camera of known height."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.observations import Observations
from estimator.road import level_on_road, road_landmarks, road_scale
from estimator.scene import Scene
from estimator.se3 import SE3, Array
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import arc, left_side_rig

HEIGHT_M = 1.4


def road_and_facades(road: int, facades: int, seed: int = 0) -> Array:
    """Return points around a camera 1.4 m above the road: some on it, some spread over two facades."""
    rng = np.random.default_rng(seed)
    ground = np.column_stack([rng.uniform(3, 12, road), rng.uniform(-4, 4, road), np.full(road, -HEIGHT_M)])
    ground[:, 2] += 0.01 * rng.standard_normal(road)
    sides = np.where(rng.random(facades) < 0.5, -6.0, 6.0)
    walls = np.column_stack([rng.uniform(3, 15, facades), sides, rng.uniform(-HEIGHT_M, 6, facades)])
    return np.vstack([ground, walls])


@pytest.mark.parametrize("metres_per_unit", [0.2, 1.0, 7.0])
def test_the_road_is_found_among_the_facades_whatever_the_unit(metres_per_unit: float) -> None:
    scale = road_scale(road_and_facades(40, 200) / metres_per_unit, HEIGHT_M)
    assert scale is not None and abs(scale / metres_per_unit - 1) < 0.01


def test_without_points_below_the_camera_there_is_no_road() -> None:
    points = road_and_facades(40, 200)
    assert road_scale(points[points[:, 2] > 0], HEIGHT_M) is None
    assert road_scale(np.full((50, 3), np.nan), HEIGHT_M) is None


def test_a_handful_of_points_is_no_road() -> None:
    assert road_scale(road_and_facades(8, 0), HEIGHT_M) is None


def test_what_is_far_away_says_nothing_of_the_road() -> None:
    far = road_and_facades(40, 0) * [10.0, 10.0, 1.0]
    assert road_scale(far, HEIGHT_M) is None


def test_a_known_scale_keeps_a_lower_yard_from_being_the_road() -> None:
    yard = road_and_facades(120, 0, 1) * [1.0, 1.0, 1.3]
    points = np.vstack([road_and_facades(60, 50), yard])
    fooled, kept = road_scale(points, HEIGHT_M), road_scale(points, HEIGHT_M, 0.03)
    assert fooled is not None and fooled < 0.9
    assert kept is not None and abs(kept - 1) < 0.01


SCENE = known_scene(left_side_rig(), arc(1.0, 5), 40)
SEEN = sightings(SCENE)
SEEN = SEEN.select(SEEN.camera == 0)


def scaled(scene: Scene, scale: float) -> Scene:
    """Return the scene scaled about the first place of the reference camera; the rig keeps its size."""
    mount = scene.rig["front"].ego_from_cam
    origin = (scene.world_from_egos[0] @ mount).translation
    cams = [pose @ mount for pose in scene.world_from_egos]
    moved = [SE3(cam.rotation, origin + scale * (cam.translation - origin)) @ mount.inverse() for cam in cams]
    return replace(
        scene, world_from_egos=tuple(moved), points_world=origin + scale * (scene.points_world - origin)
    )


def tilted(scene: Scene, pitch_rad: float) -> Scene:
    """Return the scene as if the road fell away under a level car."""
    turn = SE3.exp(np.array([0.0, pitch_rad, 0.0, 0.0, 0.0, 0.0]))
    poses = tuple(turn @ pose for pose in scene.world_from_egos)
    return replace(scene, world_from_egos=poses, points_world=turn.apply(scene.points_world))


def path_m(scene: Scene) -> float:
    return float(np.linalg.norm((scene.world_from_egos[0].inverse() @ scene.world_from_egos[-1]).translation))


@pytest.mark.parametrize("scale", [0.5, 1.0, 3.0])
def test_a_scene_of_any_size_is_brought_to_metres(scale: float) -> None:
    result = level_on_road(scaled(SCENE, scale), SEEN)
    assert result is not None
    assert abs(path_m(result[0]) / path_m(SCENE) - 1) < 0.005
    assert result[0].rig is SCENE.rig


def test_a_tilted_scene_is_brought_level() -> None:
    result = level_on_road(tilted(SCENE, 0.02), SEEN)
    assert result is not None
    for pose, true in zip(result[0].world_from_egos, SCENE.world_from_egos, strict=True):
        np.testing.assert_allclose(pose.rotation[:, 2], true.rotation[:, 2], atol=0.002)
        assert abs(pose.translation[2]) < 0.02


def test_levelling_changes_no_sighting() -> None:
    result = level_on_road(scaled(tilted(SCENE, 0.02), 0.5), SEEN)
    assert result is not None
    np.testing.assert_allclose(result[0].residuals_px(SEEN), 0, atol=1e-6)


def test_the_landmarks_on_the_road_are_told() -> None:
    result = level_on_road(scaled(SCENE, 0.5), SEEN)
    assert result is not None
    assert result[1].sum() > 30
    assert np.mean(on_road(SCENE)[result[1]]) > 0.95


def test_without_a_road_the_scene_cannot_be_levelled() -> None:
    high = SEEN.select(SCENE.points_world[SEEN.landmark, 2] > 1.5)
    assert level_on_road(SCENE, high) is None


def test_road_landmarks_are_low_and_seen_from_near() -> None:
    chosen = road_landmarks(SCENE, SEEN, 0.05)
    assert chosen.sum() > 20 and on_road(SCENE)[chosen].all()
    assert not road_landmarks(SCENE, SEEN, 0.05, min_slope=5.0).any()
    assert not road_landmarks(SCENE, _none(SEEN), 0.05).any()


def _none(seen: Observations) -> Observations:
    return seen.select(np.zeros(len(seen), bool))
