"""Steer along a route: the curvature that lies ahead, corrected for being beside the route or askew on it.

Works on the rear axle, whose motion is the same forwards and backwards.

Reference: Snider 2009, "Automatic Steering Methods for Autonomous Automobile Path Tracking", sec. 2.4.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.vehicle.route import Route

_CORRECT_WITHIN_S = 0.4  # deviations decay over the distance driven in this time, or over the shortest one
_SHORTEST_M = 2.0
_PREVIEW_S = 0.1  # what steering and tyres lag behind
_FURTHEST_ASTRAY_M = 3.0
_SURE_MPS = 2.0  # below it the car's axis is a better direction of travel than its velocity


class Follower:
    """Follows one route; remembers how far along it is, so loops may cross and be driven again and again.

    Attributes:
        progress_m: How far along the route the rear axle is; negative before its first point.
        aside_m: How far to the left of it.
    """

    def __init__(self, route: Route, wheelbase_m: float, start_m: float) -> None:
        self._route, self._wheelbase_m = route, wheelbase_m
        self.progress_m, self.aside_m = start_m, 0.0

    def steer_rad(self, position_m: Array, velocity_mps: Array, heading: Array) -> float:
        """Return the bicycle-model steering angle that leads the rear axle along the route.

        Args:
            position_m: (2,) of the rear axle, in the world.
            velocity_mps: (2,) of the rear axle, in the world.
            heading: (2,) where the car looks, in the world; a unit vector.
        """
        speed_mps = float(np.hypot(*velocity_mps))
        self.progress_m = self._route.nearest_m(position_m, self.progress_m)
        direction = self._route.direction(self.progress_m)
        looks = 1.0 if direction @ heading > 0 else -1.0  # along the route, or against it: in reverse
        # In bends the tyres slip, and the axle moves elsewhere than it points.
        travel = velocity_mps / speed_mps if speed_mps > _SURE_MPS else looks * heading
        aside_m = _cross(direction, position_m - self._route.point_m(self.progress_m))
        askew = _cross(direction, travel)  # sine of the angle
        over_m = max(_SHORTEST_M, _CORRECT_WITHIN_S * speed_mps)
        self.aside_m = aside_m
        aside_m = min(max(aside_m, -_FURTHEST_ASTRAY_M), _FURTHEST_ASTRAY_M)
        ahead_pm = float(self._route.curvature_pm(self.progress_m + _PREVIEW_S * speed_mps))
        curvature_pm = ahead_pm - 2 * askew / over_m - aside_m / over_m**2
        steer_rad = float(np.arctan(self._wheelbase_m * curvature_pm))
        return looks * steer_rad


def _cross(one: Array, other: Array) -> float:
    return float(one[0] * other[1] - one[1] * other[0])
