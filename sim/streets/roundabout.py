"""A roundabout with four arms: the car enters, goes round the island, and leaves straight on or left."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.streets.junctions import Joint
from sim.streets.network import Lane
from sim.streets.path import Path, path_through, straight_path
from sim.streets.plan import Plan
from sim.streets.road import LANE_M, Road, Strip
from sim.streets.rounded import smoothed
from sim.streets.side_road import minor_road
from sim.streets.town_streets import BEHIND_M, BEYOND_M, TOWN_SPEED_MPS
from sim.streets.turning import giving_way

_RING_M = 12.5  # radius of the lane round the island
_RING_HALF_M = 3.1
_FLARE_M = 11.5  # radius on which one enters and leaves
_RAMP_M = 6.0  # over which a turn sets in: drivers cut what corners the ring leaves
_ARM_HALF_M = 3.3
_SIDE_ARM_M = 55.0
_RING_SPEED_MPS = 6.0
_SEAM_RAD = np.pi / 4  # where the ring's s begins: between two arms


def plan_roundabout(length_m: float, rng: np.random.Generator) -> Plan:
    """The first arm comes along the x axis; the others stand at about right angles to it."""
    middle = np.array([float(rng.uniform(33.0, 36.0)), LANE_M / 2])
    jitter = rng.uniform(-0.16, 0.16, 4)
    angles = np.array([np.pi, -np.pi / 2, 0.0, np.pi / 2]) + jitter * [0.0, 1.0, 1.0, 1.0]
    exit_arm = int(rng.choice([2, 3]))
    lengths = [middle[0] + BEHIND_M, _SIDE_ARM_M, _SIDE_ARM_M, _SIDE_ARM_M]
    lengths[exit_arm] = max(_SIDE_ARM_M, length_m - middle[0] + BEYOND_M)
    ring = _ring(middle)
    arms = [_arm(k, middle, float(a), n) for k, (a, n) in enumerate(zip(angles, lengths, strict=True))]
    joints = tuple(
        Joint(arm.name, "ring", _RING_M * float((a - _SEAM_RAD) % (2 * np.pi)), -1, zebra_before=False)
        for arm, a in zip(arms, angles, strict=True)
    )
    route = _way(middle, angles, lengths, 0, exit_arm)
    start = Path(-BEHIND_M, route.points_m, route.headings_rad, route.step_m)
    others = [
        giving_way(Lane("car", _way(middle, angles, lengths, k, (k + 2) % 4), _RING_SPEED_MPS), ring)
        for k in range(4)
        if (k, (k + 2) % 4) != (0, exit_arm)
    ]
    lanes = (Lane("car", start, TOWN_SPEED_MPS, is_route=True), *others)
    return Plan((ring, *arms), joints, start, lanes)


def _ring(middle_m: Array) -> Road:
    angles = _SEAM_RAD + np.linspace(0, 2 * np.pi, 721)
    path = path_through(middle_m + _RING_M * np.stack([np.cos(angles), np.sin(angles)], axis=1), True)
    return Road(
        "ring",
        "ring",
        path,
        _RING_HALF_M,
        -_RING_HALF_M,
        (Strip(0.0, True, 5.0),),
        (path.start_m, path.end_m),
        (1.6, 2.6),
        linings=("island", "houses"),
    )


def _arm(index: int, middle_m: Array, angle: float, length_m: float) -> Road:
    start = middle_m + _RING_M * np.array([np.cos(angle), np.sin(angle)])
    return minor_road(f"arm_{index}", straight_path(start, angle, length_m - _RING_M), _ARM_HALF_M)


def _way(middle_m: Array, angles: Array, lengths_m: list[float], entry: int, leave: int) -> Path:
    """From the end of one arm round the island to the end of another, on the right of each."""
    ahead = _approach(lengths_m[entry])
    back = _approach(lengths_m[leave])[::-1] * [1.0, -1.0]
    first = _turned(ahead, float(angles[entry]) - np.pi)
    last = _turned(back, float(angles[leave]) - np.pi)
    start, stop = (np.arctan2(point[1], point[0]) for point in (first[-1], last[0]))
    stop = start + (stop - start) % (2 * np.pi)
    on_ring = np.linspace(start, stop, max(4, round((stop - start) * 40)))[1:-1]
    ring = _RING_M * np.stack([np.cos(on_ring), np.sin(on_ring)], axis=1)
    return smoothed(path_through(middle_m + np.vstack([first, ring, last])), _RAMP_M)


def _approach(length_m: float) -> Array:
    """Along the right lane of an arm from -x, then right onto the ring round the origin; (N, 2) points."""
    offset = LANE_M / 2
    x = -np.sqrt((_RING_M + _FLARE_M) ** 2 - (offset + _FLARE_M) ** 2)
    center = np.array([x, -offset - _FLARE_M])
    touch = np.arctan2(-center[1], -center[0])  # from the flare's middle towards the island
    angles = np.linspace(np.pi / 2, touch, 40)
    flare = center + _FLARE_M * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return np.vstack([[-length_m, -offset], flare])


def _turned(points_m: Array, angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.asarray(points_m @ np.array([[c, s], [-s, c]]))
