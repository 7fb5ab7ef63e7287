"""Joining roads: where one opens into another, what of the surface belongs to neither, where one crosses."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from shapely import contains_xy
from shapely.geometry import MultiPolygon, Polygon
from shapely.ops import unary_union

from estimator.se3 import Array
from sim.streets.kerb import carriageway_of
from sim.streets.network import Junction
from sim.streets.road import ZEBRA_M, Road

_ZEBRA_SET_BACK_M = 0.3  # from the end of the corner
_SLIVER_M = 0.04
_REACH_M = 20.0  # of a mouth


@dataclass(frozen=True)
class Joint:
    """A road (``arm``) whose path begins in another one (``through``), which goes on undisturbed.

    Attributes:
        arm: Name of the road that opens.
        through: Name of the road it opens into.
        s_m: Where on the through road.
        side: On which side, +1 left.
        zebra_before: Whether the through road has a zebra crossing before the mouth, seen along its path.
        zebra_after: The same behind it.
        zebra_on_arm: Whether the arm has one.
    """

    arm: str
    through: str
    s_m: float
    side: int
    zebra_before: bool = True
    zebra_after: bool = False
    zebra_on_arm: bool = True


def join(
    roads: Sequence[Road], joints: Sequence[Joint], corner_m: float
) -> tuple[tuple[Road, ...], tuple[Junction, ...], MultiPolygon]:
    """Open roads into each other.

    Returns:
        The roads with their mouths, spans and zebras; the surfaces between them; the whole carriageway.
    """
    carriageway = carriageway_of(roads, corner_m)
    by_name = {road.name: road for road in roads}
    for joint in joints:
        arm, through = by_name[joint.arm], by_name[joint.through]
        mouth = _mouth(through, joint, carriageway)
        by_name[through.name] = _with_mouth(through, joint, mouth)
        by_name[arm.name] = _opened(arm, joint, carriageway)
    joined = tuple(by_name[road.name] for road in roads)
    return joined, _surfaces(joined, joints, carriageway), carriageway


def _mouth(through: Road, joint: Joint, carriageway: MultiPolygon) -> tuple[float, float]:
    """The interval of s without a kerb on the joint's side."""
    s_m = joint.s_m + np.arange(-_REACH_M, _REACH_M, 0.05)
    beside = through.path.point_m(s_m, through.edge_m(joint.side) + 0.03 * joint.side)
    is_open = contains_xy(carriageway, beside[:, 0], beside[:, 1])
    middle = len(s_m) // 2
    shut = np.flatnonzero(~is_open)
    return float(s_m[shut[shut < middle].max()]), float(s_m[shut[shut > middle].min()])


def _with_mouth(through: Road, joint: Joint, mouth: tuple[float, float]) -> Road:
    zebras = list(through.zebras_m)
    if joint.zebra_before:
        zebras.append(mouth[0] - ZEBRA_M - _ZEBRA_SET_BACK_M)
    if joint.zebra_after:
        zebras.append(mouth[1] + _ZEBRA_SET_BACK_M)
    # Arms that face each other share their crossings.
    kept = [z for k, z in enumerate(zebras) if all(abs(z - other) > 4.0 for other in zebras[:k])]
    return replace(through, mouths_m=(*through.mouths_m, (*mouth, joint.side)), zebras_m=tuple(kept))


def _opened(arm: Road, joint: Joint, carriageway: MultiPolygon) -> Road:
    """The arm's plain strip begins where both of its kerbs do."""
    s_m = arm.path.start_m + np.arange(0.0, _REACH_M + 10.0, 0.05)
    inside = [
        contains_xy(carriageway, *arm.path.point_m(s_m, edge).T)
        for edge in (arm.left_m + 0.03, arm.right_m - 0.03)
    ]
    start = float(s_m[np.flatnonzero(inside[0] | inside[1]).max()]) + 0.05
    zebras = (start + _ZEBRA_SET_BACK_M,) if joint.zebra_on_arm else ()
    return replace(
        arm,
        span_m=(start, arm.span_m[1]),
        zebras_m=zebras,
        gives_way=True,
        open_ends=(False, arm.open_ends[1]),
    )


def _surfaces(
    roads: Sequence[Road], joints: Sequence[Joint], carriageway: MultiPolygon
) -> tuple[Junction, ...]:
    strips = unary_union(
        [road.outline(None if road.path.closed else road.span_m).buffer(_SLIVER_M / 4) for road in roads]
    )
    rest = carriageway.difference(strips).buffer(-_SLIVER_M).buffer(_SLIVER_M, join_style="mitre")
    parts = list(rest.geoms) if isinstance(rest, MultiPolygon) else [rest]
    return tuple(_surface(part, roads, joints) for part in parts if part.area > 0.5)


def _surface(part: Polygon, roads: Sequence[Road], joints: Sequence[Joint]) -> Junction:
    """Painted along the road that goes through it, with the give-way line of the arm it belongs to."""
    by_name = {road.name: road for road in roads}
    at = np.array(part.centroid.coords[0])

    def away_m(joint: Joint) -> float:
        arm, half = by_name[joint.arm], by_name[joint.through].width_m / 2
        return float(np.linalg.norm(arm.path.point_m(arm.path.start_m + half + 2.0) - at))

    joint = min(joints, key=away_m)
    through = by_name[joint.through]
    teeth = _teeth(by_name[joint.arm], through, joint)
    return Junction(part, float(through.path.heading_rad(joint.s_m)), through.wear, teeth)


def _teeth(arm: Road, through: Road, joint: Joint) -> Array:
    """The give-way line of an arm, along the edge of the through road, as (N, 3, 2) triangles."""
    incoming = max((strip for strip in arm.strips if not strip.forward), key=lambda strip: strip.d_m)
    middle = arm.center_line_m or 0.0
    d = np.arange(middle + 0.1, incoming.d_m + incoming.width_m / 2 + 1.0, 0.75)
    at = through.path.project(arm.path.point_m(arm.path.start_m, d))[:, 0]
    edge, out = through.edge_m(joint.side), float(joint.side)
    corners = [(at - 0.25, edge + 0.9 * out), (at + 0.25, edge + 0.9 * out), (at, edge + 0.2 * out)]
    return np.stack([through.path.point_m(s, across) for s, across in corners], axis=1)
