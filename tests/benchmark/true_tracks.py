"""Which tracks are true: those of a feature tracker beside where the world really went.

A track that survives need not be true. Dirt, drops and the edges of JPEG's blocks stay where they are in the
image, and are followed there without fail; so how many tracks survive says little of them. The pose of the
camera and the depth of what it sees say where each corner's point of the world must be in later frames.
"""

from __future__ import annotations

import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from eval.likeness_statistics import corners_to_follow, follow
from sim.rendering.view import FAR_M, DepthImage
from tests.benchmark.ladder_rides import LONGEST_TRACK, Ride

TRUE_WITHIN_PX = 1.5
TRUE_AFTER = (1, LONGEST_TRACK)  # frames
_SKY_M, _INFINITY_M = 0.99 * FAR_M, 1e6
_AROUND_PX, _STEP_IN_DEPTH = 2, 1.1  # a corner between two depths belongs to the nearer thing


def true_shares(ride: Ride, window: tuple[slice, slice]) -> dict[str, float]:
    """Return what share of corners is followed truly.

    Args:
        ride: The frames.
        window: Rows and columns of them that count.
    """
    of_starts = [_errors_px(ride, start, window) for start in ride.depths_m]
    return {
        f"true_share_{after}": float(np.mean([_true_share(errors[after - 1]) for errors in of_starts]))
        for after in TRUE_AFTER
    }


def shift_px(plain: Ride, spoilt: Ride, window: tuple[slice, slice]) -> float:
    """Return how far, in the mean, corners of plain frames are shifted in spoilt ones of the same instant."""
    shifts = []
    for index in plain.depths_m:
        before, after = (ride.frames[index][window] for ride in (plain, spoilt))
        points_px = corners_to_follow(before)
        if len(points_px):
            moved_px, kept = follow(before, after, points_px)
            shifts.append(np.linalg.norm((moved_px - points_px)[kept, 0], axis=1))
    return float(np.concatenate(shifts).mean()) if shifts else 0.0


def _true_share(errors_px: Array) -> float:
    return float((errors_px < TRUE_WITHIN_PX).mean()) if len(errors_px) else 0.0


def _errors_px(ride: Ride, start: int, window: tuple[slice, slice]) -> list[Array]:
    """Return (N,) px from the truth of every corner in each later frame; NaN where it is lost."""
    rows, columns = window
    corner_px = np.array([columns.start, rows.start])
    points_px = corners_to_follow(ride.frames[start][window])
    points_world = _points_world(
        points_px[:, 0] + corner_px, ride.pinhole, ride.world_from_cams[start], ride.depths_m[start]
    )
    alive = np.arange(len(points_px))
    errors = []
    for index in range(start, start + LONGEST_TRACK):
        before, after = (ride.frames[each][window] for each in (index, index + 1))
        if len(alive):
            moved_px, kept = follow(before, after, points_px)
            points_px, alive = moved_px[kept], alive[kept]
        truth_px = ride.pinhole.project(ride.world_from_cams[index + 1].inverse().apply(points_world))
        error_px = np.full(len(points_world), np.nan)
        error_px[alive] = np.linalg.norm(points_px[:, 0] + corner_px - truth_px[alive], axis=1)
        errors.append(error_px)
    return errors


def _points_world(pixels: Array, pinhole: Camera, world_from_cam: SE3, depth_m: DepthImage) -> Array:
    """Return the (N, 3) points that a picture shows at its pixels."""
    rows, columns = (np.rint(pixels[:, axis]).astype(int) for axis in (1, 0))
    reach = range(-_AROUND_PX, _AROUND_PX + 1)
    height, width = depth_m.shape
    around = [
        depth_m[np.clip(rows + down, 0, height - 1), np.clip(columns + right, 0, width - 1)]
        for down in reach
        for right in reach
    ]
    nearest_m, here_m = np.min(around, axis=0), depth_m[rows, columns]
    seen_m = np.where(here_m > _STEP_IN_DEPTH * nearest_m, nearest_m, here_m)
    distance_m = np.where(seen_m > _SKY_M, _INFINITY_M, seen_m)
    rays = pinhole.unproject(pixels)
    return np.asarray(world_from_cam.apply(rays * (distance_m / rays[:, 2])[:, None]))
