"""Which lanes and parking places follow from roads, kerbs and how they meet."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely import contains_xy
from shapely.ops import unary_union

from sim.streets.kerb import KerbLine
from sim.streets.network import Bay, Lane
from sim.streets.road import Road

KERB_WALK_M = 1.3  # from the kerb, where people walk
BIKE_M = 0.8  # from the outer edge of a lane, where bicycles ride
BIKE_SPEED_MPS = 4.5
_BESIDE_CARS_M = 0.6  # how far to the right of cars bicycles turn


def foot_lanes(kerbs: Sequence[KerbLine]) -> list[Lane]:
    """People walk both ways on every pavement that has room for them."""
    lanes = []
    for kerb in kerbs:
        if kerb.lining in ("houses", "bare") and kerb.pavement_m > 1.8:
            for d, backwards in ((KERB_WALK_M, False), (min(2.0, kerb.pavement_m - 0.4), True)):
                lanes.append(Lane("foot", kerb.path.offset(d, backwards=backwards), 1.4))
    return lanes


def bike_lanes(roads: Sequence[Road], arms: Sequence[Road], cars: Sequence[Lane]) -> list[Lane]:
    """Bicycles keep to the right: along roads, and on arms wherever cars turn in and out.

    Args:
        roads: Those that go through.
        arms: Those that begin in another one, where a lane of their own would end in the middle.
        cars: Lanes of cars.
    """
    lanes = [lane for road in roads for lane in _along(road)]
    if not arms:
        return lanes
    ground = unary_union([arm.outline(arm.span_m) for arm in arms])
    for car in cars:
        ends = car.path.point_m(np.array([car.path.start_m + 1.0, car.path.end_m - 1.0]))
        if not car.closed and contains_xy(ground, ends[:, 0], ends[:, 1]).any():
            path = car.path.offset(-_BESIDE_CARS_M)
            lanes.append(Lane("bike", path, BIKE_SPEED_MPS, car.gives_way_m))
    return lanes


def _along(road: Road) -> list[Lane]:
    """One lane on the right of the outermost lane of each direction."""
    lanes = []
    for forward in (True, False):
        strips = [strip for strip in road.strips if strip.forward == forward]
        if strips:
            side = -1 if forward else 1
            outer = max(strips, key=lambda strip: side * strip.d_m)
            d = outer.d_m + side * (outer.width_m / 2 - BIKE_M)
            lanes.append(Lane("bike", road.path.offset(d, backwards=not forward), BIKE_SPEED_MPS))
    return lanes


def car_lanes(road: Road, speed_mps: float, route_d_m: float | None = None) -> list[Lane]:
    """One lane a strip, from end to end of the road's path; ``route_d_m`` marks the driven one."""
    return [
        Lane(
            "car",
            road.path.offset(strip.d_m, backwards=not strip.forward),
            speed_mps,
            is_route=strip.forward and route_d_m is not None and abs(strip.d_m - route_d_m) < 1e-6,
        )
        for strip in road.strips
    ]


def road_bays(road: Road) -> list[Bay]:
    """The bays along the kerbs of a road; cars point along their side's traffic."""
    bays = []
    for side in road.parking:
        for s in road.bays_m(side):
            middle = s + 2.8
            x, y = road.path.point_m(middle, road.edge_m(side) - side * 1.08)
            yaw = float(road.path.heading_rad(middle)) + (np.pi if side > 0 else 0.0)
            bays.append(Bay((float(x), float(y)), yaw))
    return bays
