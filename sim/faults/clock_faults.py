"""Faults of what an image says about its time: the camera's clock is off, or trembles."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

import numpy as np
from pydantic import Field

from sim.faults.fault import PassingFault
from sim.frame import Frame

_NS_PER_MS = 1e6
_FARTHEST_SIGMAS = 3.0  # a clock trembles within bounds


class ClockOffset(PassingFault):
    """The camera's clock is ahead (positive) or behind: stamps are off, images arrive as ever."""

    kind: Literal["clock_offset"]
    offset_ms: float = Field(30.0, ge=-1000.0, le=1000.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        return (_shifted(frame, self.offset_ms),)


class Jitter(PassingFault):
    """Each stamp is off by its own random amount, Gaussian up to three sigma."""

    kind: Literal["jitter"]
    sigma_ms: float = Field(5.0, gt=0.0, le=500.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        off = float(np.clip(rng.standard_normal(), -_FARTHEST_SIGMAS, _FARTHEST_SIGMAS))
        return (_shifted(frame, self.sigma_ms * off),)


def _shifted(frame: Frame, by_ms: float) -> Frame:
    return replace(frame, stamp_ns=max(0, frame.stamp_ns + round(by_ms * _NS_PER_MS)))
