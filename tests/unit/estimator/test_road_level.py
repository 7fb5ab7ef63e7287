"""A window's scene, put on the road: at its scale, level, the road at z = 0."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from estimator.factors import GraphConfig
from estimator.road_level import level_on_road, rescale_on_road
from estimator.scene import Scene
from estimator.se3 import SE3
from estimator.stance import StanceConfig
from tests.known_scene import known_scene, on_road, sightings
from tests.mounts import arc, left_side_rig

SCENE = known_scene(left_side_rig(), arc(1.0, 5), 40)
ALL_SEEN = sightings(SCENE)
SEEN = ALL_SEEN.select(ALL_SEEN.camera == 0)


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
    result = level_on_road(scaled(SCENE, scale), SEEN, GraphConfig())
    assert result is not None
    assert abs(path_m(result[0]) / path_m(SCENE) - 1) < 0.005
    assert result[0].rig is SCENE.rig


def test_a_tilted_scene_is_brought_level() -> None:
    result = level_on_road(tilted(SCENE, 0.02), SEEN, GraphConfig())
    assert result is not None
    for pose, true in zip(result[0].world_from_egos, SCENE.world_from_egos, strict=True):
        np.testing.assert_allclose(pose.rotation[:, 2], true.rotation[:, 2], atol=0.002)
        assert abs(pose.translation[2]) < 0.02


def test_a_stance_that_is_known_for_sure_leaves_the_car_as_it_stands() -> None:
    sure = GraphConfig(stance=StanceConfig(height_sigma_m=1e-5, tilt_sigma_rad=1e-5))
    nodding = replace(SCENE, points_world=tilted(SCENE, 0.02).points_world)  # under a level car
    free, held = (level_on_road(nodding, SEEN, beliefs) for beliefs in (GraphConfig(), sure))
    assert free is not None and held is not None
    pitch = [np.arcsin(result[0].world_from_egos[0].rotation[2, 0]) for result in (free, held)]
    assert abs(pitch[1]) < 1e-3 < 0.004 < abs(pitch[0] - pitch[1])


def test_levelling_changes_no_sighting() -> None:
    result = level_on_road(scaled(tilted(SCENE, 0.02), 0.5), SEEN, GraphConfig())
    assert result is not None
    np.testing.assert_allclose(result[0].residuals_px(SEEN), 0, atol=1e-6)


def test_the_landmarks_on_the_road_are_told() -> None:
    result = level_on_road(scaled(SCENE, 0.5), SEEN, GraphConfig())
    assert result is not None
    assert result[1].sum() > 20
    assert np.mean(on_road(SCENE)[result[1]]) > 0.95


def test_without_a_road_the_scene_cannot_be_levelled() -> None:
    high = SEEN.select(SCENE.points_world[SEEN.landmark, 2] > 1.5)
    assert level_on_road(SCENE, high, GraphConfig()) is None


def with_rig_scaled(scene: Scene, scale: float) -> Scene:
    """Return the scene with its rig too scaled about the reference camera, so that no sighting changes."""
    front = scene.rig["front"].ego_from_cam.translation
    larger = {}
    for name in scene.rig.estimated_names:
        pose = scene.rig[name].ego_from_cam
        larger[name] = SE3(pose.rotation, front + scale * (pose.translation - front))
    return replace(scaled(scene, scale), rig=scene.rig.with_extrinsics(larger))


@pytest.mark.parametrize("scale", [0.96, 1.0, 1.05])
def test_a_level_scene_is_rescaled_with_its_rig(scale: float) -> None:
    found = rescale_on_road(with_rig_scaled(SCENE, scale), ALL_SEEN, np.inf)
    assert abs(path_m(found) / path_m(SCENE) - 1) < 0.003
    for name in SCENE.rig.cameras:
        error_m = found.rig[name].ego_from_cam.translation - SCENE.rig[name].ego_from_cam.translation
        assert np.linalg.norm(error_m) < 0.006
    assert np.median(np.abs(found.points_world[on_road(SCENE), 2])) < 0.005


def test_rescaling_changes_no_sighting() -> None:
    found = rescale_on_road(with_rig_scaled(SCENE, 0.96), ALL_SEEN, np.inf)
    np.testing.assert_allclose(found.residuals_px(ALL_SEEN), 0, atol=1e-6)


def test_where_no_road_is_seen_nothing_is_rescaled() -> None:
    high = ALL_SEEN.select(SCENE.points_world[ALL_SEEN.landmark, 2] > 1.5)
    assert rescale_on_road(SCENE, high, np.inf) is SCENE
