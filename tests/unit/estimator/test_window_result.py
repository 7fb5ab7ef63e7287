"""Whether a window is believed, and what it counts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.observations import Observations
from estimator.se3 import SE3
from estimator.window_result import ResultConfig, WindowResult, conclude
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig

CONFIG = ResultConfig(min_inliers=100)
SCENE = replace(known_scene(left_side_rig(), arc(1.0, 4)), stamps_ns=(0, 1, 2, 3))
SEEN = sightings(SCENE, noise_px=0.2)
COVARIANCE = 1e-6 * np.eye(12)


TRACKED = int(np.sum(~SEEN.handed_over))


def concluded(
    seen: Observations = SEEN, config: ResultConfig = CONFIG, tracked: int = TRACKED
) -> WindowResult | None:
    return conclude(SCENE, seen, COVARIANCE, tracked, config)


def test_sightings_that_agree_are_believed_and_counted() -> None:
    result = concluded()
    assert result is not None
    assert result.belief.rig is SCENE.rig and result.belief.covariance is COVARIANCE
    assert result.inlier_count == {
        name: int(np.sum(SEEN.camera == camera)) for camera, name in enumerate(SCENE.rig.cameras)
    }
    assert 0.1 < result.median_px < 0.4


def test_links_are_sightings_of_landmarks_that_two_cameras_share() -> None:
    fewer = SEEN.select((SEEN.landmark % 2 == 0) | ~SEEN.handed_over)
    result = concluded(fewer)
    assert result is not None
    for camera, name in enumerate(SCENE.rig.cameras):
        seen_here = fewer.landmark[fewer.camera == camera]
        shared = np.isin(seen_here, fewer.landmark[fewer.camera != camera])
        assert result.link_count[name] == shared.sum() < len(seen_here)


def test_a_scene_that_explains_a_chosen_few_of_the_tracks_is_not_believed() -> None:
    assert concluded(tracked=2 * TRACKED) is not None
    assert concluded(tracked=4 * TRACKED) is None


def test_too_few_sightings_are_not_believed() -> None:
    assert concluded(config=ResultConfig(min_inliers=len(SEEN) + 1)) is None


def test_sightings_that_disagree_are_not_believed_however_many_there_are() -> None:
    far = replace(SEEN, pixels=SEEN.pixels + np.random.default_rng(0).normal(0, 1.0, SEEN.pixels.shape))
    assert concluded(far) is None
    assert concluded(far, config=ResultConfig(min_inliers=100, max_median_px=5.0)) is not None


def test_an_outlier_takes_a_landmark_s_only_other_view_with_it() -> None:
    rank = np.array([np.sum(SEEN.landmark[:row] == SEEN.landmark[row]) for row in range(len(SEEN))])
    twice = SEEN.select(rank < 2)
    pixels = twice.pixels.copy()
    pixels[0] += 30.0
    result = concluded(replace(twice, pixels=pixels))
    assert result is not None
    assert sum(result.inlier_count.values()) == len(twice) - 2


def test_a_path_that_is_handed_from_window_to_window_keeps_its_rotations() -> None:
    bent = SE3(np.eye(3) + 1e-6 * np.ones((3, 3)), np.zeros(3))
    result = concluded()
    assert result is not None
    onwards = bent @ SE3.exp(np.array([0.0, 0.0, 0.1, 1.0, 0.0, 0.0]))
    result = replace(result, scene=replace(result.scene, world_from_egos=(bent, onwards)))
    for pose in result.path_from(bent):
        np.testing.assert_allclose(pose.rotation.T @ pose.rotation, np.eye(3), atol=1e-12)
