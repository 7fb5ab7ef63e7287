"""Settings of the watch over lenses and clocks."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from estimator.clock_doubt import ClockDoubtConfig
from estimator.clock_or_shift import ClockOrShiftConfig
from estimator.config import Config
from estimator.evidence import UsualErrors
from estimator.lens_findings import AccusationConfig
from estimator.ranges import Factor, PositiveShare

Refine = Literal["none", "intrinsics", "clocks", "both"]


class LensConfig(Config):
    """What is usual, what is told, and when a window is adjusted again.

    Lens and clock have settled once a round changes them by less than ``settled`` times the usual error.
    ``clocks_in_step`` says that one trigger or one clock serves all cameras: then what a late clock could do
    is left out of what is stated of poses. A clock that is clearly late is told all the same.
    """

    usual: UsualErrors = UsualErrors()
    accuse: AccusationConfig = AccusationConfig()
    suspect_sigmas: Factor = 3.0
    rounds: int = Field(6, ge=0, le=100)
    settled: PositiveShare = 0.03
    clocks_in_step: bool = False
    doubt: ClockDoubtConfig = ClockDoubtConfig()
    late_or_shifted: ClockOrShiftConfig = ClockOrShiftConfig()
