"""Watch how far the answer lies from the rig file, and whether windows agree that it lies there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from estimator.belief import Belief
from estimator.config import Config
from estimator.finding import Finding, FindingKind
from estimator.off_nominal import OffNominal
from estimator.ranges import AngleRad, Count, Factor, LengthM
from estimator.rig import Rig


class PriorWatchConfig(Config):
    """What the prior of the rig file rules out, and what it takes to believe it all the same."""

    chi2: Factor = 27.9  # 0.9999 of a chi-square with six degrees of freedom
    agreeing_rotation_rad: AngleRad = 0.005
    agreeing_translation_m: LengthM = 0.05
    agreeing_windows: Count = 2


@dataclass(frozen=True)
class _Distance:
    """How far an answer is from the rig file.

    ``is_beyond`` is for more than can be believed; ``agreed`` counts windows in a row that changed it little.
    """

    rotation_rad: float
    translation_m: float
    chi2: float
    is_beyond: bool
    agreed: int


class PriorWatch:
    """Remembers, for every estimated camera, its distance from the rig file and how steady it is."""

    def __init__(self, rig: Rig, config: PriorWatchConfig, off_nominal: OffNominal) -> None:
        self._rig = rig
        self._off_nominal = off_nominal
        self._config = config
        self._distances: dict[str, _Distance] = {}

    def see(self, before: Belief, after: Belief) -> None:
        """Take note of what a window taught."""
        information = np.linalg.inv(Belief.nominal(self._rig).covariance[:6, :6])
        for name in self._rig.estimated_names:
            off = self._rig[name].ego_from_cam.local(after.rig[name].ego_from_cam)
            step = before.rig[name].ego_from_cam.local(after.rig[name].ego_from_cam)
            steady = (
                np.linalg.norm(step[:3]) < self._config.agreeing_rotation_rad
                and np.linalg.norm(step[3:]) < self._config.agreeing_translation_m
            )
            agreed = self._distances[name].agreed + 1 if steady and name in self._distances else 0
            self._distances[name] = _Distance(
                float(np.linalg.norm(off[:3])),
                float(np.linalg.norm(off[3:])),
                float(off @ information @ off),
                self._off_nominal.is_beyond(off),
                agreed,
            )

    def findings(self) -> Iterator[Finding]:
        """Yield the cameras whose answer the prior rules out.

        Such an answer may be right: a camera was bent in a crash, a rig file was measured badly. It is in
        doubt while windows do not agree on it, and where it is so far off that the file is of another rig.
        """
        for name, distance in self._distances.items():
            if distance.chi2 > self._config.chi2:
                doubt = self._doubt(distance)
                about = (
                    f"{name} is {np.rad2deg(distance.rotation_rad):.1f} deg and "
                    f"{1000 * distance.translation_m:.0f} mm from its pose in the rig file, whose prior is "
                    f"{self._rig.prior.rotation_deg:g} deg and {self._rig.prior.translation_mm:g} mm: "
                    f"{doubt or f'{distance.agreed + 1} windows in a row agree on it'}"
                )
                yield Finding(FindingKind.NOMINAL_REJECTED, (name,), about, doubtful=bool(doubt))

    def _doubt(self, distance: _Distance) -> str:
        config = self._config
        if distance.is_beyond:
            return "too far to be believed"
        if distance.agreed < config.agreeing_windows:
            return "not yet confirmed by other windows"
        return ""
