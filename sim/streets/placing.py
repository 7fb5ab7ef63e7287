"""Placing things in a street: street coordinates become props, and nothing is put into something else."""

from __future__ import annotations

from dataclasses import dataclass

from estimator.se3 import Array
from sim.shapes.mesh import Mesh
from sim.streets.footprint import Ground, rectangle_m
from sim.streets.layout import KERB_M, Section
from sim.streets.path import Path
from sim.streets.scenery import Prop


@dataclass(frozen=True, eq=False)
class Thing:
    """A mesh ready to be placed: its skin, its size on the ground (along its yaw, across), its foot."""

    mesh: Mesh
    skin: str
    size_m: tuple[float, float]
    z_m: float = KERB_M


class Site:
    """One street being furnished: turns street coordinates into props and keeps things apart."""

    def __init__(
        self, name: str, path: Path, section: Section, ground: Ground, keep_clear_m: list[tuple[float, float]]
    ) -> None:
        self.name, self.path, self.section = name, path, section
        self.props: list[Prop] = []
        self._ground, self._keep_clear_m = ground, keep_clear_m

    def put(self, thing: Thing, s_m: float, d_m: float, turn_rad: float, clearance_m: float = 0.1) -> bool:
        """Place a thing unless it would stand in something else or on ground kept clear."""
        if any(low < s_m < high for low, high in self._keep_clear_m):
            return False
        at, yaw = self.path.point_m(s_m, d_m), float(self.path.heading_rad(s_m)) + turn_rad
        return self.put_at(thing, at, yaw, clearance_m)

    def put_at(self, thing: Thing, at: Array, yaw: float, clearance_m: float = 0.0) -> bool:
        """Place a thing at a world position unless it would stand in something else."""
        outline = rectangle_m(at, yaw, *thing.size_m)
        if not self._ground.claim(outline, clearance_m):
            return False
        name = f"{self.name}_{len(self.props)}"
        self.props.append(
            Prop(name, thing.mesh, thing.skin, (float(at[0]), float(at[1]), thing.z_m), yaw, outline)
        )
        return True
