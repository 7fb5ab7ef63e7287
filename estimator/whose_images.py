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

from estimator.config import Config
from estimator.keyframe import Keyframe
from estimator.observations import Index, Mask
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3, Array


class FitConfig(Config):
    """When a track counts as explained, and which tracks can tell."""

    tolerance_rad: float = 0.01
    loss_rad: tuple[float, ...] = (0.03, 0.015, 0.008)
    min_parallax_rad: float = 0.03
    min_depth_m: float = 0.2


@dataclass(frozen=True, eq=False)
class Pairs:
    """First and last sighting of N tracks of one stream: (N,) keyframes and (N, 2) pixels of each."""

    first: Index
    last: Index
    first_px: Array
    last_px: Array

    def __len__(self) -> int:
        return len(self.first)


def pairs_of(keyframes: Sequence[Keyframe], name: str) -> Pairs:
    """Collect where each track of a stream began and ended within a window."""
    rows = [(k, *keyframe.tracks[name]) for k, keyframe in enumerate(keyframes) if name in keyframe.tracks]
    if not rows:
        return Pairs(np.zeros(0, np.int64), np.zeros(0, np.int64), np.zeros((0, 2)), np.zeros((0, 2)))
    ids = np.concatenate([each for _, each, _ in rows])
    frame = np.concatenate([np.full(len(each), k) for k, each, _ in rows])
    pixels = np.concatenate([each for _, _, each in rows])
    order = np.lexsort((frame, ids))
    _, start, count = np.unique(ids[order], return_index=True, return_counts=True)
    first, last = order[start[count > 1]], order[(start + count - 1)[count > 1]]
    return Pairs(frame[first], frame[last], pixels[first], pixels[last])


def explained(
    pairs: Pairs, mount: MountedCamera, poses: Sequence[SE3], sigma_rad: float, config: FitConfig
) -> Mask:
    """Tell which tracks a camera at a mount can have seen along the path.

    The mount may turn a little: its rotation is fitted to the tracks, robustly and under the prior.

    Args:
        pairs: The tracks, N of them.
        mount: Lens and pose to begin at.
        poses: ``world_from_ego`` of every keyframe.
        sigma_rad: Standard deviation of the turn about each axis.
        config: Limits.

    Returns:
        (N,) explained, without those that cannot tell: they count as not explained.
    """
    rays = mount.camera.unproject(np.vstack([pairs.first_px, pairs.last_px]))
    centers = np.stack([pose.apply(mount.ego_from_cam.translation) for pose in poses])
    egos = np.stack([pose.rotation for pose in poses])
    baseline = centers[pairs.last] - centers[pairs.first]

    def directions(turn: Array) -> tuple[Array, Array]:
        rotation = (mount.ego_from_cam @ SE3.exp(np.concatenate([turn, np.zeros(3)]))).rotation
        in_ego = rays @ rotation.T
        first = np.einsum("nij,nj->ni", egos[pairs.first], in_ego[: len(pairs)])
        return first, np.einsum("nij,nj->ni", egos[pairs.last], in_ego[len(pairs) :])

    turn, step = np.zeros(3), 1e-4
    for loss_rad in config.loss_rad:
        error = _off_plane(*directions(turn), baseline)
        ahead = [_off_plane(*directions(turn + step * axis), baseline) for axis in np.eye(3)]
        slope = np.nan_to_num((np.stack(ahead, -1) - error[:, None]) / step)
        weight = 1 / (loss_rad**2 + np.nan_to_num(error, nan=1e3) ** 2)
        hessian = slope.T @ (weight[:, None] * slope) + np.eye(3) / sigma_rad**2
        turn = turn - np.linalg.solve(
            hessian, slope.T @ (weight * np.nan_to_num(error)) + turn / sigma_rad**2
        )
    first, last = directions(turn)
    with np.errstate(invalid="ignore"):
        near = np.abs(_off_plane(first, last, baseline)) < config.tolerance_rad
    telling = can_tell(pairs, mount, poses, config)
    return np.asarray(telling & near & _before_camera(first, last, baseline, config))


def can_tell(pairs: Pairs, mount: MountedCamera, poses: Sequence[SE3], config: FitConfig) -> Mask:
    """Tell which tracks turned, seen from a camera that only turns with the car, by more than noise."""
    rays = mount.camera.unproject(np.vstack([pairs.first_px, pairs.last_px])) @ mount.ego_from_cam.rotation.T
    egos = np.stack([pose.rotation for pose in poses])
    first = np.einsum("nij,nj->ni", egos[pairs.first], rays[: len(pairs)])
    last = np.einsum("nij,nj->ni", egos[pairs.last], rays[len(pairs) :])
    with np.errstate(invalid="ignore"):
        return np.asarray(np.linalg.norm(first - last, axis=1) > config.min_parallax_rad)


def _off_plane(first: Array, last: Array, baseline: Array) -> Array:
    """Return the (N,) angles of the last rays off the planes of first ray and baseline."""
    normal = np.cross(baseline, first)
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.asarray(np.einsum("ni,ni->n", normal, last) / np.linalg.norm(normal, axis=1))


def _before_camera(first: Array, last: Array, baseline: Array, config: FitConfig) -> Mask:
    """Tell which rays meet before both cameras."""
    cosine = np.einsum("ni,ni->n", first, last)
    sine2 = np.maximum(1 - cosine**2, 1e-12)
    along_first = np.einsum("ni,ni->n", first, baseline)
    along_last = np.einsum("ni,ni->n", last, baseline)
    with np.errstate(invalid="ignore"):
        before = (along_first - cosine * along_last) / sine2 > config.min_depth_m
        return np.asarray(before & ((cosine * along_first - along_last) / sine2 > config.min_depth_m))


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
