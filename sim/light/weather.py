"""The settings of light and weather: where the sun stands, and how bad each effect is, 0 (off) to 5."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from pydantic import Field

from estimator.config import Config

Severity = Annotated[float, Field(ge=0.0, le=5.0)]
Ladder = tuple[float, float, float, float, float, float]


class WeatherConfig(Config):
    """Sun and severities; azimuth is counted from world +x (the first driving direction) to the left.

    ``tunnel`` is how dark the street's tunnels are inside; where there are none it changes nothing.
    """

    sun_elevation_deg: float = Field(40.0, ge=5.0, le=90.0)
    sun_azimuth_deg: float = Field(60.0, ge=-360.0, le=360.0)
    overcast: Severity = 0.0
    dusk: Severity = 0.0
    night: Severity = 0.0
    tunnel: Severity = 0.0
    fog: Severity = 0.0
    rain: Severity = 0.0
    wet_lens: Severity = 0.0
    flare: Severity = 0.0


def on_ladder(severity: float, values: Ladder) -> float:
    """Read a quantity off its values at severities 0 to 5, straight between them."""
    return float(np.interp(severity, np.arange(6), values))
