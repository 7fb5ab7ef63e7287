"""The first step of the car, from two views of one camera; the road under its known height gives metres."""

from __future__ import annotations

import numpy as np
import poselib

from estimator.ahead import is_ahead
from estimator.config import Config
from estimator.poselib_terms import focal_of, from_poselib, on_plane_px, pinhole
from estimator.ranges import AngleRad, PointCount, SigmaPx
from estimator.rig import MountedCamera
from estimator.road import road_scale
from estimator.se3 import SE3, Array
from estimator.track_table import TrackTable
from estimator.triangulate import triangulate


class FirstMotionConfig(Config):
    """When two views suffice to begin."""

    min_points: PointCount = 30
    parallax_rad: AngleRad = 0.015
    max_error_px: SigmaPx = 1.0


def first_motion(tracks: TrackTable, mounted: MountedCamera, config: FirstMotionConfig) -> SE3 | None:
    """Return the car's motion ``start_from_now`` since its tracks were anchored, in metres.

    None while the views are too alike, too few tracks agree on one motion, or no road shows its length.
    """
    usable = is_ahead(tracks.rays_cam) & is_ahead(tracks.anchor_rays_cam)
    usable &= np.isfinite(tracks.anchor_center_world).all(1)
    if usable.sum() < config.min_points:
        return None
    first_cam, last_cam = tracks.anchor_rays_cam[usable], tracks.rays_cam[usable]
    first_from_last, inliers = _relative_pose(first_cam, last_cam, mounted, config)
    turned = last_cam @ first_from_last.rotation.T
    parallax = np.arccos(np.clip(np.einsum("ni,ni->n", first_cam, turned), -1, 1))
    if inliers.sum() < config.min_points or np.percentile(parallax[inliers], 70) < config.parallax_rad:
        return None
    scale = _scale(first_cam[inliers], turned[inliers], first_from_last, mounted.ego_from_cam)
    if scale is None:
        return None
    first_from_last = SE3(first_from_last.rotation, first_from_last.translation * scale)
    return mounted.ego_from_cam @ first_from_last @ mounted.ego_from_cam.inverse()


def _relative_pose(
    first_cam: Array, last_cam: Array, mounted: MountedCamera, config: FirstMotionConfig
) -> tuple[SE3, Array]:
    """Return ``first_from_last`` with a translation of no known length, and which rays agree with it."""
    focal_px = focal_of(mounted.camera)
    pose, info = poselib.estimate_relative_pose(
        on_plane_px(first_cam, focal_px),
        on_plane_px(last_cam, focal_px),
        pinhole(focal_px),
        pinhole(focal_px),
        {"max_epipolar_error": config.max_error_px, "seed": 1},
        {"loss_type": "CAUCHY", "loss_scale": 0.5},
    )
    return from_poselib(pose).inverse(), np.array(info["inliers"], bool)


def _scale(first_cam: Array, turned: Array, first_from_last: SE3, ego_from_cam: SE3) -> float | None:
    count = len(first_cam)
    index = np.tile(np.arange(count), 2)
    centers = np.vstack([np.zeros((count, 3)), np.tile(first_from_last.translation, (count, 1))])
    points, angle = triangulate(index, np.vstack([first_cam, turned]), centers, count)
    points = points[angle > 0.005]
    level = points @ ego_from_cam.rotation.T
    # No metre yet: what is steeply below in the direction of travel is taken for the car's path.
    heading = ego_from_cam.rotation @ first_from_last.translation
    beside = np.abs(level @ np.array([-heading[1], heading[0], 0.0])) / np.hypot(*heading[:2])
    return road_scale(level, beside < -level[:, 2], float(ego_from_cam.translation[2]))
