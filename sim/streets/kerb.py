"""Kerb lines: where a carriageway ends and pavement, verge or wall begins; all stands along them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from shapely import line_merge
from shapely.geometry import LineString, MultiPolygon, Polygon
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from estimator.se3 import Array
from sim.streets.path import Path, path_through
from sim.streets.road import ZEBRA_M, Lining, Road

CORNER_MARGIN_M = 0.4
TUNNEL_WALK_M = 1.0  # of raised walk between a tunnel's kerb and its wall
_SHORTEST_M = 1.5


@dataclass(frozen=True, eq=False)
class KerbLine:
    """One kerb, its pavement on the left of the path, the carriageway on the right.

    Attributes:
        path: Along the kerb; closed round a block or an island. d > 0 goes from the kerb towards the facades.
        pavement_m: Width of the pavement; beyond it begin the lots.
        height_m: Of the pavement over the carriageway; 0 for a verge of grass.
        lining: What stands along it: houses, low houses far apart ("bare"), a crash barrier, a wall (of a
            tunnel), an island of the carriageway.
        corners_m: Intervals of s in which the kerb goes round the corner of a junction.
        keep_clear_m: Intervals of s in which nothing may stand on the pavement: corners and crossings.
        road: Name of the road it mostly runs along.
        side: On which side of that road it lies, +1 left, -1 right.
        parks: Whether cars park along it.
        wear: As of the road: 0 for plain new paving.
    """

    path: Path
    pavement_m: float
    height_m: float
    lining: Lining
    corners_m: tuple[tuple[float, float], ...]
    keep_clear_m: tuple[tuple[float, float], ...]
    road: str
    side: int
    parks: bool
    wear: float


def carriageway_of(roads: Sequence[Road], corner_m: float) -> MultiPolygon:
    """The union of all roads, its inner corners rounded with a radius."""
    union = unary_union([road.outline() for road in roads])
    rounded = union.buffer(corner_m, quad_segs=64).buffer(-corner_m, quad_segs=64) if corner_m else union
    return rounded if isinstance(rounded, MultiPolygon) else MultiPolygon([rounded])


def kerb_lines(carriageway: MultiPolygon, roads: Sequence[Road], corner_m: float) -> tuple[KerbLine, ...]:
    """Follow the edge of the carriageway; roads that leave the world leave the line open."""
    ends = unary_union([cap.buffer(0.3) for road in roads for cap in _caps(road)])
    lines: list[KerbLine] = []
    for part in carriageway.geoms:
        ring_of = orient(part, sign=-1.0)  # the carriageway on the right of the exterior and of holes
        for ring in (ring_of.exterior, *ring_of.interiors):
            for piece, closed in _open_pieces(ring, ends):
                path = path_through(np.asarray(piece.coords), closed)
                if path.length_m > _SHORTEST_M:
                    lines.append(_describe(path, roads, corner_m))
    return tuple(lines)


def _caps(road: Road) -> list[LineString]:
    """The lines across a road where it leaves the world."""
    ends = zip((road.path.start_m, road.path.end_m), road.open_ends, strict=True)
    return [
        LineString(road.path.point_m(s, np.array([road.left_m, road.right_m])))
        for s, is_open in ends
        if is_open and not road.path.closed
    ]


def _open_pieces(ring: LineString, ends: Polygon) -> list[tuple[LineString, bool]]:
    if ends.is_empty or not ring.intersects(ends):
        return [(ring, True)]
    rest = ring.difference(ends)
    merged = line_merge(rest, directed=True) if rest.geom_type == "MultiLineString" else rest
    pieces = list(merged.geoms) if merged.geom_type == "MultiLineString" else [merged]
    return [(piece, False) for piece in pieces]


def _describe(path: Path, roads: Sequence[Road], corner_m: float) -> KerbLine:
    road, side = _road_beside(path, roads)
    which = 0 if side > 0 else 1
    corners = _corners(path, corner_m) if corner_m else ()
    return KerbLine(
        path,
        road.pavements_m[which],
        road.kerb_m,
        road.linings[which],
        corners,
        (*corners, *_crossings(path, roads)),
        road.name,
        side,
        side in road.parking,
        road.wear,
    )


def _road_beside(path: Path, roads: Sequence[Road]) -> tuple[Road, int]:
    """The road, and its side, along whose edge most of a kerb lies."""
    best, most = (roads[0], 1), -1
    for road in roads:
        s, d = road.path.project(path.points_m[::5]).T
        within = (s > road.path.start_m) & (s < road.path.end_m) | road.path.closed
        for side in (1, -1):
            count = int(np.sum(within & (np.abs(d - road.edge_m(side)) < 0.05)))
            if count > most:
                best, most = (road, side), count
    return best


def _corners(path: Path, corner_m: float) -> tuple[tuple[float, float], ...]:
    """Intervals in which the kerb bends to the left about as tightly as corners are rounded."""
    s_m = np.arange(path.start_m, path.end_m, 0.1)
    tight = path.curvature_1pm(np.clip(s_m, path.start_m + 0.5, path.end_m - 0.5)) > 0.6 / corner_m
    return tuple((low - CORNER_MARGIN_M, high + CORNER_MARGIN_M) for low, high in _runs(s_m, tight))


def _runs(s_m: Array, marked: npt.NDArray[np.bool_]) -> list[tuple[float, float]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[0], np.asarray(marked, int), [0]])))
    return [(float(s_m[a]), float(s_m[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True)]


def _crossings(path: Path, roads: Sequence[Road]) -> list[tuple[float, float]]:
    found = []
    for road in roads:
        for zebra in road.zebras_m:
            for side in (1, -1):
                ends = road.path.point_m(np.array([zebra - 0.6, zebra + ZEBRA_M + 0.6]), road.edge_m(side))
                s, d = path.project(ends).T
                if np.abs(d).max() < 0.3 and np.ptp(s) < 2 * ZEBRA_M:
                    found.append((float(s.min()), float(s.max())))
    return found


def walled(kerbs: Sequence[KerbLine], road: Road, span_m: tuple[float, float]) -> tuple[KerbLine, ...]:
    """Cut the kerbs along a stretch of a road, and line the stretch with a wall."""
    lines: list[KerbLine] = []
    for kerb in kerbs:
        if kerb.road != road.name:
            lines.append(kerb)
            continue
        ends = road.path.point_m(np.array(span_m), road.edge_m(kerb.side))
        low, high = np.sort(kerb.path.project(ends)[:, 0])
        cuts = [kerb.path.start_m, float(low), float(high), kerb.path.end_m]
        for k, (start, end) in enumerate(pairwise(cuts)):
            piece = replace(
                kerb,
                path=kerb.path.offset(0.0, start, end),
                corners_m=_within(kerb.corners_m, start, end),
                keep_clear_m=_within(kerb.keep_clear_m, start, end),
            )
            if k == 1:
                piece = replace(piece, lining="wall", pavement_m=TUNNEL_WALK_M, parks=False)
            lines.append(piece)
    return tuple(lines)


def _within(
    spans_m: Sequence[tuple[float, float]], start_m: float, end_m: float
) -> tuple[tuple[float, float], ...]:
    """Intervals of a kerb that touch a piece of it, in the piece's own s."""
    return tuple((a - start_m, b - start_m) for a, b in spans_m if b > start_m and a < end_m)
