"""What an estimator is fed: the images of all cameras at one instant."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Image = npt.NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class FrameBundle:
    """Images taken together.

    Attributes:
        stamp_ns: Middle of the exposure, nanoseconds on any clock that does not jump.
        images: By camera name, (H, W) grey; a missing image is an absent key.
    """

    stamp_ns: int
    images: Mapping[str, Image]
