"""The two paths of the report's map, brought together, and the car at a few places along them."""

from __future__ import annotations

from typing import Any

import numpy as np

from estimator.se3 import SE3, Array
from eval.align import align_on_ground
from eval.collect import RunLog
from eval.metrics_motion import paired
from eval.paths import estimated_path, true_path
from eval.trajectory import Trajectory
from eval.truth import TruthTrack

_MAX_POINTS = 600
_PLACES = (0.0, 0.33, 0.67, 1.0)


def map_paths(log: RunLog, truth: TruthTrack | None) -> dict[str, Any]:
    """Return the estimated path, turned and shifted onto the true one where there is truth."""
    estimated, true = estimated_path(log), true_path(truth)
    both = None if true is None else paired(estimated, true)
    if both is None:
        return {"estimated": _shape(estimated), "true": None if true is None else _shape(true)}
    estimated, true = both
    moved = _moved(estimated, align_on_ground(estimated.positions_world, true.positions_world))
    apart_m = np.linalg.norm(moved.positions_world - true.positions_world, axis=1)
    kept = _kept(len(true))
    return {
        "estimated": _shape(moved),
        "true": _shape(true),
        "apart_m": [round(float(x), 5) for x in apart_m[kept]],
        "driven_m": [round(float(x), 3) for x in true.distance_m[kept]],
    }


def _moved(path: Trajectory, b_from_a: SE3) -> Trajectory:
    return Trajectory(
        path.stamps_ns, b_from_a.apply(path.positions_world), np.asarray(b_from_a.rotation @ path.rotations)
    )


def _shape(path: Trajectory) -> dict[str, Any]:
    """Return x and y of the path, and x, y, yaw of the car at four places."""
    if not len(path):
        return {"x_m": [], "y_m": [], "places": []}
    kept = _kept(len(path))
    driven = path.distance_m
    places = [int(np.searchsorted(driven, share * driven[-1])) for share in _PLACES]
    return {
        "x_m": [round(float(x), 3) for x in path.positions_world[kept, 0]],
        "y_m": [round(float(y), 3) for y in path.positions_world[kept, 1]],
        "places": [_place(path.pose(min(index, len(path) - 1))) for index in places],
    }


def _place(world_from_ego: SE3) -> list[float]:
    forward: Array = world_from_ego.rotation[:, 0]
    x, y, _ = world_from_ego.translation
    return [float(x), float(y), float(np.arctan2(forward[1], forward[0]))]


def _kept(count: int) -> Array:
    return np.unique(np.linspace(0, count - 1, _MAX_POINTS).astype(int))
