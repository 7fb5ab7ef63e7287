"""What the image sensor adds: shot and read noise."""

from __future__ import annotations

from pydantic import Field

from estimator.config import Config


class SensorConfig(Config):
    """Sensor noise; 1 is a decent automotive sensor by day, 0 is none."""

    noise: float = Field(1.0, ge=0.0, le=20.0)
