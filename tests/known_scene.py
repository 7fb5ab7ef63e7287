"""A window whose truth is known: points on the canyon's planes and where every camera sees them, exactly."""

from __future__ import annotations

import numpy as np

from estimator.observations import Mask, Observations
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.se3 import SE3
from tests.canyon import cast

SIGMA_PX = 0.3


def known_scene(
    rig: Rig, world_from_egos: tuple[SE3, ...], points_per_view: int = 12, seed: int = 0
) -> Scene:
    """Return the true scene, with landmarks where random pixels of every image look."""
    rng = np.random.default_rng(seed)
    points = []
    for world_from_ego in world_from_egos:
        for mounted in rig.cameras.values():
            pixels = rng.uniform(10, np.array(mounted.camera.size_px) - 10, (points_per_view, 2))
            world_from_cam = world_from_ego @ mounted.ego_from_cam
            points.append(cast(world_from_cam, mounted.camera.unproject(pixels))[0])
    found = np.concatenate(points)
    return Scene(rig, world_from_egos, found[np.isfinite(found[:, 0])])


def sightings(scene: Scene, noise_px: float = 0.0, seed: int = 0) -> Observations:
    """Return every sighting there is of landmarks up to 25 m away and seen at least three times.

    The camera that a landmark is seen by first counts as its owner; the others' are handed over.
    """
    rows = []
    for keyframe in range(len(scene.world_from_egos)):
        for camera, mounted in enumerate(scene.rig.cameras.values()):
            points_cam = scene.camera_pose(camera, keyframe).inverse().apply(scene.points_world)
            distance_m = np.linalg.norm(points_cam, axis=1)
            seen = (points_cam[:, 2] > 0.2 * distance_m) & (distance_m < 25)
            pixels = mounted.camera.project(points_cam)
            index = np.flatnonzero(seen & mounted.camera.contains(pixels, 4.0))
            frame = np.full(len(index), keyframe)
            rows.append(np.column_stack([index, np.full(len(index), camera), frame, pixels[index]]))
    table = np.vstack(rows)
    landmark, camera, keyframe = table[:, :3].astype(np.int64).T
    owner = np.full(len(scene.points_world), -1)
    owner[landmark[::-1]] = camera[::-1]
    pixels = table[:, 3:] + noise_px * np.random.default_rng(seed).standard_normal((len(table), 2))
    sigma_px = np.full(len(table), SIGMA_PX)
    return Observations(
        landmark, camera, keyframe, pixels, sigma_px, camera != owner[landmark]
    ).of_enough_views(3)


def on_road(scene: Scene) -> Mask:
    """Tell which landmarks lie on the road."""
    return np.asarray(np.abs(scene.points_world[:, 2]) < 1e-6)
