"""The planned speed of a drive: where the car means to be at every time, before it is driven.

The driver tracks it; traffic may look ahead in it. Speeds obey cruising speed, bends and stops, and the
limits of the driver's manner; then they are smoothed in time as a foot on a pedal does.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.vehicle.drive import DriveConfig
from sim.vehicle.manner import Manner, cruising_mps, manner_of
from sim.vehicle.route import Route

_STEP_S = 0.02
_STEP_M = 0.2
_BEYOND_S = 2.0  # planned past the end, since shutters close after the last bundle
_SLOWEST_MPS = 0.05


@dataclass(frozen=True, eq=False)
class SpeedPlan:
    """Speed and distance every ``_STEP_S`` from time zero on.

    Attributes:
        speeds_mps: (N,) planned.
        distances_m: (N,) their integral.
        duration_s: When ``drive.distance_m`` is reached.
    """

    speeds_mps: Array
    distances_m: Array
    duration_s: float

    def speed_mps(self, time_s: float) -> float:
        """Planned speed at a time; before and after the plan it is that of its ends."""
        return _at(self.speeds_mps, time_s)

    def acceleration_mps2(self, time_s: float) -> float:
        """Planned acceleration at a time."""
        return (self.speed_mps(time_s + _STEP_S) - self.speed_mps(time_s - _STEP_S)) / (2 * _STEP_S)

    def distance_m(self, time_s: float) -> float:
        """Planned distance driven since time zero; negative before it."""
        end_s = _STEP_S * (len(self.speeds_mps) - 1)
        beyond_s = time_s - min(max(time_s, 0.0), end_s)
        return _at(self.distances_m, time_s) + beyond_s * self.speed_mps(time_s)

    def bundle_count(self, rate_hz: float) -> int:
        """Bundles from time zero on until the distance is driven."""
        return int(self.duration_s * rate_hz + 1e-6) + 1


def plan_speed(config: DriveConfig, route: Route) -> SpeedPlan:
    """Plan a drive along a route from its first point on."""
    manner = manner_of(config)
    end_m = config.distance_m + config.speed_mps * _BEYOND_S
    along_m = _grid_m(manner, end_m)
    speeds_mps = _speeds_by_distance(config, route, manner, along_m)
    times_s, speeds_mps = _by_time(along_m, speeds_mps, manner)
    wanted_s = np.arange(0.0, times_s[-1] + _BEYOND_S, _STEP_S)
    planned = _smooth(np.interp(wanted_s, times_s, speeds_mps), manner.pedal_s)
    distances_m = np.concatenate([[0.0], np.cumsum((planned[1:] + planned[:-1]) / 2 * _STEP_S)])
    moving = np.flatnonzero(distances_m < config.distance_m)[-1]
    part_m = distances_m[moving : moving + 2]
    share = (config.distance_m - part_m[0]) / (part_m[1] - part_m[0])
    return SpeedPlan(planned, distances_m, float((moving + share) * _STEP_S))


def _grid_m(manner: Manner, end_m: float) -> Array:
    """Distances to plan at: even, and at every stop."""
    even = np.linspace(0.0, end_m, max(2, round(end_m / _STEP_M)) + 1)
    return np.unique(np.concatenate([even, [stop.at_m for stop in manner.stops]]))


def _speeds_by_distance(config: DriveConfig, route: Route, manner: Manner, along_m: Array) -> Array:
    bend_mps = np.sqrt(manner.lateral_mps2 / np.maximum(np.abs(route.curvature_pm(along_m)), 1e-6))
    squared = np.minimum(cruising_mps(config, along_m), bend_mps) ** 2
    for stop in manner.stops:
        squared[np.searchsorted(along_m, stop.at_m)] = 0.0
    steps_m = np.diff(along_m).tolist()
    result = squared.tolist()
    for index, step_m in enumerate(steps_m):
        result[index + 1] = min(result[index + 1], result[index] + 2 * manner.push_mps2 * step_m)
    for index in range(len(steps_m) - 1, -1, -1):
        result[index] = min(result[index], result[index + 1] + 2 * manner.brake_mps2 * steps_m[index])
    return np.asarray(np.sqrt(result))


def _by_time(along_m: Array, speeds_mps: Array, manner: Manner) -> tuple[Array, Array]:
    """Return times and speeds of the grid's points, each stop twice: arriving and leaving."""
    mean_mps = np.maximum((speeds_mps[1:] + speeds_mps[:-1]) / 2, _SLOWEST_MPS)
    times_s = np.concatenate([[0.0], np.cumsum(np.diff(along_m) / mean_mps)])
    for stop in reversed(manner.stops):
        index = int(np.searchsorted(along_m, stop.at_m))
        leaving_s = (
            times_s[index:] + stop.for_s + manner.pedal_s
        )  # smoothing takes the pedal's time away again
        times_s = np.concatenate([times_s[: index + 1], leaving_s])
        speeds_mps = np.concatenate([speeds_mps[: index + 1], speeds_mps[index:]])
    return times_s, speeds_mps


def _smooth(speeds_mps: Array, over_s: float) -> Array:
    """Return the moving mean; a constant speed stays exactly itself."""
    half = round(over_s / _STEP_S / 2)
    padded = np.pad(speeds_mps, half, mode="edge")
    summed = np.concatenate([[0.0], np.cumsum(padded - speeds_mps[0])])
    width = 2 * half + 1
    return np.asarray(speeds_mps[0] + (summed[width:] - summed[:-width]) / width)


def _at(values: Array, time_s: float) -> float:
    at = min(max(time_s / _STEP_S, 0.0), len(values) - 1.0)
    before = min(int(at), len(values) - 2)
    return float(values[before] + (at - before) * (values[before + 1] - values[before]))
