"""Where the car is, from what all trusted cameras see of points whose place is known.

One narrow camera sees a strip of the street and may lose it in a turn, behind a lorry or in glare; seven see
all around, and what one of them takes for the world, a car beside it, the others outvote.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import poselib

from estimator.config import Config
from estimator.observations import Mask
from estimator.poselib_terms import focal_of, from_poselib, on_plane_px, pinhole, to_poselib
from estimator.ranges import PointCount, PositiveCount, Share, SigmaPx
from estimator.rig import Rig
from estimator.se3 import SE3, Array


class RigPoseConfig(Config):
    """What counts as agreement, and how much of it is enough."""

    max_error_px: SigmaPx = 1.5
    loss_px: SigmaPx = 0.7
    iterations: PositiveCount = 200
    min_inliers: PointCount = 40
    min_share: Share = 0.3


@dataclass(frozen=True, eq=False)
class Sight:
    """What one camera sees of known points.

    Attributes:
        rays_cam: (N, 3) unit rays within 80 deg of the optical axis.
        points_world: (N, 3) the points they go to.
    """

    rays_cam: Array
    points_world: Array


@dataclass(frozen=True, eq=False)
class RigPose:
    """The pose of the car, and by camera (N,) which of its points agree with it."""

    world_from_ego: SE3
    agrees: Mapping[str, Mask]


def fit_rig_pose(rig: Rig, sights: Mapping[str, Sight], start: SE3, config: RigPoseConfig) -> RigPose | None:
    """Fit the car's pose to all cameras at once by RANSAC over the generalized camera.

    Args:
        rig: The cameras with their extrinsics as believed.
        sights: By camera.
        start: Where the car is thought to be.
        config: Limits.

    Returns:
        The pose, or None where too few points agree on one.

    Reference:
        Nister & Stewenius 2007 (generalized three-point pose); solver and local optimisation by PoseLib.
    """
    names = [name for name, sight in sights.items() if len(sight.rays_cam)]
    count = sum(len(sights[name].rays_cam) for name in names)
    if count < config.min_inliers:
        return None
    focal_px = {name: focal_of(rig[name].camera) for name in names}
    pixels = [on_plane_px(sights[name].rays_cam, focal_px[name]) for name in names]
    points = [sights[name].points_world for name in names]
    mounts = [to_poselib(rig[name].ego_from_cam.inverse()) for name in names]
    pinholes = [pinhole(focal_px[name]) for name in names]
    loss = {"loss_type": "CAUCHY", "loss_scale": config.loss_px}
    ransac = {"max_reproj_error": config.max_error_px, "max_iterations": config.iterations, "seed": 1}
    begin = to_poselib(start.inverse())
    _, info = poselib.estimate_generalized_absolute_pose(
        pixels, points, mounts, pinholes, ransac, loss, begin
    )
    if info["num_inliers"] < max(config.min_inliers, config.min_share * count):
        return None
    inliers = [np.array(mask, bool) for mask in info["inliers"]]
    # The last bits of RANSAC's own pose differ from call to call; those of a fit that starts here do not.
    pose, _ = poselib.refine_generalized_absolute_pose(
        [each[mask] for each, mask in zip(pixels, inliers, strict=True)],
        [each[mask] for each, mask in zip(points, inliers, strict=True)],
        begin,
        mounts,
        pinholes,
        loss,
    )
    world_from_ego = from_poselib(pose).inverse()
    agrees = {
        name: focal_px[name] * _angles_rad(sights[name], world_from_ego @ rig[name].ego_from_cam)
        < config.max_error_px
        for name in names
    }
    return RigPose(world_from_ego, agrees)


def _angles_rad(sight: Sight, world_from_cam: SE3) -> Array:
    """Return (N,) how far each ray passes by its point; a distance on the plane would wrong wide lenses."""
    towards = world_from_cam.inverse().apply(sight.points_world)
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    return np.asarray(np.linalg.norm(towards - sight.rays_cam, axis=1))
