"""Road markings painted by rules: lane lines, bays, crossings, arrows, limits, speed bumps."""

from __future__ import annotations

import numpy as np

from sim.paint.paving import lay_setts
from sim.paint.road import PAINT, RoadCanvas
from sim.streets.relief import BUMP_LENGTH_M
from sim.streets.road import AISLE_BAY_M, BAY_M, ZEBRA_M, Road

GUTTER_M = 0.3
_ARROW_EVERY_M = 27.0


def paint_road(road: RoadCanvas, plan: Road, rng: np.random.Generator) -> None:
    """Paint what a road's style asks for on the part of it that the canvas shows."""
    gutters, bays = rng.spawn(2)
    if plan.style == "motorway":
        _paint_motorway(road, plan)
        return
    _pave_gutters(road, plan, gutters)
    for side in plan.parking:
        _paint_bays(road, plan, side, bays)
    for zebra in plan.zebras_m:
        _paint_zebra(road, plan, zebra)
    if plan.style in ("street", "minor"):
        _paint_center_line(road, plan)
    if plan.style == "street":
        _paint_arrows(road, plan)
    if plan.style == "aisle":
        _paint_aisle(road, plan)
    for s in plan.limits_m:
        _limit(road, s)
    for s in plan.bumps_m:
        _paint_bump(road, plan, s)


def _pave_gutters(road: RoadCanvas, plan: Road, rng: np.random.Generator) -> None:
    """Setts along the kerbs, but not across mouths, and not where all is plain."""
    if plan.wear < 0.5 or plan.style == "aisle":
        return
    for side in (1, -1):
        kerb, start = plan.edge_m(side), road.start_m
        mouths = sorted((low, high) for low, high, at in plan.mouths_m if at == side)
        tone = 150.0 if plan.style == "street" else 140.0
        for low, high in [*mouths, (road.end_m, road.end_m)]:
            if low > start:
                _setts(road, (start, min(low, road.end_m)), (kerb, kerb - GUTTER_M * side), tone, rng)
            start = max(start, high)


def _paint_center_line(road: RoadCanvas, plan: Road) -> None:
    middle = plan.center_line_m
    if middle is None:
        return
    dash, gap, half = (2.5, 2.5, 0.07) if plan.style == "street" else (1.5, 2.5, 0.06)
    for s in np.arange(plan.path.start_m + 1.0, plan.span_m[1] - 3.0, dash + gap):
        if plan.is_free(s, s + dash) and s > plan.span_m[0] + 1.0:
            road.mark(s, middle - half, s + dash, middle + half)


def _paint_zebra(road: RoadCanvas, plan: Road, start_m: float) -> None:
    """Bars of half a metre across the road, and where traffic stops before them."""
    for d in np.arange(plan.right_m + 0.4, plan.left_m - 0.8, 1.0):
        road.mark(start_m, d, start_m + ZEBRA_M, d + 0.5)
    middle = plan.center_line_m
    if middle is None:
        return
    for strip in plan.strips:
        low, high = strip.d_m - strip.width_m / 2, strip.d_m + strip.width_m / 2
        low, high = (low, min(high, middle)) if strip.forward else (max(low, middle), high)
        bar = start_m - 1.3 if strip.forward else start_m + ZEBRA_M + 0.9
        if plan.span_m[0] < bar and plan.style == "street":
            road.mark(bar, low, bar + 0.4, high)


def _setts(
    road: RoadCanvas,
    s_m: tuple[float, float],
    d_m: tuple[float, float],
    tone: float,
    rng: np.random.Generator,
) -> None:
    corners = road.quad(s_m[0], min(d_m), s_m[1], max(d_m))
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    lay_setts(road.canvas, x0, y0, x1, y1, (0.18, 0.15), tone, rng)


def _paint_bays(road: RoadCanvas, plan: Road, side: int, rng: np.random.Generator) -> None:
    kerb, lane_edge = plan.edge_m(side), plan.edge_m(side) - 2.0 * side
    edge = sorted((lane_edge, lane_edge + 0.1 * side))
    low, high = sorted((kerb, lane_edge))
    for s in plan.bays_m(side):
        tone = float(rng.uniform(95, 130))
        _setts(road, (s, s + BAY_M), (kerb - GUTTER_M * side, lane_edge), tone, rng)
        road.mark(s, low, s + 0.1, high)
        road.mark(s, edge[0], s + 0.8, edge[1])
        road.mark(s + BAY_M - 0.8, edge[0], s + BAY_M, edge[1])


