"""What a window taught, and whether to believe it."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from estimator.belief import Belief
from estimator.config import Config
from estimator.estimate import Match
from estimator.matches import cross_camera_matches
from estimator.observations import Mask, Observations
from estimator.ranges import PositiveCount, Share, SizePx
from estimator.scale import ScaleInformation
from estimator.scene import Scene
from estimator.se3 import SE3, Array


class ResultConfig(Config):
    """When a window is believed: enough sightings that agree well enough, and are not a chosen few.

    A scene gone astray explains some sightings very well: those that it was left with.
    """

    inlier_px: SizePx = 1.5
    min_inliers: PositiveCount = 150
    max_median_px: SizePx = 0.7
    min_share: Share = 0.35  # of what the tracks saw


@dataclass(frozen=True, eq=False)
class WindowResult:
    """What a window taught.

    Attributes:
        belief: The extrinsics after it.
        inlier_count: By camera, sightings that support the belief.
        link_count: By camera, those among them that tie it to another camera.
        median_px: Median reprojection error.
        matches: Landmarks that two cameras share, for people to look at.
        scene: The adjusted values, in the window's own world: road near z = 0.
        seen: The sightings they were adjusted to.
        track_sightings: How many sightings the tracks had, explained or not.
        scale_information: What each source of it said of scale.
    """

    belief: Belief
    inlier_count: dict[str, int]
    link_count: dict[str, int]
    median_px: float
    matches: tuple[Match, ...]
    scene: Scene
    seen: Observations
    track_sightings: int
    scale_information: ScaleInformation = field(default_factory=dict)

    def path_from(self, world_from_first: SE3) -> list[SE3]:
        """Return the car's poses at the keyframes if it was there at the first.

        Each window hands its last pose on to the next one, so what rounding does to a rotation would grow
        from window to window, within a hundred metres to what can be seen; so they are made rotations again.
        """
        world_from_window = world_from_first @ self.scene.world_from_egos[0].inverse()
        poses = [world_from_window @ pose for pose in self.scene.world_from_egos]
        return [SE3.from_quaternion_xyzw(pose.quaternion_xyzw, pose.translation) for pose in poses]


def conclude(
    scene: Scene,
    seen: Observations,
    covariance: Array,
    track_sightings: int,
    config: ResultConfig,
) -> WindowResult | None:
    """Sum up an adjusted window; None if too little of it agrees.

    Args:
        scene: The adjusted values, and when its keyframes were.
        seen: The sightings they were adjusted to.
        covariance: (6 C, 6 C) posterior of the estimated extrinsics.
        track_sightings: How many sightings the tracks had, explained or not.
        config: Thresholds.
    """
    error_px = scene.residuals_px(seen)
    with np.errstate(invalid="ignore"):
        inliers = seen.select(error_px < config.inlier_px).of_enough_views(2)
    median_px = float(np.nanmedian(error_px))
    explained = np.count_nonzero(~inliers.handed_over) / max(track_sightings, 1)
    if len(inliers) < config.min_inliers or median_px > config.max_median_px or explained < config.min_share:
        return None
    names = list(scene.rig.cameras)
    counts = np.bincount(inliers.camera, minlength=len(names)).tolist()
    links = np.bincount(inliers.camera[_shared(inliers)], minlength=len(names)).tolist()
    return WindowResult(
        Belief(scene.rig, covariance),
        dict(zip(names, counts, strict=True)),
        dict(zip(names, links, strict=True)),
        median_px,
        cross_camera_matches(inliers, names, scene.stamps_ns),
        scene,
        seen,
        track_sightings,
    )


def _shared(seen: Observations) -> Mask:
    """Tell which sightings are of landmarks that more than one camera saw."""
    count = int(seen.landmark.max(initial=-1)) + 1
    low, high = np.full(count, 10**6), np.full(count, -1)
    np.minimum.at(low, seen.landmark, seen.camera)
    np.maximum.at(high, seen.landmark, seen.camera)
    return np.asarray((low != high)[seen.landmark])
