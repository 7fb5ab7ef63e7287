"""The base of every configuration value: frozen, strict about names, no NaN, nothing silently repaired."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict


class Config(BaseModel):
    """A frozen group of settings; an unknown field or a NaN is refused with its path."""

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)
