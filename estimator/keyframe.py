"""A moment kept: the images of all cameras, where the tracks stood, and where the car was."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from estimator.bundle import Image
from estimator.observations import Index, Observations
from estimator.rig import Rig
from estimator.se3 import SE3, Array


@dataclass(frozen=True, eq=False)
class Keyframe:
    """One kept bundle.

    Attributes:
        stamp_ns: Stamp of the bundle.
        images: By camera, (H, W) grey.
        world_from_ego: Pose of the car as the odometry had it.
        tracks: By camera, (N,) track ids and (N, 2) pixels.
    """

    stamp_ns: int
    images: Mapping[str, Image]
    world_from_ego: SE3
    tracks: Mapping[str, tuple[Index, Array]]


def gather_observations(keyframes: Sequence[Keyframe], rig: Rig, sigma_px: float) -> Observations:
    """Collect what the tracks of all cameras saw; every track is a landmark of its own."""
    landmark, camera, frame, pixels = [], [], [], []
    for k, keyframe in enumerate(keyframes):
        for c, name in enumerate(rig.cameras):
            ids, at = keyframe.tracks.get(name, (np.zeros(0, np.int64), np.zeros((0, 2))))
            landmark.append(ids * len(rig.cameras) + c)
            camera.append(np.full(len(ids), c))
            frame.append(np.full(len(ids), k))
            pixels.append(at)
    _, index = np.unique(np.concatenate(landmark), return_inverse=True)
    count = len(index)
    return Observations(
        np.asarray(index, np.int64),
        np.concatenate(camera),
        np.concatenate(frame),
        np.concatenate(pixels),
        np.full(count, sigma_px),
        np.zeros(count, bool),
    )
