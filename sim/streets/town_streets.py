"""Kinds whose car keeps to one street: straight, canyon, suburb, tunnel, bend and crossroads."""

from __future__ import annotations

import numpy as np

from sim.streets.junctions import Joint
from sim.streets.lane_rules import car_lanes
from sim.streets.network import Tunnel
from sim.streets.path import STEP_M, Path, bend_curvature, bend_length_m, path_from_curvature
from sim.streets.plan import Plan
from sim.streets.road import LANE_M, PARKING_M, Road, Strip
from sim.streets.side_road import side_road
from sim.streets.turning import across, right_turns

BEHIND_M = 45.0
BEYOND_M = 60.0
TOWN_SPEED_MPS = 8.0
CROSSING_EVERY_M = 95.0
LATER_BEND_EVERY_M = 85.0
TWO_WAY = (Strip(0.0), Strip(LANE_M, forward=False))
TUNNEL_HEIGHT_M = 5.0
TUNNEL_WALL_M = 1.0  # from the kerb


def plan_straight(length_m: float, rng: np.random.Generator) -> Plan:
    """A straight street without junctions."""
    return _alone(town_road(_path(length_m), rng))


def plan_canyon(length_m: float, rng: np.random.Generator) -> Plan:
    """A straight high street between facades that stand close, without parked cars."""
    path = _path(length_m)
    pavements = (float(rng.uniform(3.2, 3.6)), float(rng.uniform(3.2, 3.6)))
    return _alone(_bare_road(path, pavements))


def plan_suburb(length_m: float, rng: np.random.Generator) -> Plan:
    """A street that winds gently past low houses far apart; plain asphalt, hardly a spot on it."""
    s_m = _s(length_m)
    curvature, turn, at = np.zeros(len(s_m)), float(rng.choice([-1.0, 1.0])), float(rng.uniform(8.0, 16.0))
    while at < length_m + BEYOND_M:
        angle = turn * np.deg2rad(rng.uniform(14.0, 22.0))
        curvature += bend_curvature(s_m, at, angle, 90.0, 12.0)
        at, turn = at + bend_length_m(angle, 90.0, 12.0) + float(rng.uniform(8.0, 20.0)), -turn
    path = path_from_curvature(-BEHIND_M, curvature)
    road = Road(
        "main",
        "minor",
        path,
        1.5 * LANE_M + 0.2,
        -LANE_M / 2 - 0.3,
        TWO_WAY,
        (path.start_m, path.end_m),
        (2.2, 2.2),
        wear=0.12,
        linings=("bare", "bare"),
    )
    return _alone(road)


def plan_tunnel(length_m: float, rng: np.random.Generator) -> Plan:
    """A street that dives under a building; daylight before it and behind it."""
    path = _path(length_m)
    pavement = float(rng.uniform(2.4, 2.9))
    road = _bare_road(path, (pavement, pavement))
    start = float(rng.uniform(16.0, 20.0))
    span = (start, start + max(24.0, 0.55 * length_m))
    return Plan(
        (road,), (), path, tuple(car_lanes(road, TOWN_SPEED_MPS, 0.0)), tunnels=(_tunnel(road, span),)
    )


def plan_bend(length_m: float, rng: np.random.Generator) -> Plan:
    """A bend, and before or behind it a side street on its outside, all within the first sixty metres."""
    turn = float(rng.choice([-1.0, 1.0]))
    angle_rad = turn * np.deg2rad(rng.uniform(47, 56))
    radius_m = float(rng.uniform(23.0, 25.0))
    junction_first = bool(rng.random() < 0.5)
    start_m = float(rng.uniform(24, 26) if junction_first else rng.uniform(10, 12))
    end_m = start_m + bend_length_m(angle_rad, radius_m)
    junction_m = float(rng.uniform(12.5, 13.5)) if junction_first else end_m + 7.5
    curvature = bend_curvature(_s(length_m), start_m, angle_rad, radius_m)
    # Later bends alternate, so that a long street never crosses itself.
    later, sign = start_m + LATER_BEND_EVERY_M, -1.0
    while later < length_m + BEYOND_M:
        curvature += bend_curvature(_s(length_m), later, sign * angle_rad, radius_m + 4.0)
        later, sign = later + LATER_BEND_EVERY_M, -sign
    main = town_road(path_from_curvature(-BEHIND_M, curvature), rng, limits_m=(start_m - 6.0,))
    arm = side_road("side", main, junction_m, -int(turn), float(rng.uniform(2.8, 3.2)))
    joint = Joint("side", "main", junction_m, -int(turn))
    lanes = [*car_lanes(main, TOWN_SPEED_MPS, 0.0), *right_turns(arm, main, joint)]
    return Plan((main, arm), (joint,), main.path, tuple(lanes))


