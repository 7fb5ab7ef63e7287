"""Calibrate from one window of keyframes: the offline heart of the online estimator.

Tracks become landmarks, the road gives scale and level, cameras that are still far off are turned on their
own tracks first, landmarks are handed over between cameras, every sighting is measured again against one
anchor patch, and all is adjusted together.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from estimator.align import align
from estimator.belief import Belief
from estimator.corridor import low_landmarks, road_landmarks
from estimator.handover import hand_over
from estimator.keyframe import Keyframe
from estimator.loss import Loss
from estimator.observations import Observations
from estimator.rig import Rig
from estimator.road_level import level_on_road, rescale_on_road
from estimator.se3 import Array
from estimator.soundness import is_sound
from estimator.stopwatch import Stopwatch
from estimator.window_adjust import adjust_by_losses
from estimator.window_config import WindowConfig
from estimator.window_result import WindowResult, conclude
from estimator.window_state import WindowState


class WindowCalibration:
    """The steps of one window; made, run once and thrown away.

    Without a better ``start`` the steps begin at the mean of the belief.
    """

    def __init__(
        self,
        keyframes: Sequence[Keyframe],
        belief: Belief,
        metric: bool,
        config: WindowConfig,
        stopwatch: Stopwatch,
        start: Rig | None = None,
    ) -> None:
        self.config, self.stopwatch = config, stopwatch
        # The path has the size of the rig that the cameras were tracked with, less what it drifted since.
        self.scale_sigma = float(np.hypot(config.scale_drift, belief.scale_sigma())) if metric else np.inf
        self.state = WindowState(keyframes, belief, config.track_sigma_px, config.corridor, start)
        self.unsure = start is None and self.state.is_unsure(config.unsure_rad)

    def run(self) -> WindowResult | None:
        """Calibrate; None if the window does not hold enough to learn from."""
        try:
            self._place_on_road()
            if self.unsure:
                self._turn_each_camera_alone()
            for radius_rad in self._search_ranges_rad():
                linked = self._hand_over(radius_rad)
                self._adjust_jointly(linked)
            fine = self._measure_again(linked)
            for _ in range(self.config.repeats):
                self._adjust_finely(fine)
                fine = self._measure_again(linked)
            result = self._conclude(fine)
        except (RuntimeError, np.linalg.LinAlgError):  # an indeterminate system: the window cannot be solved
            return None
        return result if result is None or is_sound(result) else None

    def _search_ranges_rad(self) -> Iterator[float]:
        if self.unsure:
            yield self.config.wide_search_rad
        yield self.config.narrow_search_rad

    def _place_on_road(self) -> None:
        """Adjust the path to the reference camera's tracks, at the scale and level that the road gives."""
        state = self.state
        with self.stopwatch.stage("motion"):
            seen = state.believable(state.tracks.select(state.tracks.camera == state.reference), 8.0)
            for _ in range(2):
                levelled = level_on_road(state.scene, seen, self.config.graph, self.scale_sigma)
                on_road = np.zeros(len(state.scene.points_world), bool)
                if levelled is not None:
                    state.scene, on_road = levelled
                state.adjust_path(seen, on_road, Loss(1.5), self.config.graph)
                state.triangulate_again(state.tracks)
                seen = state.believable(seen, 6.0)

    def _turn_each_camera_alone(self) -> None:
        """Fit every camera to its own tracks along the known path: turns them by degrees into line."""
        state = self.state
        with self.stopwatch.stage("alone"):
            for loss_px, limit_px, tolerance_m in ((4.0, 20.0, 0.3), (1.5, 9.0, 0.12), (0.5, 3.0, 0.12)):
                seen = state.believable(state.tracks, limit_px)
                flat = low_landmarks(state.scene, seen, tolerance_m)
                state.adjust(seen, flat, Loss(loss_px), self.config.rough_graph, fixed_poses=True)
                state.triangulate_unknown()

    def _hand_over(self, radius_rad: float) -> Observations:
        """Return the tracks and what other cameras saw of their landmarks."""
        state = self.state
        with self.stopwatch.stage("match"):
            seen = state.believable(state.tracks, 5.0)
            anchors = state.anchors(seen, self.config.road_tolerance_m)
            focal_px = np.array([np.mean(m.camera.focal_px) for m in state.scene.rig.cameras.values()])
            radius_px = np.maximum(3.0, radius_rad * focal_px)
            found = hand_over(state.scene, state.images, seen, anchors, radius_px, self.config.handover)
            error_px = state.scene.residuals_px(found)
            return seen.join(found.select(error_px < 1.5 * radius_px[found.camera]))

    def _adjust_jointly(self, linked: Observations) -> None:
        state = self.state
        with self.stopwatch.stage("window"):
            for loss_px in (4.0, 1.0) if self.unsure else (1.0,):
                on_road = road_landmarks(state.scene, linked, self.config.road_tolerance_m)
                state.adjust(linked, on_road, Loss(loss_px), self.config.graph)
                linked = state.believable(linked, 4.0 * loss_px)
            state.triangulate_unknown()

    def _measure_again(self, linked: Observations) -> Observations:
        """Return every sighting measured against its landmark's anchor patch."""
        state = self.state
        with self.stopwatch.stage("refine"):
            linked = state.believable(linked, 4.0)
            anchors = state.anchors(linked, self.config.road_tolerance_m)
            points_world = state.scene.points_world[linked.landmark]
            predicted = state.scene.predict(linked.camera, linked.keyframe, points_world)
            sightings = (linked.landmark, linked.camera, linked.keyframe)
            measured = align(state.scene, state.images, anchors, *sightings, predicted, self.config.align)
            sigma_px = self.config.sighting_noise.sigma_px(measured)
            fine = replace(linked, pixels=measured.pixels, sigma_px=sigma_px)
            fine = fine.select(np.asarray(np.isfinite(fine.pixels).all(1))).of_enough_views(2)
            state.triangulate_again(fine)
            state.scene = rescale_on_road(state.scene, fine, self.scale_sigma)
            return state.believable(fine, 4.0)

    def _adjust_finely(self, fine: Observations, *, want_covariance: bool = False) -> Array:
        """Adjust to sightings that were measured again; return the covariance if wanted.

        Most of them are as right as they say. The few that are not (corners where something near covers
        something far, patches that are no plane) are off by several sigmas, and in one direction for whole
        classes of them, so the second loss is tight.
        """
        state, losses = self.state, self.config.fine_losses
        with self.stopwatch.stage("window"):
            return state.take(
                adjust_by_losses(
                    state.scene, fine, state.belief, losses, self.config, want_covariance=want_covariance
                )
            )

    def _conclude(self, fine: Observations) -> WindowResult | None:
        """Adjust once more, and see what that taught."""
        if len(fine) < self.config.result.min_inliers:
            return None
        covariance = self._adjust_finely(fine, want_covariance=True)
        tracked = len(self.state.tracks)
        result = conclude(self.state.scene, fine, covariance, tracked, self.config.result)
        return result and replace(result, scale_information=self.state.scale_information)
