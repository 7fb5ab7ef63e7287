"""What a window taught, and whether to believe it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from estimator.belief import Belief
from estimator.config import Config
from estimator.estimate import Match
from estimator.matches import cross_camera_matches
from estimator.observations import Mask, Observations
from estimator.scene import Scene
from estimator.se3 import SE3, Array


class ResultConfig(Config):
    """When a window is believed: enough sightings that agree well enough."""

    inlier_px: float = 1.5
    min_inliers: int = 150
    max_median_px: float = 0.7


@dataclass(frozen=True, eq=False)
class WindowResult:
    """What a window taught.

    Attributes:
        belief: The extrinsics after it.
        world_from_egos: Pose of the car at each keyframe, in the window's own world: road at z = 0.
        inlier_count: By camera, sightings that support the belief.
        link_count: By camera, those among them that tie it to another camera.
        median_px: Median reprojection error.
        matches: Landmarks that two cameras share, for people to look at.
        scene: The adjusted values.
        seen: The sightings they were adjusted to.
        stamps_ns: Stamp of each keyframe.
    """

    belief: Belief
    world_from_egos: tuple[SE3, ...]
    inlier_count: dict[str, int]
    link_count: dict[str, int]
    median_px: float
    matches: tuple[Match, ...]
    scene: Scene
    seen: Observations
    stamps_ns: tuple[int, ...]

    def path_from(self, world_from_first: SE3) -> list[SE3]:
        """Return the car's poses at the keyframes if it was there at the first."""
        world_from_window = world_from_first @ self.world_from_egos[0].inverse()
        return [world_from_window @ pose for pose in self.world_from_egos]


def conclude(
    scene: Scene, seen: Observations, covariance: Array, stamps_ns: Sequence[int], config: ResultConfig
) -> WindowResult | None:
    """Sum up an adjusted window; None if too little of it agrees.

    Args:
        scene: The adjusted values.
        seen: The sightings they were adjusted to.
        covariance: (6 C, 6 C) posterior of the estimated extrinsics.
        stamps_ns: Stamp of each keyframe.
        config: Thresholds.
    """
    error_px = scene.residuals_px(seen)
    with np.errstate(invalid="ignore"):
        inliers = seen.select(error_px < config.inlier_px).of_enough_views(2)
    median_px = float(np.nanmedian(error_px))
    if len(inliers) < config.min_inliers or median_px > config.max_median_px:
        return None
    names = list(scene.rig.cameras)
    counts = np.bincount(inliers.camera, minlength=len(names)).tolist()
    links = np.bincount(inliers.camera[_shared(inliers)], minlength=len(names)).tolist()
    return WindowResult(
        Belief(scene.rig, covariance),
        scene.world_from_egos,
        dict(zip(names, counts, strict=True)),
        dict(zip(names, links, strict=True)),
        median_px,
        cross_camera_matches(inliers, names, stamps_ns),
        scene,
        seen,
        tuple(stamps_ns),
    )


def _shared(seen: Observations) -> Mask:
    """Tell which sightings are of landmarks that more than one camera saw."""
    count = int(seen.landmark.max(initial=-1)) + 1
    low, high = np.full(count, 10**6), np.full(count, -1)
    np.minimum.at(low, seen.landmark, seen.camera)
    np.maximum.at(high, seen.landmark, seen.camera)
    return np.asarray((low != high)[seen.landmark])
