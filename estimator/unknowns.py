"""The order in which extrinsics, lenses and clocks of a rig stand in one vector."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from estimator.rig import Rig
from estimator.sighting_jacobians import LENS_SIZE


@dataclass(frozen=True, eq=False)
class Unknowns:
    """Extrinsics of the C estimated cameras, then lens and clock of all N, the reference too.

    The clock of the reference is the one that all others are compared with; it stands in the vector, so that
    all cameras are alike, and is held by its prior.
    """

    rig: Rig

    @cached_property
    def names(self) -> tuple[str, ...]:
        return tuple(self.rig.cameras)

    @cached_property
    def estimated(self) -> tuple[str, ...]:
        return self.rig.estimated_names

    @property
    def pose_size(self) -> int:
        """How many numbers the extrinsics take: they come first."""
        return 6 * len(self.estimated)

    @property
    def size(self) -> int:
        return self.pose_size + (LENS_SIZE + 1) * len(self.names)

    def extrinsics(self, camera: int) -> slice:
        first = 6 * self.estimated.index(self.names[camera])
        return slice(first, first + 6)

    def lens(self, camera: int) -> slice:
        first = self.pose_size + LENS_SIZE * camera
        return slice(first, first + LENS_SIZE)

    def clock(self, camera: int) -> int:
        return self.pose_size + LENS_SIZE * len(self.names) + camera
