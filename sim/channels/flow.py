"""Optical flow: where what a pixel shows will be in the same camera's next image."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from estimator.se3 import Array
from sim.channels.survey import Sight, Survey
from sim.rendering.geom_picture import SKY

FlowImage = npt.NDArray[np.float32]


def flow_px(now: Survey, later: Survey, name: str) -> FlowImage:
    """Return (H, W, 2) pixels right and down from a camera's image now to its image then.

    Points ride on their geoms, so moving actors are followed, and the sky lies infinitely far away. NaN where
    the point is outside the later image or hidden there.
    """
    here, there = now.sights[name], later.sights[name]
    points_cam = _later_points_cam(now, later, here, there)
    pixels, seen = there.sees(points_cam, here.geom)
    width, height = here.camera.size_px
    start = np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 2)
    moved = np.where(seen[:, None], pixels - start, np.nan)
    return moved.reshape(height, width, 2).astype(np.float32)


def _later_points_cam(now: Survey, later: Survey, here: Sight, there: Sight) -> Array:
    """Return (N, 3) where the points of the pixels will be, in the frame that the camera then has."""
    points = here.points_cam()
    sky = here.geom == SKY
    directions_world = points[sky] @ here.world_from_cam.rotation.T
    points_world = here.world_from_cam.apply(points)
    for geom in np.unique(here.geom[~sky]):
        on_it = here.geom == geom
        before, after = now.world_from_geoms[geom], later.world_from_geoms[geom]
        if not np.array_equal(before, after):
            points_geom = (points_world[on_it] - before[:, 3]) @ before[:, :3]
            points_world[on_it] = points_geom @ after[:, :3].T + after[:, 3]
    points_cam = there.world_from_cam.inverse().apply(points_world)
    points_cam[sky] = directions_world @ there.world_from_cam.rotation
    return np.asarray(points_cam)
