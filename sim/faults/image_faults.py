"""Faults of what an image shows: frozen, black, overexposed, of another size."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated, Literal

import cv2
import numpy as np
from pydantic import Field

from sim.faults.fault import PassingFault
from sim.frame import Frame

Length = Annotated[int, Field(ge=8, le=4096)]


class Frozen(PassingFault):
    """The camera sends its last image again and again, each time with a new stamp."""

    kind: Literal["frozen"]

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        return (replace(frame, image=sound.image),)


class Black(PassingFault):
    """Frames without light, as from a covered lens or a sensor that lost its exposure."""

    kind: Literal["black"]
    probability: float = Field(1.0, gt=0.0, le=1.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        if rng.random() >= self.probability:
            return (frame,)
        return (replace(frame, image=np.zeros_like(frame.image)),)


class Overexposed(PassingFault):
    """Frames exposed too long: all levels times ``gain``, the bright ones clipped."""

    kind: Literal["overexposed"]
    probability: float = Field(1.0, gt=0.0, le=1.0)
    gain: float = Field(6.0, gt=1.0, le=100.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        if rng.random() >= self.probability:
            return (frame,)
        light = frame.image.astype(np.float32) * np.float32(self.gain)
        return (replace(frame, image=np.clip(np.rint(light), 0, 255).astype(np.uint8)),)


class WrongResolution(PassingFault):
    """The camera sends images of another size than the rig file states, of the same field of view."""

    kind: Literal["wrong_resolution"]
    size_px: list[Length] = Field([320, 200], min_length=2, max_length=2)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        image = cv2.resize(frame.image, (self.size_px[0], self.size_px[1]), interpolation=cv2.INTER_AREA)
        return (replace(frame, image=np.asarray(image, np.uint8)),)
