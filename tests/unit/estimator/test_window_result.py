"""Whether a window is believed, and what it counts."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.window_result import ResultConfig, WindowResult, conclude
from tests.known_scene import known_scene, sightings
from tests.mounts import arc, left_side_rig, shaken

CONFIG = ResultConfig(min_inliers=100)
SCENE = known_scene(left_side_rig(), arc(1.0, 4))
SEEN = sightings(SCENE, noise_px=0.2)
COVARIANCE = 1e-6 * np.eye(12)


def concluded(seen=SEEN, scene=SCENE, config: ResultConfig = CONFIG) -> WindowResult | None:
    return conclude(scene, seen, COVARIANCE, [0, 1, 2, 3], config)


def test_sightings_that_agree_are_believed_and_counted() -> None:
    result = concluded()
    assert result is not None
    assert result.belief.rig is SCENE.rig and result.belief.covariance is COVARIANCE
    assert result.inlier_count == {
        name: int(np.sum(SEEN.camera == camera)) for camera, name in enumerate(SCENE.rig.cameras)
    }
    assert 0.1 < result.median_px < 0.4


def test_links_are_sightings_of_landmarks_that_two_cameras_share() -> None:
    alone = SEEN.select((SEEN.camera == 2) | (SEEN.landmark % 2 == 0) & ~SEEN.handed_over)
    cameras_of = {i: set(alone.camera[alone.landmark == i].tolist()) for i in np.unique(alone.landmark)}
    result = concluded(alone)
    assert result is not None
    for camera, name in enumerate(SCENE.rig.cameras):
        shared = [i for i in alone.landmark[alone.camera == camera] if len(cameras_of[int(i)]) > 1]
        assert abs(result.link_count[name] - len(shared)) <= 0.05 * len(alone)


def test_too_few_sightings_are_not_believed() -> None:
    assert concluded(config=ResultConfig(min_inliers=len(SEEN) + 1)) is None


def test_sightings_that_disagree_are_not_believed() -> None:
    assert (
        concluded(scene=replace(SCENE, rig=shaken(SCENE.rig, 2.0, 50.0)), seen=SEEN.select(SEEN.camera > 0))
        is None
    )


def test_a_single_outlier_is_not_counted() -> None:
    pixels = SEEN.pixels.copy()
    pixels[0] += 30.0
    result = concluded(replace(SEEN, pixels=pixels))
    assert result is not None
    assert sum(result.inlier_count.values()) in (len(SEEN) - 1, len(SEEN) - 2)
