"""Faults on the way from camera to recorder: images lost, late, sent twice, or on the other's cable."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, field_validator

from sim.faults.fault import PassingFault
from sim.frame import Frame
from sim.some_cameras import ALL

_NS_PER_MS = 1_000_000


class Dropped(PassingFault):
    """Some frames never arrive."""

    kind: Literal["dropped"]
    probability: float = Field(0.3, gt=0.0, le=1.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        return () if rng.random() < self.probability else (frame,)


class Off(PassingFault):
    """The camera sends nothing at all."""

    kind: Literal["off"]

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        return ()


class Late(PassingFault):
    """Some frames arrive ``delay_ms`` later than they should, rightly stamped."""

    kind: Literal["late"]
    probability: float = Field(0.3, gt=0.0, le=1.0)
    delay_ms: float = Field(250.0, gt=0.0, le=10_000.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        late = rng.random() < self.probability
        return (_delayed(frame, self.delay_ms),) if late else (frame,)


class Duplicated(PassingFault):
    """Some frames arrive a second time, ``delay_ms`` after the first, with the same stamp."""

    kind: Literal["duplicated"]
    probability: float = Field(0.3, gt=0.0, le=1.0)
    delay_ms: float = Field(20.0, ge=0.0, le=10_000.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        twice = rng.random() < self.probability
        return (frame, _delayed(frame, self.delay_ms)) if twice else (frame,)


class Swapped(PassingFault):
    """Two cameras are plugged into each other's socket."""

    kind: Literal["swapped"]
    camera: Annotated[list[str], Field(min_length=2, max_length=2)]

    @field_validator("camera")
    @classmethod
    def _are_two(cls, names: list[str]) -> list[str]:
        if names[0] == names[1] or ALL in names:
            raise ValueError(f"got {names}, wanted two different cameras")
        return names

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        first, second = self.camera
        return (replace(frame, camera=second if frame.camera == first else first),)


def _delayed(frame: Frame, delay_ms: float) -> Frame:
    return replace(frame, arrival_ns=frame.arrival_ns + round(delay_ms * _NS_PER_MS))
