"""When each row of an image is exposed, and which instants of the world that takes.

An exposure is a window of time around the middle of each row; with a rolling shutter the windows follow each
other down the image, and the middle row's is centred on the image's stamp. The whole time is cut into equal
slots, each shown by one picture taken at its middle. A row is the mean of the slots in its window.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.sensing.exposure import Exposure

STRIP_PX = 6.0  # what a slot may move where rows are put to their own instants afterwards
BLUR_STEP_PX = 1.25  # what it may move from one picture to the next of those that make a blur
_LEAST_BLUR_PX = 0.25  # less is a point
_COUNTS = (1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64)  # few, so that cameras take pictures together
_LONGEST_BLUR_S = 0.033  # a camera of 30 images a second has no more


@dataclass(frozen=True)
class Shutter:
    """How long the exposure of an image takes.

    Attributes:
        readout_s: From the first row to the end of the last.
        blur_s: How long one row collects light; 0 for an instant.
    """

    readout_s: float = 0.0
    blur_s: float = 0.0

    @property
    def is_instant(self) -> bool:
        return self.readout_s == 0 and self.blur_s == 0


@dataclass(frozen=True, eq=False)
class Slot:
    """One picture's part in an image.

    Attributes:
        time_s: When it is taken, from the middle of the image's exposure.
        first, last: The rows it is part of, the last not included.
        weights: (last - first,) its share of each.
        delay_s: (last - first,) how long after the picture the middle of that share is.
    """

    time_s: float
    first: int
    last: int
    weights: Array
    delay_s: Array


def blur_s(exposure: Exposure, severity: float) -> float:
    """Return how long a row collects light: 1, 3, 7, 15, 31 exposure times at severity 1 to 5."""
    return min((2**severity - 1) * exposure.time_s, _LONGEST_BLUR_S)


def slot_count(shutter: Shutter, fastest_px_s: float) -> int:
    """Return how many pictures an image takes when what it shows moves this fast."""
    whole_s = shutter.readout_s + shutter.blur_s
    blur_px = shutter.blur_s * fastest_px_s
    count = np.ceil(whole_s * fastest_px_s / STRIP_PX)
    if blur_px > _LEAST_BLUR_PX:
        in_window = max(2.0, np.ceil(blur_px / BLUR_STEP_PX))
        count = max(count, np.ceil(in_window * whole_s / shutter.blur_s))
    return next((enough for enough in _COUNTS if enough >= count), _COUNTS[-1])


def slots(shutter: Shutter, rows: int, count: int) -> list[Slot]:
    """Cut the exposure of an image of ``rows`` into ``count`` slots; each row's weights add up to 1."""
    whole_s = shutter.readout_s + shutter.blur_s
    edges_s = np.linspace(-whole_s / 2, whole_s / 2, count + 1)
    middles_s = shutter.readout_s * ((np.arange(rows) + 0.5) / rows - 0.5)
    low_s = np.maximum(edges_s[:-1, None], middles_s - shutter.blur_s / 2)  # (count, rows)
    high_s = np.minimum(edges_s[1:, None], middles_s + shutter.blur_s / 2)
    if shutter.blur_s > 0:
        weights = np.maximum(high_s - low_s, 0) / shutter.blur_s
    else:
        nearest = np.clip(np.searchsorted(edges_s, middles_s, side="right") - 1, 0, count - 1)
        weights = (np.arange(count)[:, None] == nearest).astype(float)
    weights = np.where(weights < 1e-6, 0.0, weights)
    weights /= weights.sum(axis=0)
    times_s = (edges_s[:-1] + edges_s[1:]) / 2
    return [
        _slot(float(time_s), share, middle_s)
        for time_s, share, middle_s in zip(times_s, weights, (low_s + high_s) / 2, strict=True)
        if share.any()
    ]


def _slot(time_s: float, weights: Array, middle_s: Array) -> Slot:
    used = np.flatnonzero(weights)
    first, last = int(used[0]), int(used[-1]) + 1
    delay_s = middle_s[first:last] - time_s
    delay_s[np.abs(delay_s) < 1e-9] = 0.0
    return Slot(time_s, first, last, weights[first:last], delay_s)
