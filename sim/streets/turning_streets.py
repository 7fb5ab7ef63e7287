"""Kinds whose car turns off: a T junction, and a block that it drives round and round."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.se3 import Array
from sim.streets.junctions import Joint
from sim.streets.lane_rules import car_lanes
from sim.streets.network import Lane
from sim.streets.path import Path, straight_path
from sim.streets.plan import Plan
from sim.streets.road import LANE_M, PARKING_M, Road, Strip
from sim.streets.rounded import rounded_path
from sim.streets.side_road import side_road
from sim.streets.town_streets import BEHIND_M, BEYOND_M, TOWN_SPEED_MPS, town_road
from sim.streets.turning import right_turns

_RIGHT_RADIUS_M, _LEFT_RADIUS_M = 10.0, 14.0  # on which the car turns off
_TURN_CORNER_M = 7.5  # radius of the kerbs there
_TURN_RAMP_M = 4.0  # over which the turn sets in
_TURN_PAVEMENTS_M = (3.2, 3.8)  # wide enough for corner houses to stand back from the kerb
_BLOCK_RADIUS_M = 13.0  # of the driven lane: the kerbs inside must not fold
_BLOCK_ASPECT = 0.62  # of a block's long sides to half of its girth
_LEAD_M = 58.0  # of the through road before the junction


def plan_t_junction(length_m: float, rng: np.random.Generator) -> Plan:
    """A street that ends at another one, into which the car turns, left or right."""
    turn = float(rng.choice([-1.0, 1.0]))
    x_m = float(rng.uniform(30.0, 34.0))
    middle = np.array([x_m, LANE_M / 2])  # where the middles of both roads meet
    through = _through_road(middle, turn, length_m - x_m + BEYOND_M, rng)
    stem_path = straight_path(middle, np.pi, x_m + BEHIND_M)
    span = (stem_path.start_m, stem_path.end_m)
    lanes_of_two = (Strip(-LANE_M / 2), Strip(LANE_M / 2, forward=False))
    half = LANE_M + 0.3
    pavements = (float(rng.uniform(*_TURN_PAVEMENTS_M)), float(rng.uniform(*_TURN_PAVEMENTS_M)))
    stem = Road("stem", "street", stem_path, half, -half, lanes_of_two, span, pavements)
    joint = Joint("stem", "main", _LEAD_M, int(turn), zebra_after=True)
    route = _turn_route(middle, turn, length_m - x_m + BEYOND_M - 1.0)
    leaving, entering = right_turns(stem, through, joint)
    others = [*car_lanes(through, TOWN_SPEED_MPS), entering, *([leaving] if turn > 0 else [])]
    lanes = (Lane("car", route, TOWN_SPEED_MPS, is_route=True), *others)
    return Plan((through, stem), (joint,), route, lanes, _TURN_CORNER_M)


def _through_road(middle_m: Array, turn: float, ahead_m: float, rng: np.random.Generator) -> Road:
    heading = turn * np.pi / 2
    start = middle_m - _LEAD_M * np.array([np.cos(heading), np.sin(heading)])
    path = straight_path(start, heading, _LEAD_M + ahead_m)
    parking = int(rng.choice([-1, 1]))
    half = LANE_M + 0.3
    left, right = half + PARKING_M * (parking > 0), -half - PARKING_M * (parking < 0)
    strips = (Strip(-LANE_M / 2), Strip(LANE_M / 2, forward=False))
    pavements = (float(rng.uniform(*_TURN_PAVEMENTS_M)), float(rng.uniform(*_TURN_PAVEMENTS_M)))
    return Road("main", "street", path, left, right, strips, (0.0, path.end_m), pavements, (parking,))


def _turn_route(middle_m: Array, turn: float, ahead_m: float) -> Path:
    """Along y = 0 to the junction, round, and along the near or the far lane of the other road."""
    ahead = np.array([0.0, turn])
    corner = np.array([middle_m[0] + turn * LANE_M / 2, 0.0])
    ends = np.array([[-BEHIND_M, 0.0], corner, corner + (ahead_m + LANE_M / 2) * ahead])
    radius = _LEFT_RADIUS_M if turn > 0 else _RIGHT_RADIUS_M
    return rounded_path(ends, (0.0, radius, 0.0), start_m=-BEHIND_M, ramp_m=_TURN_RAMP_M)


def plan_loop(length_m: float, rng: np.random.Generator) -> Plan:
    """A road round a block, ``length_m`` once round, from which side streets lead outwards."""
    turn = float(rng.choice([-1.0, 1.0]))  # +1: the block lies on the left
    shape = rng.uniform(-0.07, 0.07, (4, 2)) * [1.0, 1.0]
    path = _block(length_m, turn, shape)
    main = town_road(path, rng)
    main = replace(main, parking=(-int(turn),)) if turn < 0 else main
    roads, lanes = [main], car_lanes(main, TOWN_SPEED_MPS, 0.0)
    joints: list[Joint] = []
    outside = -int(turn)
    for k, s in enumerate(_straight_middles(path)):
        arm = side_road(f"side_{k}", main, s, outside, float(rng.uniform(2.8, 3.2)))
        joint = Joint(arm.name, "main", s, outside, zebra_after=k == 0)
        roads, joints = [*roads, arm], [*joints, joint]
        lanes += right_turns(arm, main, joint)
    return Plan(tuple(roads), tuple(joints), path, tuple(lanes))


def _block(length_m: float, turn: float, shape: Array) -> Path:
    """The driven lane; its first side runs along +x through the origin, which is in its middle."""
    girth = length_m
    for _ in range(6):  # rounding the corners shortens the way round
        wide, deep = girth / 2 * _BLOCK_ASPECT, girth / 2 * (1 - _BLOCK_ASPECT)
        corners = np.array([[wide / 2, 0], [wide / 2, deep], [-wide / 2, deep], [-wide / 2, 0]])
        corners[1:3] += shape[1:3] * [wide, deep]
        corners[:, 1] *= turn
        path = rounded_path(corners, (_BLOCK_RADIUS_M,) * 4, closed=True)
        girth += length_m - path.length_m
    return path


def _straight_middles(path: Path) -> list[float]:
    """s of the middles of the straights behind the first two corners."""
    s_m = np.arange(path.start_m, path.end_m, 0.5)
    straight = np.abs(path.curvature_1pm(s_m, 2.0)) < 1e-3
    edges = np.flatnonzero(np.diff(straight.astype(int)))
    runs = [(float(s_m[a + 1]), float(s_m[b])) for a, b in zip(edges[1::2], edges[2::2], strict=False)]
    return [(low + high) / 2 for low, high in runs if high - low > 18.0][:3]
