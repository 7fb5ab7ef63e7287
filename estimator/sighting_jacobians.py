"""How every sighting's pixel changes with all it depends on: pose, extrinsics, landmark, lens and clock.

Vectorised over the sightings of a window and independent of any solver. A camera's clock that is ahead by d
shows the world as it was d earlier than the stamp says, so a pixel moves against the car's own motion.
"""

from __future__ import annotations

from dataclasses import dataclass, fields

import numpy as np

from estimator.clocks import body_twists
from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import Array, skew

LENS_SIZE = 3  # logarithm of the focal length, principal point x and y in pixels


@dataclass(frozen=True, eq=False)
class SightingJacobians:
    """Derivatives of N predicted pixels, NaN where the camera cannot see the point.

    Attributes:
        residual_px: (N, 2) predicted minus measured.
        by_pose: (N, 2, 6) by the right perturbation of ``world_from_ego``.
        by_extrinsics: (N, 2, 6) by the right perturbation of ``ego_from_cam``.
        by_point: (N, 2, 3) by the landmark in the world.
        by_lens: (N, 2, 3) by log focal length (x and y alike) and principal point.
        by_clock: (N, 2) by the seconds that the camera's clock is ahead.
    """

    residual_px: Array
    by_pose: Array
    by_extrinsics: Array
    by_point: Array
    by_lens: Array
    by_clock: Array

    def select(self, chosen: Mask) -> SightingJacobians:
        """Return those of the chosen sightings."""
        return SightingJacobians(*(getattr(self, f.name)[chosen] for f in fields(self)))


def sighting_jacobians(scene: Scene, seen: Observations) -> SightingJacobians:
    """Differentiate the prediction of every sighting in a scene that has clocks."""
    assert scene.clocks is not None
    twists = body_twists(scene.world_from_egos, scene.clocks.stamps_ns)
    mounted = list(scene.rig.cameras.values())
    rotation, center = scene.pose_arrays(seen.camera, seen.keyframe)
    points_cam = np.einsum("nji,nj->ni", rotation, scene.points_world[seen.landmark] - center)
    pixels, by_cam = np.full((len(seen), 2), np.nan), np.full((len(seen), 2, 3), np.nan)
    for index, each in enumerate(mounted):
        mine = seen.camera == index
        pixels[mine], by_cam[mine] = each.camera.project_with_jacobian(points_cam[mine])
    rotation_ego = np.stack([m.ego_from_cam.rotation for m in mounted])[seen.camera]
    translation_ego = np.stack([m.ego_from_cam.translation for m in mounted])[seen.camera]
    # In the axes of the car as the camera shows it, and then as it was at the stamp.
    points_shown = np.einsum("nij,nj->ni", rotation_ego, points_cam) + translation_ego
    by_shown = by_cam @ rotation_ego.transpose(0, 2, 1)
    rotation_now = np.stack([pose.rotation for pose in scene.world_from_egos])[seen.keyframe]
    center_now = np.stack([pose.translation for pose in scene.world_from_egos])[seen.keyframe]
    points_now = np.einsum("nji,nj->ni", rotation_now, scene.points_world[seen.landmark] - center_now)
    by_world = by_cam @ rotation.transpose(0, 2, 1)
    off_center = pixels - np.array([m.camera.center_px for m in mounted])[seen.camera]
    by_lens = np.concatenate([off_center[:, :, None], np.tile(np.eye(2), (len(seen), 1, 1))], 2)
    return SightingJacobians(
        pixels - seen.pixels,
        _by_perturbation(by_world @ rotation_now, points_now),
        _by_perturbation(by_cam, points_cam),
        by_world,
        by_lens,
        -np.einsum("nij,nj->ni", _by_perturbation(by_shown, points_shown), twists[seen.keyframe]),
    )


def _by_perturbation(by_point: Array, points: Array) -> Array:
    """Return (N, 2, 6): perturbing the frame on the right by d moves points by p x d_rotation - d_move."""
    return np.concatenate([by_point @ skew(points), -by_point], 2)
