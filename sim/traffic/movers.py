"""What those who give way need to know of those who do not: what ground they sweep over in a while."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from estimator.se3 import Array
from sim.traffic.conflicts import Cells
from sim.traffic.track import CELL_M, Track


class Movers(Protocol):
    """Actors whose motion is settled, whatever others do."""

    @property
    def tracks(self) -> Sequence[Track]:
        """The tracks they move along."""

    def swept_m(self, track: int, from_s: float, to_s: float) -> Array:
        """Return (K, 2) intervals of u on a track that some actor covers in that time."""


def is_swept(cells: Cells, track: Track, swept_m: Array) -> bool:
    """Whether any of a track's cells (numbered on their own) lies in any of (K, 2) intervals of u."""
    if not len(cells) or not len(swept_m):
        return False
    low, high = swept_m[:, :1] - CELL_M, swept_m[:, 1:]
    into = np.mod(cells[None] * CELL_M - low, track.ring_m)
    return bool((into < high - low).any())
