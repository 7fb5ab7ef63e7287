"""A window through the canyon with its pictures, its truth, and landmarks at corners that cameras see."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.bundle import Image
from estimator.detect import DetectConfig, detect_corners
from estimator.observations import Index, Observations
from estimator.rig import Rig
from estimator.scene import Scene
from estimator.se3 import SE3, Array
from tests.canyon import PLANES, cast, render


@dataclass(frozen=True, eq=False)
class CanyonWindow:
    """What a window sees.

    Attributes:
        scene: The truth.
        images: ``images[keyframe][camera]``.
        observations: Where each landmark is seen by the camera that owns it.
        normals_world: (M, 3) of the plane that each landmark lies on; the sign is any.
    """

    scene: Scene
    images: list[list[Image | None]]
    observations: Observations
    normals_world: Array

    def true_px(self, landmark: Index, camera: Index, keyframe: Index) -> Array:
        """Return (N, 2) where landmarks truly appear."""
        return self.scene.predict(camera, keyframe, self.scene.points_world[landmark])

    def plane_of(self, landmark: Index) -> Index:
        """Return the index of the plane that landmarks lie on."""
        normals = np.stack([plane.normal for plane in PLANES])
        return np.asarray(np.abs(self.normals_world[landmark] @ normals.T).argmax(1))


def look(rig: Rig, world_from_egos: tuple[SE3, ...], owners: tuple[str, ...], room: int = 60) -> CanyonWindow:
    """Drive through; the owners find landmarks in the middle picture and see them before and after."""
    images: list[list[Image | None]] = [
        [render(mounted.camera, pose @ mounted.ego_from_cam) for mounted in rig.cameras.values()]
        for pose in world_from_egos
    ]
    middle = len(world_from_egos) // 2
    points, normals, owner = [], [], []
    for camera, name in enumerate(rig.cameras):
        if name not in owners:
            continue
        mounted, image = rig[name], images[middle][camera]
        assert image is not None
        corners = detect_corners(image, np.zeros((0, 2)), room, DetectConfig())
        found, hit = cast(world_from_egos[middle] @ mounted.ego_from_cam, mounted.camera.unproject(corners))
        known = np.isfinite(found[:, 0])
        points.append(found[known])
        normals.append(np.stack([plane.normal for plane in PLANES])[hit[known]])
        owner.append(np.full(known.sum(), camera))
    scene = Scene(rig, world_from_egos, np.concatenate(points))
    return CanyonWindow(scene, images, _own_sightings(scene, np.concatenate(owner)), np.concatenate(normals))


def _own_sightings(scene: Scene, owner: Index) -> Observations:
    frames, count = len(scene.world_from_egos), len(owner)
    landmark, camera = np.tile(np.arange(count), frames), np.tile(owner, frames)
    keyframe = np.repeat(np.arange(frames), count)
    pixels = scene.predict(camera, keyframe, scene.points_world[landmark])
    inside = np.zeros(len(landmark), bool)
    for index, mounted in enumerate(scene.rig.cameras.values()):
        inside |= (camera == index) & mounted.camera.contains(pixels, 4.0)
    every = Observations(
        landmark, camera, keyframe, pixels, np.full(len(landmark), 0.3), np.zeros(len(landmark), bool)
    )
    return every.select(inside)