def _paint_arrows(road: RoadCanvas, plan: Road) -> None:
    for strip in plan.strips:
        for s in np.arange(14.0 if strip.forward else 27.5, plan.span_m[1], _ARROW_EVERY_M):
            if plan.is_free(s - 4.0, s + 4.0):
                _arrow(road, s, strip.d_m, 1 if strip.forward else -1)


def _arrow(road: RoadCanvas, s: float, d: float, ahead: int) -> None:
    low, high = sorted((s, s + 2.0 * ahead))
    road.mark(low, d - 0.08, high, d + 0.08)
    neck, tip = s + 2.0 * ahead, s + 3.4 * ahead
    head = np.array([road.at(neck, d - 0.35), road.at(tip, d), road.at(neck, d + 0.35)])
    road.canvas.fill(head, PAINT, 0.9, road.worn)


def _limit(road: RoadCanvas, s: float) -> None:
    """A ring and bars, long in the driving direction as limits painted on roads are."""
    x, y = road.at(s, 0.0)
    angles = np.linspace(0, 2 * np.pi, 30, endpoint=False)
    ring = np.stack([x + 1.4 * np.cos(angles), y + 0.75 * np.sin(angles)], axis=1)
    road.canvas.stroke(ring, 0.14, PAINT, 0.85, closed=True)
    three = np.array([[0, 1], [1, 1], [1, 0], [0, 0], [1, 0], [1, -1], [0, -1]])
    zero = np.array([[0, 1], [1, 1], [1, -1], [0, -1], [0, 1]])
    for digit, right in ((three, -0.4), (zero, 0.1)):  # (right, up) as the driver reads them
        points = np.stack([x + 0.75 * digit[:, 1], y + right + 0.3 * digit[:, 0]], axis=1)
        road.canvas.stroke(points, 0.11, PAINT, 0.85)


def _paint_bump(road: RoadCanvas, plan: Road, s: float) -> None:
    """Newer asphalt with teeth that point up both ramps."""
    low, high = s - BUMP_LENGTH_M / 2, s + BUMP_LENGTH_M / 2
    right, left = plan.bump_edges_m
    road.canvas.fill(road.quad(low, right, high, left), (62, 61, 62), 0.6)
    for d in np.arange(right + 0.15, left - 0.7, 1.1):
        for base, tip in ((low + 0.1, s - 0.5), (high - 0.1, s + 0.5)):
            teeth = np.array([road.at(base, d), road.at(base, d + 0.7), road.at(tip, d + 0.35)])
            road.canvas.fill(teeth, PAINT, 0.92, road.worn)


def _paint_aisle(road: RoadCanvas, plan: Road) -> None:
    """Lines between the bays on both sides of an aisle, arrows along it."""
    for side in (1, -1):
        mouth = plan.edge_m(side) - side * AISLE_BAY_M[0]
        low, high = sorted((plan.edge_m(side), mouth))
        for s in plan.across_bays_m(side):
            for line in (s, s + AISLE_BAY_M[1]):
                road.mark(line - 0.05, low, line + 0.05, high)
    for strip in plan.strips:
        for s in np.arange(plan.path.start_m + 6.0, plan.path.end_m - 6.0, 18.0):
            _arrow(road, s, strip.d_m, 1 if strip.forward else -1)


def _paint_motorway(road: RoadCanvas, plan: Road) -> None:
    """Dashes between lanes, 6 m in 18; unbroken lines along the shoulder and the median."""
    edges = [strip.d_m + side * strip.width_m / 2 for strip in plan.strips for side in (-1, 1)]
    right, left = min(edges), max(edges)
    road.mark(road.start_m, right - 0.3, road.end_m, right)
    road.mark(road.start_m, left, road.end_m, left + 0.15)
    between = [strip.d_m + strip.width_m / 2 for strip in plan.strips if strip.d_m + strip.width_m < left]
    for d in between:
        for s in np.arange(np.floor(road.start_m / 18.0) * 18.0, road.end_m, 18.0):
            road.mark(s, d - 0.075, s + 6.0, d + 0.075)
