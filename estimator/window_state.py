"""What a window has: images, tracks, and the scene at its present values, which every step makes better."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from estimator.anchors import Anchors, choose_anchors
from estimator.belief import Belief
from estimator.bundle import Image
from estimator.clocks import Clocks
from estimator.corridor import road_landmarks
from estimator.corridor_config import CorridorConfig
from estimator.factors import GraphConfig
from estimator.graph import Adjusted, adjust
from estimator.keyframe import Keyframe, gather_observations
from estimator.loss import Loss
from estimator.observations import Mask, Observations
from estimator.rig import Rig
from estimator.scale import ScaleInformation
from estimator.scene import Scene
from estimator.se3 import Array


class WindowState:
    """Lives as long as one window's calibration; the tracks stay as they are, the scene changes.

    Attributes:
        belief: What is known of the extrinsics before.
        reference: Index of the reference camera.
        images: By keyframe and camera.
        tracks: What each camera saw by itself, of landmarks that are numbered without gaps.
        scene: Poses, extrinsics and landmarks; world is the first keyframe's ego frame.
        scale_information: What each source said of scale in the newest adjustment with a covariance.
    """

    def __init__(
        self,
        keyframes: Sequence[Keyframe],
        belief: Belief,
        track_sigma_px: float,
        corridor: CorridorConfig,
        start: Rig | None = None,
    ) -> None:
        rig = start or belief.rig
        names = list(rig.cameras)
        self.belief = belief
        self.scale_information: ScaleInformation = {}
        self.reference = names.index(rig.reference)
        self.images: list[list[Image | None]] = [[k.images.get(n) for n in names] for k in keyframes]
        first = keyframes[0].world_from_ego.inverse()
        poses = tuple(first @ keyframe.world_from_ego for keyframe in keyframes)
        tracks = gather_observations(keyframes, rig, track_sigma_px).of_enough_views(2)
        _, landmark = np.unique(tracks.landmark, return_inverse=True)
        self.tracks = replace(tracks, landmark=np.asarray(landmark, np.int64))
        unknown = np.full((int(self.tracks.landmark.max(initial=-1)) + 1, 3), np.nan)
        stamps_ns = tuple(keyframe.stamp_ns for keyframe in keyframes)
        ahead_s = tuple(belief.ahead_s.get(name, 0.0) for name in names)
        clocks = Clocks(stamps_ns, ahead_s) if any(ahead_s) else None
        self.scene = Scene(rig, poses, unknown, stamps_ns, clocks, corridor)
        self.triangulate_unknown()

    def is_unsure(self, sigma_rad: float) -> bool:
        """Tell whether any camera's rotation is known worse than that."""
        return len(self.belief.known_within(sigma_rad)) < len(self.belief.rig.cameras)

    def believable(self, seen: Observations, limit_px: float) -> Observations:
        """Return the sightings that the scene explains, of landmarks that have two of them."""
        with np.errstate(invalid="ignore"):
            return seen.select(self.scene.residuals_px(seen) < limit_px).of_enough_views(2)

    def triangulate_unknown(self) -> None:
        """Intersect the tracks of landmarks that have no place yet."""
        self.scene = self.scene.with_triangulated(self.tracks, np.isnan(self.scene.points_world[:, 0]))

    def triangulate_again(self, seen: Observations) -> None:
        """Intersect all landmarks anew."""
        self.scene = self.scene.with_triangulated(seen, np.ones(len(self.scene.points_world), bool))

    def anchors(self, seen: Observations, road_tolerance_m: float) -> Anchors:
        """Choose for every landmark the image that shows it best."""
        on_road = road_landmarks(self.scene, seen, 2 * road_tolerance_m)
        return choose_anchors(self.scene, seen, self.images, on_road)

    def adjust(
        self,
        seen: Observations,
        on_road: Mask,
        loss: Loss,
        graph: GraphConfig,
        *,
        fixed_poses: bool = False,
    ) -> None:
        """Fit the whole scene to sightings."""
        self.take(adjust(self.scene, seen, on_road, self.belief, loss, graph, fixed_poses=fixed_poses))

    def take(self, adjusted: Adjusted) -> Array:
        """Take over the outcome of an adjustment; return its covariance."""
        self.scene, self.scale_information = adjusted.scene, adjusted.scale_information
        return adjusted.covariance

    def adjust_path(self, seen: Observations, on_road: Mask, loss: Loss, graph: GraphConfig) -> None:
        """Fit everything to sightings, but take over the poses of the car alone."""
        path = adjust(self.scene, seen, on_road, self.belief, loss, graph).scene
        self.scene = replace(self.scene, world_from_egos=path.world_from_egos)
