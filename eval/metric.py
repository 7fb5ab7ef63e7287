"""One figure of a run, or the reason why there is none.

A metric that could not be computed is never a zero, a NaN or an absent key: it is null with a reason.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

Better = Literal["lower", "higher"]


@dataclass(frozen=True)
class Missing:
    """Why a value does not exist."""

    reason: str


Value = float | Missing


@dataclass(frozen=True)
class Metric:
    """A value with its unit and direction.

    Attributes:
        value: The figure; None where it could not be computed or does not apply.
        unit: For people and tables, such as ``deg`` or ``mm``; ``1`` for a pure number.
        better: Which direction is an improvement.
        reason: Why the value is None; None where there is a value.
    """

    value: float | None
    unit: str
    better: Better
    reason: str | None = None

    def __post_init__(self) -> None:
        if (self.value is None) == (self.reason is None):
            raise ValueError(f"a metric has either a value or a reason, got {self.value} and {self.reason!r}")
        if self.value is not None and not math.isfinite(self.value):
            raise ValueError(f"a metric's value is finite or None, got {self.value}")

    def to_json(self) -> dict[str, float | str | None]:
        """Return the entry of ``scores.json``; ``reason`` only where the value is null."""
        entry: dict[str, float | str | None] = {"value": self.value, "unit": self.unit, "better": self.better}
        return entry if self.reason is None else entry | {"reason": self.reason}


def metric_from(value: Value, unit: str, better: Better) -> Metric:
    """Join a computed value with what the registry says of its key; a value that is not finite is missing."""
    if isinstance(value, Missing):
        return Metric(None, unit, better, value.reason)
    if not math.isfinite(value):
        return Metric(None, unit, better, "the value is not finite")
    return Metric(float(value), unit, better)
