"""What counts as lying before a camera: beyond 80 deg off its axis, the normalised plane is no use."""

from __future__ import annotations

import numpy as np

from estimator.observations import Mask
from estimator.se3 import Array

_MIN_COSINE = 0.17


def is_ahead(vectors_cam: Array, length: Array | float = 1.0) -> Mask:
    """Tell which (N, 3) vectors of given lengths lie within 80 deg of the optical axis; NaN does not."""
    with np.errstate(invalid="ignore"):
        return np.asarray(vectors_cam[:, 2] > _MIN_COSINE * length)
