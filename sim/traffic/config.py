"""How much traffic there is, and what each degree of it means in metres."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from estimator.config import Config

_DEGREES = (1.0, 2.0, 3.0, 4.0, 5.0)
CAR_SPACING_M = (80.0, 48.0, 28.0, 15.0, 8.6)  # from nose to nose in one lane
CYCLIST_SPACING_M = (70.0, 40.0, 24.0, 14.0, 8.0)
PEDESTRIAN_SPACING_M = (48.0, 26.0, 14.0, 8.0, 4.5)  # in one direction of one pavement
PLATOON_GAP_M = (32.0, 17.0, 9.0, 4.5, 2.6)  # to the vehicle ahead at a standstill
PLATOON_GAP_S = (2.0, 1.7, 1.4, 1.1, 0.8)  # more of it with speed
_JAM_FROM = 3.5  # stop-and-go waves run through denser traffic than this


class TrafficConfig(Config):
    """Density of everything that moves: 0 none, 1 a quiet Sunday, 3 a busy day, 5 a jam."""

    cars: float = Field(0.0, ge=0.0, le=5.0)
    cyclists: float = Field(0.0, ge=0.0, le=5.0)
    pedestrians: float = Field(0.0, ge=0.0, le=5.0)

    @property
    def is_empty(self) -> bool:
        return self.cars == self.cyclists == self.pedestrians == 0


def at_degree(table: tuple[float, ...], degree: float) -> float:
    """Look up a table of lengths for degrees 1 to 5; below 1 the spacing grows as 1 / degree."""
    spread = float(np.exp(np.interp(degree, _DEGREES, np.log(table))))
    return spread / min(degree, 1.0)


def jam_share(degree: float) -> float:
    """How far stop-and-go waves have grown, 0 to 1."""
    return float(np.clip((degree - _JAM_FROM) / (5.0 - _JAM_FROM), 0.0, 1.0))
