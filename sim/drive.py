"""How the car is driven."""

from __future__ import annotations

from pydantic import Field

from estimator.config import Config


class DriveConfig(Config):
    """Speed, length and bundle rate of a drive."""

    speed_mps: float = Field(5.0, gt=0.0, le=40.0)
    distance_m: float = Field(50.0, gt=0.0, le=2000.0)
    rate_hz: float = Field(10.0, ge=1.0, le=60.0)
