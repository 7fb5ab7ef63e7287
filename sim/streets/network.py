"""The road network of a street: everything that can be known of it before anything is built or painted.

Traffic keeps right. Roads and kerbs carry street coordinates; ``sim.streets.relief`` carries heights.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from shapely.geometry import MultiPolygon, Polygon

from estimator.se3 import Array
from sim.streets.kerb import KerbLine
from sim.streets.path import Path
from sim.streets.relief import Relief
from sim.streets.road import Road


@dataclass(frozen=True, eq=False)
class Lane:
    """Where traffic of one kind moves.

    Attributes:
        kind: What moves in it.
        path: Its centre in the direction of travel, through junctions; closed where the road is.
        speed_mps: What is driven there when nothing is in the way.
        gives_way_m: s of the line at which it gives way to what crosses, or None.
        is_route: Whether the simulated car drives in it.
    """

    kind: Literal["car", "bike", "foot"]
    path: Path
    speed_mps: float
    gives_way_m: float | None = None
    is_route: bool = False

    @property
    def closed(self) -> bool:
        return self.path.closed


@dataclass(frozen=True, eq=False)
class Junction:
    """A place where a road opens into another one.

    Attributes:
        outline: The surface that belongs to neither road's plain strip.
        yaw_rad: Heading of the road that goes through, along which the surface is painted.
        wear: As of the roads.
        teeth_m: (N, 3, 2) triangles of give-way lines in world xy.
    """

    outline: Polygon
    yaw_rad: float
    wear: float
    teeth_m: Array


@dataclass(frozen=True)
class Bay:
    """A parking place on the carriageway.

    Attributes:
        center_m: World xy of its middle.
        yaw_rad: Heading of a car parked in it.
        is_across: Whether it stands across the aisle rather than along the kerb.
    """

    center_m: tuple[float, float]
    yaw_rad: float
    is_across: bool = False


@dataclass(frozen=True, eq=False)
class Tunnel:
    """A covered stretch of a road.

    Attributes:
        road: Name of the road.
        span_m: Interval of s that is covered.
        height_m: From the carriageway to the ceiling.
        outline_m: (N, 2) what is covered, in world xy.
        portals_m: (2, 2) the middles of its openings.
    """

    road: str
    span_m: tuple[float, float]
    height_m: float
    outline_m: Array
    portals_m: Array


@dataclass(frozen=True, eq=False)
class Network:
    """A whole plan.

    Attributes:
        roads: Every carriageway.
        junctions: The surfaces between their plain strips.
        kerbs: Along the edges; see ``KerbLine``.
        lanes: Where traffic moves.
        bays: Where cars may park.
        route: Centre of the lane the car drives: through the origin along +x at s = 0; starts before, and
            ends beyond, or is closed.
        carriageway: All that is driven on.
        relief: Heights.
        tunnels: Covered stretches.
    """

    roads: tuple[Road, ...]
    junctions: tuple[Junction, ...]
    kerbs: tuple[KerbLine, ...]
    lanes: tuple[Lane, ...]
    bays: tuple[Bay, ...]
    route: Path
    carriageway: MultiPolygon
    relief: Relief
    tunnels: tuple[Tunnel, ...] = ()

    def road(self, name: str) -> Road:
        """Return the road of a name."""
        return next(road for road in self.roads if road.name == name)


def driven_line_m(route: Path, length_m: float) -> Array:
    """(N, 2) centre of the driven lane from the origin on, somewhat longer than the street, 0.25 m apart.

    A closed route gives one lap whose last point is its first.
    """
    if route.closed:
        return route.point_m(np.linspace(0.0, route.length_m, round(route.length_m / 0.25) + 1))
    return route.point_m(np.arange(0.0, min(length_m + 20.0, route.end_m), 0.25))
