"""What all faults share: which cameras they strike, and from when to when."""

from __future__ import annotations

import numpy as np
from pydantic import Field, field_validator

from estimator.config import Config
from sim.frame import Frame

ALL = "all"
_ROUNDING_S = 1e-9  # three tenths of a second is not quite two tenths and one


class Fault(Config):
    """Something wrong with the images of some cameras, all drive long."""

    kind: str
    camera: str | list[str]

    @field_validator("camera", mode="before")
    @classmethod
    def _is_a_name_or_several(cls, value: object) -> object:
        names = value if isinstance(value, list) else [value]
        if not names or not all(isinstance(name, str) and name for name in names):
            raise ValueError(f"got {value!r}, wanted the name of a camera, a list of names, or all")
        return value

    @property
    def names(self) -> tuple[str, ...]:
        """The cameras as written; ``("all",)`` for all."""
        return (self.camera,) if isinstance(self.camera, str) else tuple(self.camera)

    def strikes(self, camera: str) -> bool:
        """Tell whether this camera's images suffer."""
        return self.camera == ALL or camera in self.names

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
