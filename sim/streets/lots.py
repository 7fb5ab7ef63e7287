"""Lots: the ground behind the pavements of a network, cut into plots along every kerb that houses line.

A kerb is taken as runs between its corners. Where it goes round the corner of two streets a corner lot fills
the angle between their facade lines; elsewhere lots follow each other along the run. Lots that would reach
into a road, its pavement or another lot become shallower, or are left out.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from shapely import prepare
from shapely.geometry import Polygon

from estimator.se3 import Array
from sim.streets.footprint import Ground
from sim.streets.kerb import KerbLine
from sim.streets.lot import MANNERS, MODULE_M, SUBURB, Facades, Lot, Manner, Use
from sim.streets.network import Network
from sim.streets.road import Road

DEPTHS_M = (6.5, 4.6, 3.2)  # tried in turn
_LEAST_PAVEMENT_M = 1.3  # that a lot leaves of a street it does not face


def draw_lots(network: Network, facades: Facades, rng: np.random.Generator) -> list[Lot]:
    """Cut the ground along all kerbs that houses line; lots do not overlap."""
    builder = _Builder(network)
    lined = [kerb for kerb in network.kerbs if kerb.lining in ("houses", "bare")]
    streams = rng.spawn(2 * len(lined))
    starts: list[list[tuple[float, float]]] = []
    for kerb, stream in zip(lined, streams[::2], strict=True):
        starts.append(builder.corners(kerb, facades, stream))
    for kerb, spans, stream in zip(lined, starts, streams[1::2], strict=True):
        manner = SUBURB if kerb.lining == "bare" else MANNERS[facades]
        for low, high in spans:
            builder.row(kerb, low, high, manner, stream)
    for road in (road for road in network.roads if lined and road.style in ("street", "minor", "ring")):
        builder.close(road, all(kerb.lining == "bare" for kerb in lined))
    return builder.lots


class _Builder:
    """Collects lots and knows what ground is still free."""

    def __init__(self, network: Network) -> None:
        self.lots: list[Lot] = []
        self._ground = Ground([])
        self._kept_free = network.carriageway.buffer(_LEAST_PAVEMENT_M)
        prepare(self._kept_free)

    def corners(
        self, kerb: KerbLine, facades: Facades, rng: np.random.Generator
    ) -> list[tuple[float, float]]:
        """Build on the corners of a kerb; return the runs of s that remain between them."""
        path, d = kerb.path, kerb.pavement_m
        runs: list[float] = [] if path.closed else [path.start_m]
        for low, high in kerb.corners_m:
            width = MODULE_M if facades == "repeated" else float(rng.uniform(6.5, 9.5))
            used = self._corner(kerb, low, high, d, width)
            runs += [low - used[0], high + used[1]]
        if not path.closed:
            runs.append(path.end_m)
        elif runs:  # the last run goes on over the seam to the first corner
            runs = [*runs[1:], runs[0] + path.length_m]
        else:
            runs = [path.start_m, path.end_m]
        return [(low, high) for low, high in zip(runs[::2], runs[1::2], strict=True) if high > low]

    def _corner(self, kerb: KerbLine, low: float, high: float, d: float, width: float) -> tuple[float, float]:
        """Fill the angle of two facade lines; returns the length of s it uses before and behind it."""
        path = kerb.path
        a, b = path.point_m(np.array([low, high]), d)
        before, after = (_direction(float(path.heading_rad(s))) for s in (low, high))
        turn = float(before[0] * after[1] - before[1] * after[0])
        if turn < 0.5:  # hardly a corner
            return 0.0, 0.0
        reach_a = float((b - a)[0] * after[1] - (b - a)[1] * after[0]) / turn
        reach_b = float(before[0] * (b - a)[1] - before[1] * (b - a)[0]) / turn
        tip = a + reach_a * before
        for depth in DEPTHS_M:
            front = np.array([tip - width * before, tip])
            inward = np.array([-before[1], before[0]])
            back = np.array([front[0] + depth * inward, tip + depth * after])
            if reach_a < 0.9 * width and self._claim(
                Lot(front, back, 0.0, kerb.height_m, seen=(False, True)), room=False
            ):
                return width - reach_a, depth - reach_b
        return 0.0, 0.0

    def row(self, kerb: KerbLine, low: float, high: float, manner: Manner, rng: np.random.Generator) -> None:
        """Lots side by side from one s to another; those at the ends have no setback."""
        spans = list(_spans(kerb, low, high, manner, rng))
        was_garden = False
        for k, (a, b) in enumerate(spans):
            setback, garden = float(rng.choice(manner.setbacks_m)), bool(rng.random() < manner.garden_share)
            inner = 0 < k < len(spans) - 1
            # Never two gardens in a row: a side camera would see nothing but fence and sky.
            was_garden = garden and inner and not was_garden
            setback = setback if inner or manner is SUBURB else 0.0
            use: Use = "garden" if was_garden else "house"
            ends = (k == 0 and not kerb.path.closed, k == len(spans) - 1 and not kerb.path.closed)
            seen = (True, True) if manner is SUBURB else ends
            self._fit(kerb, (a, b), setback, use, seen)

    def _fit(
        self,
        kerb: KerbLine,
        span: tuple[float, float],
        setback: float,
        use: Use,
        seen: tuple[bool, bool],
    ) -> None:
        for depth in DEPTHS_M:
            near, far = kerb.pavement_m + setback, kerb.pavement_m + max(setback, 0.35) + depth
            margin = 0.12 * (span[1] - span[0]) if kerb.lining == "bare" else 0.0
            ends = np.array([span[0] + margin, span[1] - margin])
            front, back = kerb.path.point_m(ends, near), kerb.path.point_m(ends, far)
            lot = Lot(front, back, setback, kerb.height_m, use, seen)
            if lot.width_m > 3.0 and _is_sound(lot.outline_m) and self._claim(lot):
                return

    def close(self, road: Road, bare: bool) -> None:
        """A wide house across each open end of a street, facing back along it."""
        setback = max(SUBURB.setbacks_m) if bare else 0.0
        for is_open, s, ahead in zip(
            road.open_ends, (road.path.start_m, road.path.end_m), (-1, 1), strict=True
        ):
            if is_open and not road.path.closed:
                d = np.array([road.left_m + 3.0, road.right_m - 3.0])[::ahead]
                near, far = s + 1.5 * ahead, s + (1.5 + DEPTHS_M[0]) * ahead
                front, back = road.path.point_m(near, d), road.path.point_m(far, d)
                self._claim(Lot(front, back, setback, 0.0, "closing", gateway_m=road.width_m), room=False)

    def _claim(self, lot: Lot, room: bool = True) -> bool:
        outline = lot.outline_m
        if room and self._kept_free.intersects(Polygon(outline)):
            return False
        if not self._ground.claim(outline, -0.12):
            return False
        self.lots.append(lot)
        return True


def _direction(heading_rad: float) -> Array:
    return np.array([np.cos(heading_rad), np.sin(heading_rad)])


def _is_sound(outline: Array) -> bool:
    """Whether the outline is convex and counter-clockwise: the back has not folded over in a tight bend."""
    edges = np.roll(outline, -1, axis=0) - outline
    after = np.roll(edges, -1, axis=0)
    return bool((edges[:, 0] * after[:, 1] - edges[:, 1] * after[:, 0] > 0.2).all())


def _spans(
    kerb: KerbLine, low: float, high: float, manner: Manner, rng: np.random.Generator
) -> Iterator[tuple[float, float]]:
    """Intervals of s whose fronts are as wide as the manner says; a rest too short joins the last one."""
    edges = [low]
    while high - edges[-1] > 1.0:
        stretch = _stretch(kerb, edges[-1])
        width = float(rng.uniform(*manner.front_m)) / stretch
        rest = high - edges[-1] - width
        edges.append(high if rest < 0.9 * manner.front_m[0] / stretch else edges[-1] + width)
    return pairwise(edges)


def _stretch(kerb: KerbLine, s_m: float) -> float:
    """Metres along the facade line for a metre along the kerb, a few metres ahead."""
    ahead = kerb.path.point_m(np.array([s_m + 1.0, s_m + 7.0]), kerb.pavement_m)
    return max(float(np.linalg.norm(ahead[1] - ahead[0])) / 6.0, 0.35)
