"""Tell tracks of the car itself, which keep their pixel, from points of the street that hardly move.

What is far away straight ahead stands still too, and so does the sky while the car drives straight. What sets
the car apart is that it does not even follow the car's turning and nodding, and that it stands where the road
should pass below.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.config import Config
from estimator.ranges import LengthM, Share, SizePx
from estimator.se3 import SE3, Array
from estimator.track_table import TrackTable

_NO_WAY = 1e-12


class StillConfig(Config):
    """What counts as standing still, over which way, and how clearly a street would have moved.

    ``unsure_slope`` is how far the road may lie off the plane under the wheels, seen along a ray: by its own
    slope, and by the pitch that a rig file has wrong.
    """

    min_travel_m: LengthM = 0.4
    still_px: SizePx = 1.0
    clear_px: SizePx = 3.0
    clear_share_of_turn: Share = 0.15
    unsure_slope: Share = 0.07


def not_of_the_street(
    tracks: TrackTable, focal_px: float, world_from_ego: SE3, ego_from_cam: SE3, config: StillConfig
) -> npt.NDArray[np.bool_]:
    """Return (N,) which tracks kept their pixel where no point of the street could have.

    A point of the street lies somewhere on its ray: beyond the camera, and no further than the road that the
    ray meets. All those places appear along an arc from where the track began; the track must be clear of it.

    Args:
        tracks: Live tracks; those whose first view has no pose yet are not told.
        focal_px: What turns angles into pixels.
        world_from_ego: The car's pose now.
        ego_from_cam: The camera on the car, as believed.
        config: Limits.
    """
    world_from_cam = world_from_ego @ ego_from_cam
    way_world = world_from_cam.translation - tracks.anchor_center_world
    still = np.linalg.norm(tracks.pixels - tracks.anchor_pixels, axis=1) < config.still_px
    still &= np.linalg.norm(way_world, axis=1) > config.min_travel_m  # false for NaN
    result = np.zeros(len(tracks), bool)
    rows = np.flatnonzero(still)
    rays_world = tracks.rays_cam[rows] @ world_from_cam.rotation.T
    anchor_from_world = np.swapaxes(tracks.anchor_rotation[rows], 1, 2)
    farness = _least_inverse_m(tracks.rays_cam[rows], ego_from_cam, config.unsure_slope)
    nearest = _unit((anchor_from_world @ way_world[rows, :, None])[..., 0])
    turned = (anchor_from_world @ rays_world[..., None])[..., 0]
    farthest = turned + farness[:, None] * (anchor_from_world @ way_world[rows, :, None])[..., 0]
    began = tracks.anchor_rays_cam[rows]
    off_px = focal_px * _angle_to_arc(began, _unit(farthest), nearest)
    turn_px = focal_px * np.linalg.norm(turned - began, axis=1)
    result[rows] = off_px > np.maximum(config.clear_px, config.clear_share_of_turn * turn_px)
    return result


def _least_inverse_m(rays_cam: Array, ego_from_cam: SE3, unsure_slope: float) -> Array:
    """Return (N,) one over the distance of the road along rays, as far as it may be; 0 for none at all."""
    down = -(rays_cam @ ego_from_cam.rotation.T)[:, 2]
    height_m = max(float(ego_from_cam.translation[2]), 0.3)
    return np.maximum(down - unsure_slope, 0.0) / height_m


def _angle_to_arc(rays: Array, start: Array, end: Array) -> Array:
    """Return (N,) the angle in rad between unit rays and the shorter arcs from ``start`` to ``end``."""
    normal = np.cross(start, end)
    beside = (np.cross(normal, start) * rays).sum(1) > 0
    beside &= (np.cross(end, normal) * rays).sum(1) > 0
    across = np.arcsin(np.clip(np.abs((_unit(normal) * rays).sum(1)), 0, 1))
    ends = np.minimum(np.linalg.norm(rays - start, axis=1), np.linalg.norm(rays - end, axis=1))
    return np.asarray(np.where(beside, across, ends))


def _unit(vectors: Array) -> Array:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), _NO_WAY))
