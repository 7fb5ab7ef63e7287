"""What shares the driven lane: never in the car's way, whatever its plan."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from sim.streets.path import straight_path
from sim.traffic.platoon import EGO_FRONT_M, EGO_REAR_M, Platoon, draw_members
from sim.traffic.track import track_along


def platoon(degree: float, room_m: float = np.inf) -> Platoon:
    route = track_along("car", straight_path(np.zeros(2), 0.0, 100.0), 8.0)
    members = draw_members(degree, [4.0, 6.4], room_m, 8.0, np.random.default_rng(0))
    return Platoon(route, lambda t: 4.0 * t - 4.0 * np.sin(t), members)  # stops every two pi


@pytest.mark.parametrize("degree", [0.5, 1.0, 3.0, 5.0])
def test_bumpers_never_meet(degree: float) -> None:
    row = platoon(degree)
    half = np.array([member.length_m / 2 for member in row.members])
    for t in np.arange(-5.0, 30.0, 0.3):
        s = row.way_m(float(t)) - row.tracks[0].beyond_m
        ego = 4.0 * t - 4.0 * np.sin(t)
        spans = sorted([(ego - EGO_REAR_M, ego + EGO_FRONT_M), *zip(s - half, s + half, strict=True)])
        gaps = [b[0] - a[1] for a, b in itertools.pairwise(spans)]
        assert min(gaps) > 1.5


def test_nobody_is_there_without_cars() -> None:
    assert platoon(0.0).members == ()


def test_a_short_ring_holds_fewer() -> None:
    long, short = platoon(4.0), platoon(4.0, 90.0)
    assert 0 < len(short.members) < len(long.members)


def test_what_is_swept_covers_everybody_all_the_while() -> None:
    row = platoon(3.0)
    swept = row.swept_m(0, 2.0, 4.0)
    for t in (2.0, 2.7, 4.0):
        inside = row.way_m(t)[(row.way_m(t) > 0) & (row.way_m(t) < row.tracks[0].ring_m)]
        assert all(((swept[:, 0] < u) & (u < swept[:, 1])).any() for u in inside)
