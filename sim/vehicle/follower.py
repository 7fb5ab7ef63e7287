"""Steer along a path by pure pursuit, and hold a speed.

Reference: Coulter 1992, "Implementation of the Pure Pursuit Path Tracking Algorithm".
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import SE3, Array

LOOKAHEAD_S = 0.5
SHORTEST_LOOKAHEAD_M = 2.5
_SEARCH_M = 5.0


class Follower:
    """Follows one path from its start to its end; remembers how far along it is, so loops may cross.

    Before the start and beyond the end the path goes on straight.
    """

    def __init__(self, path_m: Array, wheelbase_m: float, run_up_m: float) -> None:
        """Take an (N, 2) world polyline; ``run_up_m`` of straight path are put before it."""
        self._path_m = _with_straight_ends(path_m, run_up_m, _SEARCH_M + 30.0)
        steps_m = np.linalg.norm(np.diff(self._path_m, axis=0), axis=1)
        self._along_m = np.concatenate([[0.0], np.cumsum(steps_m)])
        self._wheelbase_m = wheelbase_m
        self._progress_m = 0.0

    def steer_rad(self, world_from_ego: SE3, speed_mps: float) -> float:
        """Return the bicycle-model steering angle that leads the rear axle back to the path."""
        self._advance(world_from_ego.translation[:2])
        lookahead_m = max(SHORTEST_LOOKAHEAD_M, LOOKAHEAD_S * speed_mps)
        goal_world = self._point_at(self._progress_m + lookahead_m)
        goal_ego = world_from_ego.rotation[:2, :2].T @ (goal_world - world_from_ego.translation[:2])
        return float(np.arctan(2 * self._wheelbase_m * goal_ego[1] / (goal_ego @ goal_ego)))

    def _advance(self, position_m: Array) -> None:
        near = self._near()
        distance_m, along = _distance_to_segments(self._path_m[near], position_m)
        best = int(np.argmin(distance_m))
        start_m, end_m = self._along_m[near][best : best + 2]
        self._progress_m = max(self._progress_m, float(start_m + along[best] * (end_m - start_m)))

    def _near(self) -> slice:
        first, last = np.searchsorted(
            self._along_m, [self._progress_m - _SEARCH_M, self._progress_m + _SEARCH_M]
        )
        return slice(max(int(first) - 1, 0), int(last) + 1)

    def _point_at(self, along_m: float) -> Array:
        return np.array([np.interp(along_m, self._along_m, self._path_m[:, axis]) for axis in (0, 1)])


def _with_straight_ends(path_m: Array, before_m: float, after_m: float) -> Array:
    first = (path_m[0] - path_m[1]) / np.linalg.norm(path_m[0] - path_m[1])
    last = (path_m[-1] - path_m[-2]) / np.linalg.norm(path_m[-1] - path_m[-2])
    return np.concatenate([[path_m[0] + before_m * first], path_m, [path_m[-1] + after_m * last]])


def _distance_to_segments(path_m: Array, position_m: Array) -> tuple[Array, Array]:
    """Return the distance to each of the N - 1 segments and where on it (0 to 1) the nearest point lies."""
    start, step = path_m[:-1], np.diff(path_m, axis=0)
    along = np.clip(((position_m - start) * step).sum(1) / np.maximum((step**2).sum(1), 1e-12), 0, 1)
    return np.linalg.norm(start + along[:, None] * step - position_m, axis=1), along
