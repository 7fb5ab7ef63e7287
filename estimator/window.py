"""Calibrate from one window of keyframes: the offline heart of the online estimator.

Tracks become landmarks, the road gives scale and level, cameras that are still far off are turned on their
own tracks first, landmarks are handed over between cameras, every sighting is measured again against one
anchor patch, and all is adjusted together.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from estimator.align import AlignConfig, align
from estimator.anchors import Anchors, choose_anchors
from estimator.belief import Belief
from estimator.bundle import Image
from estimator.config import Config
from estimator.corridor import low_landmarks, road_landmarks
from estimator.factors import GraphConfig, Loss
from estimator.graph import adjust
from estimator.handover import HandoverConfig, hand_over
from estimator.keyframe import Keyframe, gather_observations
from estimator.observations import Mask, Observations
from estimator.road_level import level_on_road, rescale_on_road
from estimator.scene import Scene
from estimator.se3 import Array
from estimator.stopwatch import Stopwatch
from estimator.window_result import ResultConfig, WindowResult, conclude


class WindowConfig(Config):
    """Noise, limits and search ranges of a window's calibration."""

    track_sigma_px: float = 0.5
    anchored_sigma_px: float = 0.65
    unsure_rad: float = 0.006
    wide_search_rad: float = 0.04
    narrow_search_rad: float = 0.008
    scale_sigma: float = 0.03
    road_tolerance_m: float = 0.08
    result: ResultConfig = ResultConfig()
    graph: GraphConfig = GraphConfig()
    rough_graph: GraphConfig = GraphConfig(road_sigma_m=0.08)  # pavements count as road
    handover: HandoverConfig = HandoverConfig()
    align: AlignConfig = AlignConfig()


