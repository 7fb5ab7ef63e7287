"""What can happen to a camera's mounting during a drive, as settings: when, to whom, how much.

A movement is an angle about one axis and a length in one direction, both drawn by seed, times a share that
depends on time only: 0 before the event, 1 at its full size.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated, Literal, Self

import numpy as np
from pydantic import Field, model_validator

from estimator.errors import InputError
from estimator.rig import Rig
from sim.some_cameras import SomeCameras, check_names

_PARTS = ((0.5, 1.0), (0.3, 0.87), (0.2, 1.11))  # of a vibration: weight, frequency ratio; they beat


class MountEvent(SomeCameras):
    """What all events say; a list's place seeds the directions, so times and sizes may change alone.

    Attributes:
        at_s: When it begins, since the drive began.
        camera: One name, several, or ``all``, which leaves out the reference.
        rotation_deg: Angle at full size.
        translation_mm: Length at full size.
    """

    at_s: float = Field(ge=0.0, le=7200.0)
    rotation_deg: float = Field(0.0, ge=0.0, le=30.0)
    translation_mm: float = Field(0.0, ge=0.0, le=1000.0)

    @model_validator(mode="after")
    def _moves_something(self) -> Self:
        if self.rotation_deg == 0 and self.translation_mm == 0:
            raise ValueError("nothing would move; wanted rotation_deg or translation_mm above 0")
        return self

    def share(self, time_s: float, phases: Sequence[float]) -> float:
        """Return how much of the movement there is at a time; ``phases`` are random, 0 to 1."""
        raise NotImplementedError


class Knock(MountEvent):
    """A blow: at once, and for good."""

    kind: Literal["knock"]

    def share(self, time_s: float, phases: Sequence[float]) -> float:
        return 1.0 if time_s >= self.at_s else 0.0


class Creep(MountEvent):
    """A mounting that gives way evenly for a time."""

    kind: Literal["creep"]
    duration_s: float = Field(gt=0.0, le=7200.0)

    def share(self, time_s: float, phases: Sequence[float]) -> float:
        return min(max((time_s - self.at_s) / self.duration_s, 0.0), 1.0)


class Thermal(MountEvent):
    """Warming and cooling: to and fro, as a sine."""

    kind: Literal["thermal"]
    period_s: float = Field(ge=1.0, le=7200.0)

    def share(self, time_s: float, phases: Sequence[float]) -> float:
        return float(np.sin(2 * np.pi * max(time_s - self.at_s, 0.0) / self.period_s))


class Vibration(MountEvent):
    """A loose bracket: trembles about its place, stronger and weaker by turns, never beyond the sizes."""

    kind: Literal["vibration"]
    frequency_hz: float = Field(ge=1.0, le=200.0)
    duration_s: float | None = Field(None, gt=0.0, le=7200.0)

    def share(self, time_s: float, phases: Sequence[float]) -> float:
        since_s = time_s - self.at_s
        if since_s < 0.0 or (self.duration_s is not None and since_s >= self.duration_s):
            return 0.0
        return sum(
            weight * float(np.sin(2 * np.pi * (ratio * self.frequency_hz * since_s + phase)))
            for (weight, ratio), phase in zip(_PARTS, phases, strict=True)
        )


PHASES = len(_PARTS)
AnyMountEvent = Annotated[Knock | Creep | Thermal | Vibration, Field(discriminator="kind")]


def check_events(events: Sequence[MountEvent], rig: Rig) -> None:
    """Raise InputError where an event names a camera that is not in the rig, or the reference."""
    for index, event in enumerate(events):
        if rig.reference in event.names:
            raise InputError(
                f"miscalibration.events[{index}].camera: got {rig.reference!r}, the reference camera, whose "
                f"pose is known and fixed; there are: {', '.join(rig.estimated_names)}, or all"
            )
    check_names("miscalibration.events", events, rig.estimated_names)
