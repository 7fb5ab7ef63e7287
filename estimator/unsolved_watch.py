"""Watch whether windows can be solved at all: one that cannot teaches nothing, which should not go unsaid."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise

import numpy as np

from estimator.config import Config
from estimator.finding import Finding, FindingKind
from estimator.keyframe import Keyframe
from estimator.ranges import StepCount


class UnsolvedWatchConfig(Config):
    """How many windows in a row may fail without a word."""

    windows: StepCount = 3


class UnsolvedWatch:
    """Counts the windows in a row that could not be solved."""

    def __init__(self, reference: str, config: UnsolvedWatchConfig) -> None:
        self._reference = reference
        self._config = config
        self._count, self._length_m = 0, 0.0

    def see(self, keyframes: Sequence[Keyframe], *, solved: bool) -> None:
        """Take note of a window."""
        if solved:
            self._count, self._length_m = 0, 0.0
            return
        self._count += 1
        places_m = [keyframe.world_from_ego.translation for keyframe in keyframes]
        self._length_m += sum(float(np.linalg.norm(after - before)) for before, after in pairwise(places_m))

    def findings(self) -> Iterator[Finding]:
        """Yield what lasts."""
        if self._count >= self._config.windows:
            about = (
                f"none of the last {self._count} windows ({self._length_m:.0f} m) could be solved: too few "
                "sightings agree with any path and rig near what is believed; the images show too little, or "
                "the rig file is too far off; nothing was learnt of any camera meanwhile"
            )
            yield Finding(FindingKind.UNSOLVED_WINDOWS, (self._reference,), about, doubtful=False)
