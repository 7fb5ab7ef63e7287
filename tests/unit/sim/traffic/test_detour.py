"""Walkers go round what stands in their way, on the pavement."""

from __future__ import annotations

import numpy as np
from shapely.geometry import LineString, Polygon

from sim.streets.footprint import rectangle_m
from sim.streets.path import straight_path
from sim.traffic.detour import obstacles_of, round_obstacles

ROAD = Polygon([(-5, -8), (45, -8), (45, -1.3), (-5, -1.3)])  # its kerb 1.3 m to the right
BENCH_M = rectangle_m(np.array([20.0, 0.3]), 0.0, 1.6, 0.6)


def test_a_bench_is_passed_at_a_distance() -> None:
    path = straight_path(np.zeros(2), 0.0, 40.0)
    (walked,) = round_obstacles([path], obstacles_of([BENCH_M], ROAD))
    line = LineString(walked.points_m)
    assert line.distance(Polygon(BENCH_M)) > 0.2
    assert line.distance(ROAD) > 0.2
    assert np.abs(walked.points_m[[0, -1], 1]).max() < 0.05


def test_a_free_pavement_is_walked_straight() -> None:
    path = straight_path(np.zeros(2), 0.0, 40.0)
    assert round_obstacles([path], obstacles_of([], ROAD)) == [path]


def test_two_who_meet_at_a_bench_have_room() -> None:
    there, back = (straight_path(np.array([0.0, y]), 0.0, 40.0) for y in (-0.35, 0.35))
    bin_m = rectangle_m(np.array([20.0, 0.9]), 0.0, 0.5, 0.8)
    walked = round_obstacles([there, back], obstacles_of([bin_m], Polygon(ROAD.exterior.coords).buffer(-0.2)))
    middle = [LineString(path.points_m[150:250]) for path in walked]
    assert middle[0].distance(middle[1]) > 0.5
    assert middle[1].distance(Polygon(bin_m)) > 0.2
