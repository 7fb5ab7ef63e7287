"""The ranges of settings, by what they mean: wide enough for any use, too narrow for what cannot work.

Where nothing else limits a number, its range ends where computing would take for ever or all memory.
"""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

Share = Annotated[float, Field(ge=0, le=1)]
PositiveShare = Annotated[float, Field(gt=0, le=1)]
Factor = Annotated[float, Field(gt=0, le=1000)]

Count = Annotated[int, Field(ge=0, le=100_000)]
PositiveCount = Annotated[int, Field(ge=1, le=100_000)]
PointCount = Annotated[int, Field(ge=5, le=100_000)]  # fewer leave a pose open
KeyframeCount = Annotated[int, Field(ge=2, le=1000)]
RepeatCount = Annotated[int, Field(ge=0, le=10)]
StepCount = Annotated[int, Field(ge=1, le=1000)]
CellPx = Annotated[int, Field(ge=2, le=1000)]
HalfPatchPx = Annotated[int, Field(ge=2, le=30)]

AngleRad = Annotated[float, Field(gt=0, le=3.1416)]
SearchRad = Annotated[float, Field(gt=0, le=0.1)]
SigmaRad = Annotated[float, Field(ge=1e-6, le=1)]

LengthM = Annotated[float, Field(gt=0, le=1000)]
LengthOrNoneM = Annotated[float, Field(ge=0, le=1000)]
SigmaM = Annotated[float, Field(ge=1e-6, le=100)]

SizePx = Annotated[float, Field(gt=0, le=1000)]
SizeOrNonePx = Annotated[float, Field(ge=0, le=1000)]
SigmaPx = Annotated[float, Field(ge=1e-3, le=100)]

RadPerMps2 = Annotated[float, Field(ge=0, le=1)]
MPerMps2 = Annotated[float, Field(ge=0, le=1)]

TimeS = Annotated[float, Field(gt=0, le=3600)]
ClockSigmaS = Annotated[float, Field(ge=1e-6, le=1)]
