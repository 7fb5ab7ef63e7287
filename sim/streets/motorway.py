"""A motorway: two or three lanes each way, hard shoulders, barriers, no kerbs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sim.streets.lane_rules import car_lanes
from sim.streets.network import Lane
from sim.streets.path import STEP_M, Path, bend_curvature, bend_length_m, path_from_curvature
from sim.streets.plan import Plan
from sim.streets.road import Road, Strip

LANE_M = 3.6
SHOULDER_M = 2.8
MARGIN_M = 0.9  # left of the leftmost lane
MEDIAN_M = 3.2
VERGE_M = 7.0
BEHIND_M = 150.0
BEYOND_M = 250.0
_RAMP_M = 60.0
_SPEEDS_MPS = (24.0, 29.0, 34.0)  # from the right lane to the left one


def plan_motorway(length_m: float, rng: np.random.Generator) -> Plan:
    """A motorway that winds gently; the car keeps to the right lane or the one beside it."""
    count, driven = int(rng.choice([2, 3])), int(rng.choice([0, 1]))
    path = _path(length_m, rng)
    own = _carriageway("main", path, count, driven, (0.04, 0.02))
    # The other carriageway's path is its own right lane; both turn their left edges to the median.
    apart = own.left_m + MEDIAN_M + MARGIN_M + (count - 0.5) * LANE_M
    other = _carriageway("opposite", path.offset(apart, backwards=True), count, 0, (0.06, 0.03))
    return Plan((own, other), (), path, (*_lanes(own, 0.0), *_lanes(other, None)), corner_m=0.0)


def _path(length_m: float, rng: np.random.Generator) -> Path:
    s_m = np.arange(-BEHIND_M, length_m + BEYOND_M + STEP_M / 2, STEP_M)
    curvature, turn, at = np.zeros(len(s_m)), float(rng.choice([-1.0, 1.0])), float(rng.uniform(10.0, 60.0))
    while at < length_m + BEYOND_M:
        radius, angle = float(rng.uniform(450.0, 800.0)), turn * np.deg2rad(rng.uniform(15.0, 22.0))
        curvature += bend_curvature(s_m, at, angle, radius, _RAMP_M)
        at, turn = at + bend_length_m(angle, radius, _RAMP_M) + float(rng.uniform(40.0, 120.0)), -turn
    return path_from_curvature(-BEHIND_M, curvature)


def _carriageway(name: str, path: Path, count: int, own: int, texel_m: tuple[float, float]) -> Road:
    """One direction; lanes are counted from the right, and the path runs along number ``own``."""
    strips = tuple(Strip((k - own) * LANE_M, True, LANE_M) for k in range(count))
    right = -(own + 0.5) * LANE_M - SHOULDER_M
    left = (count - own - 0.5) * LANE_M + MARGIN_M
    return Road(
        name,
        "motorway",
        path,
        left,
        right,
        strips,
        (path.start_m, path.end_m),
        (MEDIAN_M / 2, VERGE_M),
        wear=0.3,
        linings=("barrier", "barrier"),
        kerb_m=0.0,
        texel_m=texel_m,
    )


def _lanes(road: Road, route_d_m: float | None) -> list[Lane]:
    lanes = car_lanes(road, 0.0, route_d_m)
    return [replace(lane, speed_mps=speed) for lane, speed in zip(lanes, _SPEEDS_MPS, strict=False)]
