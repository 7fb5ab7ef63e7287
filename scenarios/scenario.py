"""What one scenario is: a world, the nominal rig of the car in it, and a sentence about it."""

from __future__ import annotations

from dataclasses import dataclass

from pydantic import Field

from estimator.rig import Rig
from sim.world import WorldConfig


class ScenarioEntry(WorldConfig):
    """The keys of a scenario file once ``base`` is resolved: the world's, and two of its own."""

    about: str = Field(min_length=1)
    rig: str = "gap"

    def world(self) -> WorldConfig:
        """Return the part that the simulator takes."""
        return WorldConfig(**{name: getattr(self, name) for name in WorldConfig.model_fields})


@dataclass(frozen=True)
class Scenario:
    """A loaded scenario.

    Attributes:
        name: The file's name without its suffix.
        about: One sentence: what it tests and what it should do to an estimator.
        rig: The nominal rig, which the estimator gets.
        world: Everything else that the simulator takes besides the seed.
    """

    name: str
    about: str
    rig: Rig
    world: WorldConfig