class WindowCalibration:
    """The steps of one window; made, run once and thrown away."""

    def __init__(
        self,
        keyframes: Sequence[Keyframe],
        belief: Belief,
        metric: bool,
        config: WindowConfig,
        stopwatch: Stopwatch,
    ) -> None:
        rig = belief.rig
        self.keyframes, self.belief, self.config, self.stopwatch = keyframes, belief, config, stopwatch
        self.scale_sigma = config.scale_sigma if metric else np.inf
        self.names = list(rig.cameras)
        self.reference = self.names.index(rig.reference)
        self.images: list[list[Image | None]] = [[k.images.get(n) for n in self.names] for k in keyframes]
        first = keyframes[0].world_from_ego.inverse()
        poses = tuple(first @ keyframe.world_from_ego for keyframe in keyframes)
        tracks = gather_observations(keyframes, rig, config.track_sigma_px).of_enough_views(2)
        _, landmark = np.unique(tracks.landmark, return_inverse=True)
        self.tracks = replace(tracks, landmark=np.asarray(landmark, np.int64))
        unknown = np.full((int(self.tracks.landmark.max(initial=-1)) + 1, 3), np.nan)
        self.scene = Scene(rig, poses, unknown).with_triangulated(self.tracks, np.isnan(unknown[:, 0]))

    def run(self) -> WindowResult | None:
        """Calibrate; None if the window does not hold enough to learn from."""
        try:
            self._place_on_road()
            if self._unsure():
                self._turn_each_camera_alone()
            for radius_rad in self._search_ranges_rad():
                linked = self._hand_over(radius_rad)
                self._adjust_jointly(linked)
            return self._refine(linked)
        except RuntimeError:  # GTSAM: an indeterminate system; the window cannot be solved
            return None

    def _unsure(self) -> bool:
        rig = self.belief.rig
        return any(self.belief.rotation_sigma_rad(n) > self.config.unsure_rad for n in rig.estimated_names)

    def _search_ranges_rad(self) -> Iterator[float]:
        if self._unsure():
            yield self.config.wide_search_rad
        yield self.config.narrow_search_rad

    def _place_on_road(self) -> None:
        """Adjust the path to the reference camera's tracks, at the scale and level that the road gives."""
        with self.stopwatch.stage("motion"):
            seen = self._believable(self.tracks.select(self.tracks.camera == self.reference), 8.0)
            for _ in range(2):
                levelled = level_on_road(self.scene, seen, self.scale_sigma)
                on_road = self._nowhere()
                if levelled is not None:
                    self.scene, on_road = levelled
                path = adjust(self.scene, seen, on_road, self.belief, Loss(1.5), self.config.graph).scene
                self.scene = replace(self.scene, world_from_egos=path.world_from_egos)
                self.scene = self.scene.with_triangulated(self.tracks, self._everywhere())
                seen = self._believable(seen, 6.0)

    def _turn_each_camera_alone(self) -> None:
        """Fit every camera to its own tracks along the known path: turns them by degrees into line."""
        with self.stopwatch.stage("alone"):
            for loss_px, limit_px, tolerance_m in ((4.0, 20.0, 0.3), (1.5, 9.0, 0.12), (0.5, 3.0, 0.12)):
                seen = self._believable(self.tracks, limit_px)
                flat = low_landmarks(self.scene, seen, tolerance_m)
                self._adjust(seen, flat, Loss(loss_px), self.config.rough_graph, fixed_poses=True)
                self.scene = self.scene.with_triangulated(
                    self.tracks, np.isnan(self.scene.points_world[:, 0])
                )

    def _anchors(self, seen: Observations) -> Anchors:
        on_road = road_landmarks(self.scene, seen, 2 * self.config.road_tolerance_m)
        return choose_anchors(self.scene, seen, self.images, on_road)

    def _hand_over(self, radius_rad: float) -> Observations:
        """Return the tracks and what other cameras saw of their landmarks."""
        with self.stopwatch.stage("match"):
            seen = self._believable(self.tracks, 5.0)
            anchors = self._anchors(seen)
            focal_px = np.array([np.mean(m.camera.focal_px) for m in self.scene.rig.cameras.values()])
            radius_px = np.maximum(3.0, radius_rad * focal_px)
            found = hand_over(self.scene, self.images, seen, anchors, radius_px, self.config.handover)
            error_px = self.scene.residuals_px(found)
            return seen.join(found.select(error_px < 1.5 * radius_px[found.camera]))

    def _adjust_jointly(self, linked: Observations) -> None:
        with self.stopwatch.stage("window"):
            for loss_px in (4.0, 1.0) if self._unsure() else (1.0,):
                on_road = road_landmarks(self.scene, linked, self.config.road_tolerance_m)
                self._adjust(linked, on_road, Loss(loss_px), self.config.graph)
                linked = self._believable(linked, 4.0 * loss_px)
            self.scene = self.scene.with_triangulated(self.tracks, np.isnan(self.scene.points_world[:, 0]))

    def _refine(self, linked: Observations) -> WindowResult | None:
        """Measure every sighting again against its landmark's anchor patch, and adjust once more."""
        with self.stopwatch.stage("refine"):
            linked = self._believable(linked, 4.0)
            anchors = self._anchors(linked)
            predicted = self.scene.predict(
                linked.camera, linked.keyframe, self.scene.points_world[linked.landmark]
            )
            measured = align(
                self.scene, self.images, anchors, linked.landmark, linked.camera, linked.keyframe, predicted,
                self.config.align,
            )  # fmt: skip
            sigma_px = np.full(len(linked), self.config.anchored_sigma_px)
            fine = replace(linked, pixels=measured.pixels, sigma_px=sigma_px)
            fine = fine.select(np.asarray(np.isfinite(fine.pixels).all(1))).of_enough_views(2)
            measured_again = self.scene.with_triangulated(fine, self._everywhere())
            self.scene = rescale_on_road(measured_again, fine, self.scale_sigma)
            fine = self._believable(fine, 4.0)
        with self.stopwatch.stage("window"):
            if len(fine) < self.config.result.min_inliers:
                return None
            on_road = road_landmarks(self.scene, fine, self.config.road_tolerance_m)
            covariance = self._adjust(fine, on_road, Loss(0.5), self.config.graph, want_covariance=True)
        stamps_ns = [keyframe.stamp_ns for keyframe in self.keyframes]
        return conclude(self.scene, fine, covariance, stamps_ns, self.config.result)

    def _adjust(
        self,
        seen: Observations,
        on_road: Mask,
        loss: Loss,
        graph: GraphConfig,
        *,
        fixed_poses: bool = False,
        want_covariance: bool = False,
    ) -> Array:
        adjusted = adjust(
            self.scene, seen, on_road, self.belief, loss, graph,
            fixed_poses=fixed_poses, want_covariance=want_covariance,
        )  # fmt: skip
        self.scene = adjusted.scene
        return adjusted.covariance

    def _believable(self, seen: Observations, limit_px: float) -> Observations:
        with np.errstate(invalid="ignore"):
            return seen.select(self.scene.residuals_px(seen) < limit_px).of_enough_views(2)

    def _everywhere(self) -> Mask:
        return np.ones(len(self.scene.points_world), bool)

    def _nowhere(self) -> Mask:
        return np.zeros(len(self.scene.points_world), bool)
