"""A procedurally generated street."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from estimator.config import Config


class StreetConfig(Config):
    """Which street, and how long."""

    kind: Literal["bend"] = "bend"
    length_m: float = Field(70.0, ge=20.0, le=2000.0)
