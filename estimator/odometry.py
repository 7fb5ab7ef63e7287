"""Where the car goes, from the reference camera alone.

Two views start it, the road under the known camera height gives it metres, and from then on each frame's
pose is fitted to the points already known. Drift is not its business: the windows correct it.
"""

from __future__ import annotations

import numpy as np
import poselib

from estimator.ahead import is_ahead
from estimator.config import Config
from estimator.first_motion import FirstMotionConfig, first_motion
from estimator.poselib_terms import focal_of, from_poselib, on_plane_px, pinhole, to_poselib
from estimator.ranges import PointCount, SigmaPx
from estimator.rig import MountedCamera
from estimator.se3 import SE3, Array
from estimator.tracker import Tracker


class OdometryConfig(Config):
    """When two views suffice to begin, and what counts as agreement afterwards."""

    first_motion: FirstMotionConfig = FirstMotionConfig()
    min_points: PointCount = 10
    max_error_px: SigmaPx = 1.5


class Odometry:
    """The pose of the car at every bundle, in a world whose origin is the car's first pose."""

    def __init__(self, mounted: MountedCamera, config: OdometryConfig) -> None:
        self.mounted = mounted
        self.config = config
        self.world_from_ego = SE3()
        self._last_step = SE3()
        self._known = SE3()  # the last pose that was measured, and how many bundles ago that was
        self._bundles_since = 0
        self._before = SE3(), 1  # the one measured before it, and how many bundles lie between
        self.metric = False
        self.lost_count = 0

    def restart(self) -> None:
        """Begin again from the present pose, as with the first image."""
        self._last_step = SE3()
        self.metric = False
        self.lost_count = 0

    @property
    def predicted_world_from_ego(self) -> SE3:
        """The pose one step on, if the car keeps doing what it did."""
        return self.world_from_ego @ self._last_step if self.metric else self.world_from_ego

    @property
    def step_m(self) -> float:
        """How far the car moved between the last two bundles."""
        return float(np.linalg.norm(self._last_step.translation))

    def advance(self, tracker: Tracker) -> bool:
        """Take the reference camera's tracks in a new image; say whether the pose is known.

        Where the image is missing and the tracks wait for the next one, the car is taken to go on as before.
        """
        waiting = not tracker.current and len(tracker.tracks) > 0
        if not self.metric:
            return not waiting and self._start(tracker)
        self._bundles_since += 1
        if waiting:
            self.world_from_ego = self.predicted_world_from_ego
            return False
        tracks, known = tracker.tracks, tracker.tracks.located
        pose = None
        if known.sum() >= self.config.min_points:
            pose = self._fit(tracks.rays_cam[known], tracks.points_world[known])
        if pose is None:
            self.lost_count += 1
            self.world_from_ego = self.predicted_world_from_ego
            return False
        self._step_to(pose)
        return True

    def settle(self, world_from_ego: SE3) -> None:
        """Take over what all cameras together say of the newest bundle's pose."""
        if self._bundles_since == 0:  # the reference camera has said something of it already
            self._known, self._bundles_since = self._before
        self._step_to(world_from_ego)

    def _step_to(self, pose: SE3) -> None:
        self._before = self._known, self._bundles_since
        self._last_step = SE3.exp((self._known.inverse() @ pose).log() / self._bundles_since)
        self._note(pose)
        self.lost_count = 0

    def _note(self, pose: SE3) -> None:
        self.world_from_ego = self._known = pose
        self._bundles_since = 0

    def correct(self, world_from_ego: SE3, step_scale: float) -> None:
        """Take over a pose of the newest bundle that a window found better, and its scale."""
        self._note(world_from_ego)
        self._last_step = SE3(self._last_step.rotation, self._last_step.translation * step_scale)

    def _fit(self, rays_cam: Array, points_world: Array) -> SE3 | None:
        focal_px = focal_of(self.mounted.camera)
        ahead = is_ahead(rays_cam)
        predicted = (self.predicted_world_from_ego @ self.mounted.ego_from_cam).inverse()
        pose, info = poselib.estimate_absolute_pose(
            on_plane_px(rays_cam[ahead], focal_px),
            points_world[ahead],
            pinhole(focal_px),
            {"max_reproj_error": self.config.max_error_px, "max_iterations": 500, "seed": 1},
            {"loss_type": "CAUCHY", "loss_scale": 0.7},
            to_poselib(predicted),
        )
        if info["num_inliers"] < self.config.min_points:
            return None
        return from_poselib(pose).inverse() @ self.mounted.ego_from_cam.inverse()

    def _start(self, tracker: Tracker) -> bool:
        """Find the motion since the first image, and its length from the road."""
        step = first_motion(tracker.tracks, self.mounted, self.config.first_motion)
        if step is None:
            return False
        self._note(self.world_from_ego @ step)
        self._last_step = SE3()
        self.metric = True
        tracker.locate(self.world_from_ego @ self.mounted.ego_from_cam)
        return True
