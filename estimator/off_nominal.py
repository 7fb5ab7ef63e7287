"""How far from the rig file an answer may lie before the file must be that of another rig."""

from __future__ import annotations

import numpy as np

from estimator.config import Config
from estimator.ranges import AngleRad, LengthM
from estimator.se3 import Array


class OffNominal(Config):
    """The wide limit: nothing beyond it is ever called converged."""

    max_rotation_rad: AngleRad = 0.26
    max_translation_m: LengthM = 0.5

    def is_beyond(self, off: Array) -> bool:
        """Tell whether a (6,) tangent from the rig file's pose to the answer is too far to be believed."""
        return bool(
            np.linalg.norm(off[:3]) > self.max_rotation_rad
            or np.linalg.norm(off[3:]) > self.max_translation_m
        )
