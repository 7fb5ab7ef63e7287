"""A scene predicts what its cameras see, and intersects what they saw."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tests.known_scene import known_scene, sightings
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig, shaken

SCENE = known_scene(left_side_rig(PINHOLE, BROWN, FISHEYE), arc(1.0, 4))
SEEN = sightings(SCENE)


def test_the_pose_of_a_camera_is_the_car_s_times_the_mount_s() -> None:
    wanted = SCENE.world_from_egos[2] @ SCENE.rig["left_rear"].ego_from_cam
    np.testing.assert_allclose(SCENE.camera_pose(2, 2).matrix, wanted.matrix)
    rotation, translation = SCENE.pose_arrays(np.array([0, 2]), np.array([1, 2]))
    np.testing.assert_allclose(rotation[1], wanted.rotation)
    np.testing.assert_allclose(translation[1], wanted.translation)


def test_every_camera_predicts_with_its_own_lens() -> None:
    for camera, mounted in enumerate(SCENE.rig.cameras.values()):
        mine = SEEN.select(SEEN.camera == camera)
        points = SCENE.points_world[mine.landmark[:1]]
        points_cam = SCENE.camera_pose(camera, int(mine.keyframe[0])).inverse().apply(points)
        predicted = SCENE.predict(mine.camera[:1], mine.keyframe[:1], points)
        np.testing.assert_allclose(predicted, mounted.camera.project(points_cam), atol=1e-9)


def test_rays_and_points_agree() -> None:
    rays = SCENE.unproject(SEEN.camera, SEEN.pixels)
    np.testing.assert_allclose(SCENE.project(SEEN.camera, 7 * rays), SEEN.pixels, atol=1e-6)


def test_exact_sightings_have_no_residual_and_shifted_ones_have_theirs() -> None:
    np.testing.assert_allclose(SCENE.residuals_px(SEEN), 0, atol=1e-9)
    shifted = replace(SEEN, pixels=SEEN.pixels + np.array([3.0, -4.0]))
    np.testing.assert_allclose(SCENE.residuals_px(shifted), 5, atol=1e-9)


def test_a_point_behind_the_camera_has_no_prediction() -> None:
    behind = SCENE.camera_pose(0, 0).apply(np.array([[0.0, 0.0, -5.0]]))
    assert np.isnan(SCENE.predict(np.array([0]), np.array([0]), behind)).all()


def test_only_the_wanted_landmarks_are_intersected_anew() -> None:
    wanted = np.arange(len(SCENE.points_world)) % 2 == 0
    moved = replace(SCENE, points_world=SCENE.points_world + 0.5).with_triangulated(SEEN, wanted)
    found = wanted & np.isfinite(moved.points_world[:, 0])
    assert found.sum() > 30
    np.testing.assert_allclose(moved.points_world[found], SCENE.points_world[found], atol=1e-6)
    np.testing.assert_allclose(moved.points_world[~wanted], SCENE.points_world[~wanted] + 0.5)


def test_landmarks_seen_from_one_place_stay_unknown() -> None:
    still = SEEN.select((SEEN.keyframe == 0) & (SEEN.camera == 0))
    everything = np.ones(len(SCENE.points_world), bool)
    assert np.isnan(SCENE.with_triangulated(still, everything).points_world).all()


def test_landmarks_seen_from_almost_one_place_stay_unknown() -> None:
    creeping = known_scene(SCENE.rig, arc(0.005, 4))
    seen = sightings(creeping)
    of_front = seen.select(seen.camera == 0)
    everything = np.ones(len(creeping.points_world), bool)
    assert np.isnan(creeping.with_triangulated(of_front, everything).points_world).all()


def test_a_camera_that_is_off_shows_in_its_own_residuals_alone() -> None:
    error_px = replace(SCENE, rig=shaken(SCENE.rig, 2.0, 0.0)).residuals_px(SEEN)
    assert np.nanmax(error_px[SEEN.camera == 0]) < 1e-6
    assert np.nanmedian(error_px[SEEN.camera == 1]) > 1.0
