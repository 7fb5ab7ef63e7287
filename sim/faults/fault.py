"""What all faults share: which cameras they strike, and from when to when."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from sim.frame import Frame
from sim.some_cameras import SomeCameras

_ROUNDING_S = 1e-9  # three tenths of a second is not quite two tenths and one


class Fault(SomeCameras):
    """Something wrong with the images of some cameras, all drive long."""

    kind: str

    def lasts(self, time_s: float) -> bool:
        """Tell whether the fault is there at an instant, counted from the drive's start."""
        return True

    def spoil(self, frame: Frame, sound: Frame, rng: np.random.Generator) -> tuple[Frame, ...]:
        """Return what becomes of a frame: nothing, itself changed, or several.

        Args:
            frame: As it comes to this fault.
            sound: The last frame of this camera before the fault began; ``frame`` if there was none.
            rng: Seeded by fault, camera and frame.
        """
        raise NotImplementedError


class PassingFault(Fault):
    """A fault that begins at a time, and ends where ``duration_s`` is given.

    It judges an image by the instant of its exposure, so whatever other faults did to its stamp makes no
    difference.
    """

    at_s: float = Field(0.0, ge=0.0, le=3600.0)
    duration_s: float | None = Field(None, gt=0.0, le=3600.0)

    def lasts(self, time_s: float) -> bool:
        since_s = time_s - self.at_s + _ROUNDING_S
        return since_s >= 0 and (self.duration_s is None or since_s < self.duration_s)
