"""The size of the car, as far as it tells where road is and how its body dives."""

from __future__ import annotations

from pydantic import Field

from estimator.config import Config
from estimator.ranges import LengthM, LengthOrNoneM


class CorridorConfig(Config):
    """Where a car drives there is road: so far to each side, so far before and behind its middle.

    The middle is that of the wheelbase, so far ahead of the rear axle: between its wheels a car knows the
    road best, and about it the body dives when it brakes.
    """

    half_width_m: LengthM = 1.4
    beyond_ends_m: LengthOrNoneM = 5.0
    middle_m: float = Field(1.35, ge=-20, le=20)
