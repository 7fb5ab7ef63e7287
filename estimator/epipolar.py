"""Which tracks can a camera at a given mount have seen along a known path?

Each track must lie in the plane of its first ray and the way the camera went, before the camera both times.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.config import Config
from estimator.keyframe import Keyframe
from estimator.observations import Index, Mask
from estimator.ranges import AngleRad, LengthM
from estimator.rig import MountedCamera
from estimator.se3 import SE3, Array
from estimator.two_rays import depths_m


class FitConfig(Config):
    """When a track counts as explained, and which tracks can tell."""

    tolerance_rad: AngleRad = 0.01
    loss_rad: tuple[AngleRad, ...] = (0.03, 0.015, 0.008)
    min_parallax_rad: AngleRad = 0.03
    min_depth_m: LengthM = 0.2


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
    with np.errstate(invalid="ignore"):
        depth_first, depth_last = depths_m(first, last, baseline)
        return np.asarray((depth_first > config.min_depth_m) & (depth_last > config.min_depth_m))
