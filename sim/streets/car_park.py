"""A car park: aisles with bays across on both sides, round one of whose islands the car drives slowly."""

from __future__ import annotations

import numpy as np

from sim.streets.network import Bay, Lane
from sim.streets.path import straight_path
from sim.streets.plan import Plan
from sim.streets.road import AISLE_BAY_M, Road, Strip
from sim.streets.rounded import rounded_path

_AISLE_M = 6.6  # between the bays
_ISLAND_M = 1.4  # between bays that stand back to back
_RADIUS_M = 5.5
_SPEED_MPS = 3.0
_WEAR = 0.7
_ROWS = (-1, 0, 1, 2)  # of aisles; the car drives round the island between 0 and 1
_KERBED_M = _ISLAND_M / 2 - 0.02
_LAP_M = 0.02  # by which aisles reach into the ways at their ends
PITCH_M = _AISLE_M + 2 * AISLE_BAY_M[0] + _ISLAND_M


def plan_car_park(length_m: float, rng: np.random.Generator) -> Plan:
    """Aisles joined at both ends; the way round one of the islands between them is ``length_m`` long."""
    turn = int(rng.choice([-1, 1]))
    reach = _reach_m(length_m)
    half = _AISLE_M / 2 + AISLE_BAY_M[0]
    rows = sorted(turn * row for row in _ROWS)
    inner = reach - _AISLE_M / 2
    aisles = [_aisle(row, inner, row == rows[0], row == rows[-1]) for row in rows]
    low, high = (float(aisle.path.points_m[0, 1]) for aisle in (aisles[0], aisles[-1]))
    ends = [_end(name, x, low - half, high + half) for name, x in (("end_0", -reach), ("end_1", reach))]
    corners = np.array([[reach, 0.0], [reach, turn * PITCH_M], [-reach, turn * PITCH_M], [-reach, 0.0]])
    route = rounded_path(corners, (_RADIUS_M,) * 4, closed=True)
    bays = tuple(bay for aisle in aisles for bay in _bays(aisle))
    lane = Lane("car", route, _SPEED_MPS, is_route=True)
    return Plan((*aisles, *ends), (), route, (lane,), corner_m=0.0, bays=bays)


def _reach_m(length_m: float) -> float:
    """Half the distance of the two ends, so that the way round is as long as asked."""
    saved = 4 * (2 - np.pi / 2) * _RADIUS_M  # by rounding the corners
    return float(length_m + saved - 2 * PITCH_M) / 4


def _aisle(row: int, reach_m: float, is_first: bool, is_last: bool) -> Road:
    """One aisle along x with the bays on both of its sides; the outermost ones have houses beyond."""
    half = _AISLE_M / 2 + AISLE_BAY_M[0]
    path = straight_path(np.array([-reach_m - _LAP_M, row * PITCH_M]), 0.0, 2 * (reach_m + _LAP_M))
    return Road(
        f"aisle_{row}",
        "aisle",
        path,
        half,
        -half,
        (Strip(0.0, row % 2 == 0, _AISLE_M),),
        (path.start_m, path.end_m),
        pavements_m=(2.6 if is_last else _KERBED_M, 2.6 if is_first else _KERBED_M),
        linings=("houses" if is_last else "island", "houses" if is_first else "island"),
        open_ends=(False, False),
        wear=_WEAR,
    )


def _end(name: str, x_m: float, low_m: float, high_m: float) -> Road:
    """The way from aisle to aisle at one end."""
    path = straight_path(np.array([x_m, low_m]), np.pi / 2, high_m - low_m)
    half = _AISLE_M / 2
    return Road(
        name,
        "aisle",
        path,
        half,
        -half,
        (),
        (path.start_m, path.end_m),
        open_ends=(False, False),
        wear=_WEAR,
    )


def _bays(aisle: Road) -> list[Bay]:
    bays = []
    for side in (1, -1):
        for s in aisle.across_bays_m(side):
            d = aisle.edge_m(side) - side * AISLE_BAY_M[0] / 2
            x, y = aisle.path.point_m(s + AISLE_BAY_M[1] / 2, d)
            yaw = float(aisle.path.heading_rad(s)) + side * np.pi / 2
            bays.append(Bay((float(x), float(y)), yaw, is_across=True))
    return bays
