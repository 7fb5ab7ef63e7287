"""Kinds whose car keeps to one street: straight, bend, crossroads, canyon, suburb."""

from __future__ import annotations

import numpy as np

from sim.streets.junctions import Joint
from sim.streets.layout import BEHIND_M, BEYOND_M, Layout, Section, draw_layout
from sim.streets.network import car_lanes
from sim.streets.path import STEP_M, Path, path_from_curvature, straight_path
from sim.streets.plan import Plan
from sim.streets.road import LANE_M, PARKING_M, Road, Strip
from sim.streets.turning import across, right_turns

TOWN_SPEED_MPS = 8.0
SIDE_DEPTH_M = 46.0
CROSSING_EVERY_M = 95.0
TWO_WAY = (Strip(0.0), Strip(LANE_M, forward=False))


def plan_straight(length_m: float, rng: np.random.Generator) -> Plan:
    """A straight street without junctions."""
    return _alone(_town_road(_straight(length_m), rng))


def plan_bend(length_m: float, rng: np.random.Generator) -> Plan:
    """A bend, and before or behind it a side street on its outside."""
    layout = draw_layout(length_m, rng)
    main = _road_of(layout.path, layout.section, limits_m=(layout.bend_start_m - 6.0,))
    arm = _arm("side", layout)
    joint = Joint("side", "main", layout.junction.s_m, layout.junction.side)
    lanes = [*car_lanes(main, TOWN_SPEED_MPS, 0.0), *right_turns(arm, main, joint)]
    return Plan((main, arm), (joint,), layout.path, tuple(lanes))


def plan_crossroads(length_m: float, rng: np.random.Generator) -> Plan:
    """A straight street crossed by others, the first within thirty metres."""
    main = _town_road(_straight(length_m), rng)
    roads, joints, lanes = [main], [], car_lanes(main, TOWN_SPEED_MPS, 0.0)
    for k, s in enumerate(np.arange(rng.uniform(24.0, 28.0), length_m + 30.0, CROSSING_EVERY_M)):
        half = float(rng.uniform(2.8, 3.2))
        arms = [
            side_road(f"cross_{k}_{'left' if side > 0 else 'right'}", main, s, side, half) for side in (1, -1)
        ]
        roads += arms
        joints += [
            Joint(arm.name, "main", float(s), side, zebra_after=True)
            for arm, side in zip(arms, (1, -1), strict=True)
        ]
        lanes += [across(arms[0], arms[1], main), across(arms[1], arms[0], main)]
    return Plan(tuple(roads), tuple(joints), main.path, tuple(lanes))


def _alone(road: Road) -> Plan:
    return Plan((road,), (), road.path, tuple(car_lanes(road, TOWN_SPEED_MPS, 0.0)))


def _straight(length_m: float) -> Path:
    s_m = np.arange(-BEHIND_M, length_m + BEYOND_M + STEP_M / 2, STEP_M)
    return path_from_curvature(-BEHIND_M, np.zeros(len(s_m)))


def _town_road(path: Path, rng: np.random.Generator) -> Road:
    parking = int(rng.choice([-1, 1]))
    left = 1.5 * LANE_M + (PARKING_M if parking > 0 else 0.1)
    right = -LANE_M / 2 - (PARKING_M if parking < 0 else 0.3)
    # Without a parking strip the pavement is wider, so that facades stand five metres or more from the lane.
    wide = float(rng.uniform(2.4, 3.0) if parking < 0 else rng.uniform(4.0, 4.8))
    pavements = (float(rng.uniform(2.4, 3.0)), wide)
    return Road(
        "main", "street", path, left, right, TWO_WAY, (path.start_m, path.end_m), pavements, (parking,)
    )


def _road_of(path: Path, section: Section, limits_m: tuple[float, ...]) -> Road:
    pavements = (section.front_left_m - section.kerb_left_m, section.kerb_right_m - section.front_right_m)
    return Road(
        "main",
        "street",
        path,
        section.kerb_left_m,
        section.kerb_right_m,
        TWO_WAY,
        (path.start_m, path.end_m),
        pavements,
        (section.parking_side,),
        limits_m=limits_m,
    )


def _arm(name: str, layout: Layout) -> Road:
    path, half = layout.junction.path, layout.junction.half_width_m
    return minor_road(name, path, half)


def side_road(
    name: str, main: Road, s_m: float, side: int, half_m: float, depth_m: float = SIDE_DEPTH_M
) -> Road:
    """A side street at right angles to a road, from its middle outwards."""
    heading = float(main.path.heading_rad(s_m)) + side * np.pi / 2
    return minor_road(name, straight_path(main.path.point_m(s_m), heading, depth_m), half_m)


def minor_road(name: str, path: Path, half_m: float) -> Road:
    """A street without a parking strip; its path is its middle."""
    strips = (Strip(-half_m / 2, True, half_m), Strip(half_m / 2, False, half_m))
    return Road(name, "minor", path, half_m, -half_m, strips, (path.start_m, path.end_m), (2.4, 2.4))
