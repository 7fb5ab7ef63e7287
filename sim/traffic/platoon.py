"""The vehicles before and behind the driven car in its own lane, tied to the car's plan.

Each does what the one before it does, a moment later and some metres further back, so none ever runs into
another, whatever the car's speed does; those ahead know the plan and do it earlier.

Reference:
    Newell 2002, A simplified car-following theory: a lower order model, Transportation Research B 36.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.traffic.config import PLATOON_GAP_M, PLATOON_GAP_S, at_degree
from sim.traffic.track import Track

EGO_FRONT_M, EGO_REAR_M = 3.45, 1.0  # bumpers from the origin of ego
_TRACKING_M = 1.5  # how far the car may be from its plan, and then some
_VIEW_AHEAD_M, _VIEW_BEHIND_M = 140.0, 70.0
_MOST_AHEAD, _MOST_BEHIND = 9, 5

Progress = Callable[[float], float]


@dataclass(frozen=True)
class Member:
    """A vehicle tied to the driven car.

    Attributes:
        model: Its place in the list of lengths.
        length_m: From bumper to bumper.
        lead_s: How much earlier than the car it does the same; negative behind.
        ahead_m: How much further along the lane its middle is then than the origin of ego.
    """

    model: int
    length_m: float
    lead_s: float
    ahead_m: float


class Platoon:
    """Everything in the driven lane, the driven car included; all of it known for all times."""

    def __init__(self, route: Track, progress_m: Progress, members: Sequence[Member]) -> None:
        """Take the route and the car's planned progress along it; progress 0 is s = 0 of the path."""
        self.tracks, self.members, self._progress_m = (route,), tuple(members), progress_m
        self._origin_m = route.beyond_m - route.path.start_m

    def way_m(self, time_s: float) -> Array:
        """(N,) u of the members' middles, the driven car not among them."""
        return self._origin_m + np.array(
            [self._progress_m(time_s + m.lead_s) + m.ahead_m for m in self.members]
        )

    def swept_m(self, track: int, from_s: float, to_s: float) -> Array:
        times = np.linspace(from_s, to_s, 5)
        ego = np.array([self._progress_m(float(t)) for t in times]) + self._origin_m
        spans = [(ego.min() - EGO_REAR_M - _TRACKING_M, ego.max() + EGO_FRONT_M + _TRACKING_M)]
        middles = np.array([self.way_m(float(t)) for t in times])
        for k, member in enumerate(self.members):
            half = member.length_m / 2 + 0.5
            spans.append((middles[:, k].min() - half, middles[:, k].max() + half))
        swept = np.array(spans)
        if self.tracks[0].closed:
            return swept
        ring = self.tracks[0].ring_m
        return swept[(swept[:, 1] > 0) & (swept[:, 0] < ring)].clip(0.0, ring - 1e-6)


def draw_members(
    degree: float, lengths_m: Sequence[float], room_m: float, top_mps: float, rng: np.random.Generator
) -> list[Member]:
    """Draw the vehicles before and behind the driven car.

    Args:
        degree: Density of cars; 0 gives none.
        lengths_m: Of the models to choose from.
        room_m: Length of a closed lane; infinite for an open one.
        top_mps: The car's highest speed.
        rng: Source of randomness.
    """
    if degree == 0:
        return []
    gap_m, gap_s = at_degree(PLATOON_GAP_M, degree), at_degree(PLATOON_GAP_S, max(degree, 1.0))
    ahead, behind = rng.spawn(2)
    order = [int(k) for k in rng.permutation(len(lengths_m))]  # whose ends do not meet before all have come
    leaders = _row(ahead, order, lengths_m, gap_m, gap_s, EGO_FRONT_M, _MOST_AHEAD, _VIEW_AHEAD_M)
    followers = _row(behind, order[::-1], lengths_m, gap_m, gap_s, EGO_REAR_M, _MOST_BEHIND, _VIEW_BEHIND_M)
    members = leaders + [Member(m.model, m.length_m, -m.lead_s, -m.ahead_m) for m in followers]

    def takes_m(kept: Sequence[Member]) -> float:
        return sum(m.length_m + gap_m * 1.3 + gap_s * 1.3 * top_mps for m in kept) + 30.0

    while members and takes_m(members) > room_m:
        members.pop()
    return members


def _row(
    rng: np.random.Generator,
    order: Sequence[int],
    lengths_m: Sequence[float],
    gap_m: float,
    gap_s: float,
    bumper_m: float,
    most: int,
    view_m: float,
) -> list[Member]:
    row: list[Member] = []
    time_s, way_m = 0.0, bumper_m
    while len(row) < most and way_m < view_m:
        model = order[len(row) % len(order)]
        wait_s, room_m = gap_s * rng.uniform(0.8, 1.3), gap_m * rng.uniform(0.8, 1.3)
        time_s, way_m = time_s + wait_s, way_m + room_m + lengths_m[model] / 2
        row.append(Member(model, lengths_m[model], time_s, way_m))
        way_m += lengths_m[model] / 2
    return row
