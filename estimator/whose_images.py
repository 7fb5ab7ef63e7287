"""Which mount does each camera's stream of images fit? Two cables swapped with each other show here.

Along a known path, the tracks of a camera must move as seen from its mount: towards the epipoles of that
mount, and as points in front of it. Every stream is tried on every mount, seen through the lens that belongs
to the mount, for a lens goes with its camera. A mount may be turned as far as the prior of the rig file lets
expect. Mounts that look the same way, a hand's breadth apart, fit each other's images; see ``common_view``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.epipolar import FitConfig, can_tell, explained, pairs_of
from estimator.keyframe import Keyframe
from estimator.rig import Rig
from estimator.se3 import SE3, Array


@dataclass(frozen=True, eq=False)
class Fit:
    """How well C streams fit C mounts, both in the order of the rig.

    Attributes:
        count: (C, C) tracks of the stream (row) that the mount (column) explains.
        total: (C, C) tracks of the stream that could tell.
    """

    count: Array
    total: Array

    @property
    def share(self) -> Array:
        """(C, C) the share of tracks explained; 0 where none could tell."""
        return np.asarray(self.count / np.maximum(self.total, 1.0))

    def __add__(self, other: Fit) -> Fit:
        return Fit(self.count + other.count, self.total + other.total)


def fit_streams(
    keyframes: Sequence[Keyframe],
    rig: Rig,
    config: FitConfig,
    *,
    reference_mount: str | None = None,
    own_only: bool = False,
) -> Fit:
    """Try every stream of images on every mount, or on its own alone.

    Args:
        keyframes: A window; its path is the one that the reference stream gave at the reference mount.
        rig: The mounts.
        config: Limits.
        reference_mount: Where the reference stream is supposed to come from, if not from the reference.
        own_only: Whether to fill the diagonal alone.
    """
    names = list(rig.cameras)
    poses = _path_from(keyframes, rig, reference_mount or rig.reference)
    sigma_rad = max(np.deg2rad(rig.prior.rotation_deg) / np.sqrt(3), 1e-3)
    count, total = np.zeros((2, len(names), len(names)))
    for row, name in enumerate(names):
        pairs = pairs_of(keyframes, name)
        for column, (other, mount) in enumerate(rig.cameras.items()):
            if own_only and other != name:
                continue
            if mount.camera.size_px != rig[name].camera.size_px or not len(pairs):
                continue
            count[row, column] = explained(pairs, mount, poses, sigma_rad, config).sum()
            total[row, column] = can_tell(pairs, mount, poses, config).sum()
    return Fit(count, total)


def _path_from(keyframes: Sequence[Keyframe], rig: Rig, mount: str) -> list[SE3]:
    """Return the path of the car if the reference stream came from another mount.

    Metres came from the height of the camera, so they change with it.
    """
    supposed, true = rig[rig.reference].ego_from_cam, rig[mount].ego_from_cam
    if mount == rig.reference:
        return [keyframe.world_from_ego for keyframe in keyframes]
    scale = max(float(true.translation[2] / supposed.translation[2]), 0.1)
    cameras = [keyframe.world_from_ego @ supposed for keyframe in keyframes]
    return [SE3(each.rotation, scale * each.translation) @ true.inverse() for each in cameras]
