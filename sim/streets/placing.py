"""Placing things along a kerb: kerb coordinates become props, and nothing is put into something else."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from estimator.se3 import Array
from sim.shapes.mesh import Mesh
from sim.streets.footprint import Ground, rectangle_m
from sim.streets.kerb import KerbLine
from sim.streets.relief import Relief
from sim.streets.scenery import Prop

TO_STREET, TO_TRAFFIC, TO_HOUSES = (
    -np.pi / 2,
    0.0,
    np.pi / 2,
)  # turns of what has a front, relative to the kerb


@dataclass(frozen=True, eq=False)
class Thing:
    """A mesh ready to be placed: its skin and its size on the ground (along its yaw, across)."""

    mesh: Mesh
    skin: str
    size_m: tuple[float, float]


class Site:
    """The ground of a street while it is furnished: places things at world positions and keeps them apart."""

    def __init__(self, name: str, ground: Ground, relief: Relief, driven_m: Array) -> None:
        self.name, self.ground, self.relief = name, ground, relief
        self.props: list[Prop] = []
        self._driven = cKDTree(driven_m)

    def from_route_m(self, at: Array) -> float:
        """Distance of a world position from the driven line."""
        return float(self._driven.query(np.asarray(at))[0])

    def put_at(
        self,
        thing: Thing,
        at: Array,
        yaw: float,
        over_m: float = 0.0,
        clearance_m: float = 0.0,
        shown: bool = True,
    ) -> bool:
        """Place a thing unless it would stand in something else.

        Args:
            thing: What to place.
            at: (2,) world xy.
            yaw: Its heading.
            over_m: Height of its foot over the terrain.
            clearance_m: Room to leave around it.
            shown: Whether it is built; else its ground is only kept free, so that what comes later stands
                where it would have stood anyway.
        """
        outline = rectangle_m(at, yaw, *thing.size_m)
        if not self.ground.claim(outline, clearance_m):
            return False
        z = float(self.relief.height_m(np.asarray(at))) + over_m
        if shown:
            name = f"{self.name}_{len(self.props)}"
            self.props.append(
                Prop(name, thing.mesh, thing.skin, (float(at[0]), float(at[1]), z), yaw, outline)
            )
        return True


class KerbSite:
    """One kerb being furnished: s along it, d from its edge towards the houses."""

    def __init__(self, site: Site, kerb: KerbLine) -> None:
        self.site, self.kerb = site, kerb

    def is_clear(self, s_m: float) -> bool:
        """Whether things may stand on the pavement at s, and s lies on the kerb."""
        path = self.kerb.path
        if not path.closed and not path.start_m + 0.5 < s_m < path.end_m - 0.5:
            return False
        return not any(low < s_m < high for low, high in self.kerb.keep_clear_m)

    def put(
        self,
        thing: Thing,
        s_m: float,
        d_m: float,
        turn_rad: float,
        clearance_m: float = 0.1,
        shown: bool = True,
    ) -> bool:
        """Place a thing, turned relative to the kerb, unless the place is taken or kept clear."""
        if not self.is_clear(s_m):
            return False
        at, yaw = self.kerb.path.point_m(s_m, d_m), float(self.kerb.path.heading_rad(s_m)) + turn_rad
        return self.site.put_at(thing, at, yaw, self.kerb.height_m, clearance_m, shown)

    def steps(self, first_m: float, every_m: float) -> Array:
        """Values of s at a spacing, from a distance behind the start on."""
        path = self.kerb.path
        return np.arange(path.start_m + first_m, path.end_m - 0.5 * every_m * path.closed, every_m)
