"""When a picture is taken, as far as light and weather ask."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

from estimator.se3 import SE3, Array
from sim.light.vehicles import Vehicle, driven_vehicle


@dataclass(frozen=True, eq=False)
class Instant:
    """When a picture is taken, and how the car moves then.

    Attributes:
        time_s: Since the drive began.
        world_from_ego: Pose of the car.
        velocity_mps: (3,) of the car in the world.
        vehicles: Those of the traffic that are near.
    """

    time_s: float
    world_from_ego: SE3
    velocity_mps: Array
    vehicles: tuple[Vehicle, ...] = ()

    @cached_property
    def own(self) -> Vehicle:
        """The driven car; the same value for every view."""
        return driven_vehicle(self.world_from_ego)
