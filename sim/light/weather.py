"""Light: where the sun stands."""

from __future__ import annotations

from pydantic import Field

from estimator.config import Config


class WeatherConfig(Config):
    """Sun position; azimuth is counted from world +x (the first driving direction) to the left."""

    sun_elevation_deg: float = Field(40.0, ge=5.0, le=90.0)
    sun_azimuth_deg: float = Field(60.0, ge=-360.0, le=360.0)
