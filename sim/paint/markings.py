"""Road markings painted into the road canvas: lane lines, bays, crossings, give-way lines, arrows."""

from __future__ import annotations

import numpy as np

from sim.paint.paving import lay_setts
from sim.paint.road import PAINT, RoadCanvas
from sim.streets.layout import BAY_M, LANE_M, Layout

ZEBRA_M = 3.2


def paint_main_road(road: RoadCanvas, layout: Layout, rng: np.random.Generator) -> None:
    """Gutters, parking bays, centre line, the zebra crossing before the junction, arrows and a limit."""
    section, path, junction = layout.section, layout.path, layout.junction
    start, end = path.start_m, path.end_m
    for kerb, inward in ((section.kerb_left_m, -1.0), (section.kerb_right_m, 1.0)):
        _setts(road, start, kerb, end, kerb + 0.3 * inward, 150.0, rng)
    if section.parking_side:
        _paint_bays(road, layout, rng)
    keep_off = [(junction.s_m - junction.half_width_m, junction.s_m + junction.half_width_m)]
    for zebra in zebra_starts_m(layout):
        keep_off.append((zebra - 1.5, zebra + ZEBRA_M + 1.5))
        paint_zebra(road, zebra, section.kerb_right_m + 0.4, section.kerb_left_m - 0.4)
        road.mark(zebra - 1.3, -LANE_M / 2, zebra - 0.9, section.center_line_m)
    for s in np.arange(start + 1.0, end - 3.0, 5.0):
        if all(s + 2.5 < low or s > high for low, high in keep_off):
            road.mark(s, section.center_line_m - 0.07, s + 2.5, section.center_line_m + 0.07)
    for s in np.arange(start + 14.0, end, 27.0):
        if all(s + 4 < low or s > high for low, high in keep_off):
            _arrow(road, s, 0.0)
    _limit(road, layout.bend_start_m - 6.0)


def paint_side_road(road: RoadCanvas, layout: Layout, rng: np.random.Generator) -> None:
    """The give-way triangles at the mouth, a zebra behind them, a centre line and gutters."""
    junction, section = layout.junction, layout.junction.section
    mouth = abs(layout.section.kerb_m(junction.side))
    for kerb, inward in ((section.kerb_left_m, -1.0), (section.kerb_right_m, 1.0)):
        _setts(road, mouth + junction.corner_m, kerb, junction.path.end_m, kerb + 0.3 * inward, 140.0, rng)
    for d in np.arange(section.kerb_right_m + 0.4, section.kerb_left_m - 0.4, 0.75):
        triangle = np.array(
            [road.at(mouth + 0.9, d), road.at(mouth + 0.2, d + 0.25), road.at(mouth + 0.9, d + 0.5)]
        )
        road.canvas.fill(triangle, PAINT, 0.92, road.worn)
    paint_zebra(road, mouth + 1.6, section.kerb_right_m + 0.3, section.kerb_left_m - 0.3)
    for s in np.arange(mouth + 8.0, junction.path.end_m, 4.0):
        road.mark(s, -0.06, s + 1.5, 0.06)


def zebra_starts_m(layout: Layout) -> tuple[float, ...]:
    """Where zebra crossings of the main road begin: before the junction's mouth, and one further on."""
    first, last = layout.mouth_m
    return first - ZEBRA_M - 0.3, last + 22.0


def paint_zebra(road: RoadCanvas, start_m: float, right_m: float, left_m: float) -> None:
    """Bars of half a metre across the road."""
    for d in np.arange(right_m, left_m - 0.4, 1.0):
        road.mark(start_m, d, start_m + ZEBRA_M, d + 0.5)


def _setts(
    road: RoadCanvas, s0: float, d0: float, s1: float, d1: float, tone: float, rng: np.random.Generator
) -> None:
    corners = road.quad(s0, min(d0, d1), s1, max(d0, d1))
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    lay_setts(road.canvas, x0, y0, x1, y1, (0.18, 0.15), tone, rng)


def _paint_bays(road: RoadCanvas, layout: Layout, rng: np.random.Generator) -> None:
    section = layout.section
    side = section.parking_side
    kerb, lane_edge = section.kerb_m(side), section.kerb_m(side) - 2.0 * side
    first, last = layout.mouth_m if side == layout.junction.side else (1e9, 1e9)
    for s in np.arange(layout.path.start_m, layout.path.end_m - BAY_M, BAY_M):
        if first - 6.0 < s < last + 0.5:
            continue
        _setts(road, s, kerb - 0.3 * side, s + BAY_M, lane_edge, float(rng.uniform(95, 130)), rng)
        low, high = sorted((kerb, lane_edge))
        road.mark(s, low, s + 0.1, high)
        edge = sorted((lane_edge, lane_edge + 0.1 * side))
        road.mark(s, edge[0], s + 0.8, edge[1])
        road.mark(s + BAY_M - 0.8, edge[0], s + BAY_M, edge[1])


def _arrow(road: RoadCanvas, s: float, d: float) -> None:
    road.mark(s, d - 0.08, s + 2.0, d + 0.08)
    head = np.array([road.at(s + 2.0, d - 0.35), road.at(s + 3.4, d), road.at(s + 2.0, d + 0.35)])
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
