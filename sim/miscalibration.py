"""Seeded errors of the cameras' mounting: what the estimator has to find."""

from __future__ import annotations

from pydantic import Field

from estimator.config import Config


class MiscalibrationConfig(Config):
    """Exact size of every camera's error: an angle about a random axis, a length in a random direction."""

    rotation_deg: float = Field(3.0, ge=0.0, le=30.0)
    translation_mm: float = Field(100.0, ge=0.0, le=1000.0)
