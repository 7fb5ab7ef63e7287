"""One lot: the ground of a house or a garden, and the manners in which streets are cut into lots."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from estimator.se3 import Array

Facades = Literal["varied", "bare", "repeated"]
Use = Literal["house", "garden", "closing"]
MODULE_M = 8.4  # front of a repeated house
_SETBACKS_M = (0.0, 0.0, 0.0, 0.35, 2.6)
_SUBURB_SETBACKS_M = (4.0, 5.0, 6.0)


@dataclass(frozen=True, eq=False)
class Lot:
    """Ground for one house.

    Attributes:
        front_m: (2, 2) world xy of its left and right front corner, seen from the street.
        back_m: (2, 2) the corners behind.
        setback_m: How far its front stands behind the facade line.
        curb_m: Height of the pavement before it over the ground.
        use: What is on it: a house, a garden without one, or a house across the end of a street.
        seen: Whether its left and right side walls face a street.
        gateway_m: Width of the gateway in the middle of its front, through which a street leaves; 0 for none.
    """

    front_m: Array
    back_m: Array
    setback_m: float
    curb_m: float
    use: Use = "house"
    seen: tuple[bool, bool] = (False, False)
    gateway_m: float = 0.0

    @property
    def outline_m(self) -> Array:
        """(4, 2) counter-clockwise."""
        return np.array([self.front_m[0], self.front_m[1], self.back_m[1], self.back_m[0]])

    @property
    def width_m(self) -> float:
        """Of its front."""
        return float(np.linalg.norm(self.front_m[1] - self.front_m[0]))

    @property
    def along(self) -> Array:
        """(2,) unit vector from the left to the right end of the front."""
        return np.asarray((self.front_m[1] - self.front_m[0]) / self.width_m)

    @property
    def outward(self) -> Array:
        """(2,) unit vector from the front towards the street."""
        return np.array([self.along[1], -self.along[0]])


@dataclass(frozen=True)
class Manner:
    """How a kerb is built up: intervals from which fronts and setbacks are drawn."""

    front_m: tuple[float, float]
    setbacks_m: tuple[float, ...]
    garden_share: float


MANNERS = {
    "varied": Manner((5.5, 11.0), _SETBACKS_M, 0.17),
    "bare": Manner((9.0, 16.0), (0.0,), 0.0),
    "repeated": Manner((MODULE_M, MODULE_M), (0.0,), 0.0),
}
SUBURB = Manner((11.0, 17.0), _SUBURB_SETBACKS_M, 0.1)
