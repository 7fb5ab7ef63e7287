"""One road of the network: its path, its cross-section, and what is marked on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from shapely.geometry import Polygon

from estimator.se3 import Array
from sim.streets.path import Path

LANE_M = 3.1
PARKING_M = 2.1
BAY_M = 5.6
KERB_M = 0.12
ZEBRA_M = 3.2
EDGE_STEP_M = 0.5
BUMP_GUTTER_M = 0.35
_TIGHTEST_PARKED_1PM = 1 / 17.0  # bend along which cars park
AISLE_BAY_M = (5.0, 2.5)  # length and width of a bay of a car park

Style = Literal["street", "minor", "ring", "motorway", "aisle"]
Lining = Literal["houses", "bare", "barrier", "wall", "island"]


@dataclass(frozen=True)
class Strip:
    """One lane of a road.

    Attributes:
        d_m: Its centre, left of the road's path.
        forward: Whether it runs along the path.
        width_m: Between its lines.
    """

    d_m: float
    forward: bool = True
    width_m: float = LANE_M


@dataclass(frozen=True, eq=False)
class Road:
    """A carriageway along a path.

    Attributes:
        name: Unique in the network.
        style: Which rules its markings follow.
        path: Its reference line; d is measured from it.
        left_m: d of the left edge of the carriageway.
        right_m: d of the right edge, negative.
        strips: Its lanes.
        span_m: The interval of s in which the carriageway has its plain width; the rest belongs to junctions.
        pavements_m: Width of the pavement on the left and on the right.
        parking: Sides (+1 left, -1 right) along which cars park in bays on the carriageway.
        mouths_m: Intervals of s in which another road opens, corners included, with its side.
        zebras_m: s at which zebra crossings begin.
        bumps_m: s of the middles of speed bumps.
        gives_way: Whether it gives way where it begins.
        open_ends: Whether it leaves the world at its start and at its end.
        wear: 1 for an old town street full of repairs and spots, 0 for plain new asphalt.
        limits_m: s of the speed limit painted on the lane.
        linings: What stands along its kerbs, left and right; see ``KerbLine``.
        kerb_m: Height of its kerbs; 0 for none.
        texel_m: How finely it is painted along and across; finer across, since at a flat angle mipmaps blur
            along the road anyway.
    """

    name: str
    style: Style
    path: Path
    left_m: float
    right_m: float
    strips: tuple[Strip, ...]
    span_m: tuple[float, float]
    pavements_m: tuple[float, float] = (2.6, 2.6)
    parking: tuple[int, ...] = ()
    mouths_m: tuple[tuple[float, float, int], ...] = ()
    zebras_m: tuple[float, ...] = ()
    bumps_m: tuple[float, ...] = ()
    gives_way: bool = False
    open_ends: tuple[bool, bool] = (True, True)
    wear: float = 1.0
    limits_m: tuple[float, ...] = ()
    linings: tuple[Lining, Lining] = ("houses", "houses")
    kerb_m: float = KERB_M
    texel_m: tuple[float, float] = (0.025, 0.014)

    @property
    def width_m(self) -> float:
        return self.left_m - self.right_m

    def edge_m(self, side: int) -> float:
        """d of the kerb on the left (+1) or right (-1)."""
        return self.left_m if side > 0 else self.right_m

    @property
    def center_line_m(self) -> float | None:
        """d of the line between the directions; None for a one-way road."""
        forward = [strip.d_m + strip.width_m / 2 for strip in self.strips if strip.forward]
        backward = [strip.d_m - strip.width_m / 2 for strip in self.strips if not strip.forward]
        return (max(forward) + min(backward)) / 2 if forward and backward else None

    def outline(self, span_m: tuple[float, float] | None = None) -> Polygon:
        """The carriageway between two s; a closed road gives a ring."""
        start, end = span_m or (self.path.start_m, self.path.end_m)
        s_m = np.linspace(start, end, max(2, round((end - start) / EDGE_STEP_M) + 1))
        left, right = self.path.point_m(s_m, self.left_m), self.path.point_m(s_m, self.right_m)
        if self.path.closed and span_m is None:
            inner, outer = sorted((Polygon(left[:-1]), Polygon(right[:-1])), key=lambda p: float(p.area))
            return outer.difference(inner)
        return Polygon(np.vstack([left, right[::-1]]))

    def is_free(self, start_m: float, end_m: float, side: int = 0, margin_m: float = 0.0) -> bool:
        """Whether no mouth (on a side, or any for 0) and no zebra lies between two s."""
        taken = [(low, high) for low, high, at in self.mouths_m if side in (0, at)]
        taken += [(zebra - 1.5, zebra + ZEBRA_M + 1.5) for zebra in self.zebras_m]
        return all(end_m + margin_m < low or start_m - margin_m > high for low, high in taken)

    def bays_m(self, side: int) -> Array:
        """s at which the parking bays of a side begin; none in a mouth, on a zebra or beyond the span."""
        starts = np.arange(self.path.start_m, self.path.end_m - BAY_M, BAY_M)
        return np.array(
            [
                s
                for s in starts
                if self.is_free(s, s + BAY_M, side, 0.5)
                and abs(self.path.curvature_1pm(s + BAY_M / 2, BAY_M)) < _TIGHTEST_PARKED_1PM
                and self.span_m[0] <= s
                and s + BAY_M <= self.span_m[1]
            ]
        )

    @property
    def bump_edges_m(self) -> tuple[float, float]:
        """d between which speed bumps lie, right and left: not in gutters, nor in the bays of an aisle."""
        margin = AISLE_BAY_M[0] if self.style == "aisle" else BUMP_GUTTER_M
        return self.right_m + margin, self.left_m - margin

    def across_bays_m(self, side: int) -> Array:
        """s at which the bays across an aisle begin, on one side; none where it is too narrow for them."""
        if self.width_m < 2 * AISLE_BAY_M[0]:
            return np.empty(0)
        first = self.path.start_m + (2.0 if side > 0 else 2.6)
        return np.arange(first, self.path.end_m - 2.0 - AISLE_BAY_M[1], AISLE_BAY_M[1])
