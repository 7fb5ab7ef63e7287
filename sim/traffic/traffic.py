"""Everything that moves besides the driven car: which actors there are, and where they are at any time.

Actors have no physics and collide with nothing. Those in the driven lane are tied to the car's plan;
other cars give way to them, cyclists to all cars, pedestrians to all that rolls. So cyclists change no
car, and pedestrians change neither.
"""

from __future__ import annotations

from collections.abc import Sequence

import mujoco

from sim.traffic.troupe import Troupe


class Traffic:
    """All actors; knows how to enter a spec and where everybody is at a time."""

    def __init__(self, troupes: Sequence[Troupe]) -> None:
        self.troupes = tuple(troupes)

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add a mocap body for every part of every actor."""
        for troupe in self.troupes:
            troupe.write_into(spec)

    def place(self, data: mujoco.MjData, time_s: float) -> None:
        """Put everybody where they are at a time since the drive began; any times, in any order."""
        for troupe in self.troupes:
            troupe.place(data, time_s)


NOBODY = Traffic(())
