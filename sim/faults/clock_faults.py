"""Faults of time: the camera's clock is off, or its stamps tremble."""

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
    """The camera's clock is ahead (positive) or behind, and with it the shutter.

    The stamps look right, since they come from that clock; the images show the world ``offset_ms`` earlier
    than they say (``sim.faults.own_clocks``).
    """

    kind: Literal["clock_offset"]
    offset_ms: float = Field(20.0, ge=-200.0, le=200.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        """Change nothing: the image was taken at the wrong time already."""
        return (frame,)


class Jitter(PassingFault):
    """Exposures are regular, but each stamp is off by its own random amount, Gaussian up to three sigma."""

    kind: Literal["jitter"]
    sigma_ms: float = Field(5.0, gt=0.0, le=500.0)

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        off = float(np.clip(rng.standard_normal(), -_FARTHEST_SIGMAS, _FARTHEST_SIGMAS))
        off_ns = round(self.sigma_ms * off * _NS_PER_MS)
        return (replace(frame, stamp_ns=max(0, frame.stamp_ns + off_ns)),)