def plan_crossroads(length_m: float, rng: np.random.Generator) -> Plan:
    """A straight street crossed by others, the first within thirty metres."""
    main = town_road(_path(length_m), rng)
    roads, joints, lanes = [main], [], car_lanes(main, TOWN_SPEED_MPS, 0.0)
    for k, s in enumerate(np.arange(rng.uniform(24.0, 28.0), length_m + 20.0, CROSSING_EVERY_M)):
        half = float(rng.uniform(2.8, 3.2))
        left, right = (
            side_road(f"cross_{k}_{name}", main, s, side, half) for name, side in (("left", 1), ("right", -1))
        )
        roads += [left, right]
        joints += [
            Joint(arm.name, "main", float(s), side, zebra_after=True)
            for arm, side in ((left, 1), (right, -1))
        ]
        lanes += [across(left, right, main), across(right, left, main)]
    return Plan(tuple(roads), tuple(joints), main.path, tuple(lanes))


def town_road(path: Path, rng: np.random.Generator, limits_m: tuple[float, ...] = ()) -> Road:
    """A street with a lane each way and a parking strip on one side; its path is the driven lane."""
    parking = int(rng.choice([-1, 1]))
    right = -LANE_M / 2 - (PARKING_M if parking < 0 else 0.3)
    left = 1.5 * LANE_M + (PARKING_M if parking > 0 else 0.1)
    # Without a parking strip the pavement is wider, so that facades stand five metres or more from the lane.
    pavement_right = float(rng.uniform(2.4, 3.0) if parking < 0 else rng.uniform(4.0, 4.8))
    pavements = (float(rng.uniform(2.4, 3.0)), pavement_right)
    span = (path.start_m, path.end_m)
    return Road("main", "street", path, left, right, TWO_WAY, span, pavements, (parking,), limits_m=limits_m)


def _bare_road(path: Path, pavements_m: tuple[float, float]) -> Road:
    """A street with a lane each way and nothing besides."""
    span = (path.start_m, path.end_m)
    return Road("main", "street", path, 1.5 * LANE_M + 0.3, -LANE_M / 2 - 0.3, TWO_WAY, span, pavements_m)


def _alone(road: Road) -> Plan:
    return Plan((road,), (), road.path, tuple(car_lanes(road, TOWN_SPEED_MPS, 0.0)))


def _s(length_m: float) -> np.ndarray:
    return np.arange(-BEHIND_M, length_m + BEYOND_M + STEP_M / 2, STEP_M)


def _path(length_m: float) -> Path:
    return path_from_curvature(-BEHIND_M, np.zeros(len(_s(length_m))))


def _tunnel(road: Road, span_m: tuple[float, float]) -> Tunnel:
    left, right = road.left_m + TUNNEL_WALL_M, road.right_m - TUNNEL_WALL_M
    s_m = np.linspace(*span_m, max(2, round((span_m[1] - span_m[0]) / 2.0)))
    outline = np.vstack([road.path.point_m(s_m, right), road.path.point_m(s_m, left)[::-1]])
    portals = road.path.point_m(np.array(span_m), (left + right) / 2)
    return Tunnel(road.name, span_m, TUNNEL_HEIGHT_M, outline, portals)
