"""Speed bumps: at a spacing along the driven line, on straight road, away from junctions and crossings."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from sim.streets.path import Path
from sim.streets.relief import BUMP_LENGTH_M, Bump
from sim.streets.road import Road

_FIRST_M = 8.0  # from the origin, where the ground is level
_STRAIGHT_1PM = 1 / 150.0
_SHIFTS_M = np.arange(0.0, 12.0, 1.0)


def place_bumps(
    roads: Sequence[Road], route: Path, length_m: float, per_100_m: float, rng: np.random.Generator
) -> tuple[tuple[Road, ...], tuple[Bump, ...]]:
    """Lay bumps on the roads that the route follows.

    Args:
        roads: Already joined.
        route: The driven line.
        length_m: How far it is driven, or once round.
        per_100_m: How many; a place in a bend or a junction moves on, or is left out.
        rng: Where the first one is.

    Returns:
        The roads with their bumps marked, and the bumps.
    """
    if per_100_m <= 0:
        return tuple(roads), ()
    every = 100.0 / per_100_m
    by_name = {road.name: road for road in roads}
    bumps: list[Bump] = []
    for s in np.arange(_FIRST_M + rng.uniform(0.0, 0.4) * every, length_m - BUMP_LENGTH_M, every):
        for shift in _SHIFTS_M[max(0.8 * every, 1.0) > _SHIFTS_M]:
            place = _place(tuple(by_name.values()), route, float(s + shift))
            if place is not None:
                road, at = place
                by_name[road.name] = replace(road, bumps_m=(*road.bumps_m, at))
                bumps.append(_bump(road, at))
                break
    return tuple(by_name[road.name] for road in roads), tuple(bumps)


def _place(roads: Sequence[Road], route: Path, s_m: float) -> tuple[Road, float] | None:
    """The road under a point of the route and the s on it, if a bump can lie there."""
    half = BUMP_LENGTH_M / 2 + 0.5
    around = s_m + np.array([-half, 0.0, half])
    if np.abs(route.curvature_1pm(around, 2.0)).max() > _STRAIGHT_1PM:
        return None
    for road in roads:
        at, d = road.path.project(route.point_m(s_m))
        inside = road.span_m[0] + half < at < road.span_m[1] - half or road.path.closed
        if inside and road.right_m < d < road.left_m and road.style != "ring":
            clear = road.is_free(at - half, at + half) and all(
                abs(at - other) > 2 * half for other in road.bumps_m
            )
            return (road, float(at)) if clear else None
    return None


def _bump(road: Road, s_m: float) -> Bump:
    right, left = road.bump_edges_m
    x, y = road.path.point_m(s_m, (left + right) / 2)
    return Bump((float(x), float(y)), float(road.path.heading_rad(s_m)), (left - right) / 2)
