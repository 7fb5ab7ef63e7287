"""Watch whether each camera's images come from where the rig file says: swapped cables, nonsense poses."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from estimator import mount_findings as say
from estimator.assignment import AssignmentConfig, swap_explains, swapped_cycles
from estimator.config import Config
from estimator.epipolar import FitConfig
from estimator.finding import Finding
from estimator.keyframe import Keyframe
from estimator.ranges import AngleRad, KeyframeCount, Share, StepCount
from estimator.rig import Rig
from estimator.slip import slip_rad
from estimator.whose_images import Fit, fit_streams

_NOTHING_TO_SEE = 12  # levels


class MountWatchConfig(Config):
    """How much of its tracks a mount must explain, and over how many windows that is asked."""

    fit: FitConfig = FitConfig()
    assignment: AssignmentConfig = AssignmentConfig()
    windows: StepCount = 3
    suspicious_share: Share = 0.6
    min_share: Share = 0.4
    min_keyframes: KeyframeCount = 4
    max_slip_rad: AngleRad = 0.35
    untracked_windows: StepCount = 2


class MountWatch:
    """Remembers how well streams and mounts fitted over the last few windows."""

    def __init__(self, rig: Rig, config: MountWatchConfig) -> None:
        self._rig = rig
        self._config = config
        self._names = list(rig.cameras)
        self._fits: dict[str, deque[Fit]] = {name: deque(maxlen=config.windows) for name in self._names}
        self._slip_rad = 0.0
        self._untracked = dict.fromkeys(self._names, 0)  # windows in a row with images and without tracks
        self._findings: tuple[Finding, ...] = ()
        height_m = float(rig[rig.reference].ego_from_cam.translation[2])
        if height_m <= 0:
            reason = f"z = {height_m:g} m, but it must look down on the road"
            self._findings = (say.wrong_reference(rig.reference, reason),)

    def see(self, keyframes: Sequence[Keyframe]) -> None:
        """Take note of a window; only where a mount does not explain its own images are others tried."""
        if len(keyframes) < self._config.min_keyframes:
            return
        self._slip_rad = slip_rad(keyframes)
        fit = fit_streams(keyframes, self._rig, self._config.fit, own_only=True)
        self._count_untracked(keyframes, fit)
        odd = self._unexplained(fit, self._config.suspicious_share)
        if odd:
            fit = fit_streams(keyframes, self._rig, self._config.fit)
        self._fits[self._rig.reference].append(fit)
        for name in self._names:
            if name == self._rig.reference:
                continue
            self._fits[name].append(
                fit_streams(keyframes, self._rig, self._config.fit, reference_mount=name)
                if 2 * len(odd) >= len(self._names) - 1
                else Fit(np.zeros_like(fit.count), fit.total)
            )
        self._findings = tuple(self._conclude())

    def findings(self) -> Iterator[Finding]:
        """Yield what the last windows showed."""
        yield from self._findings

    def _unexplained(self, fit: Fit, share: float) -> list[int]:
        enough = fit.total.diagonal() >= self._config.assignment.min_tracks
        return np.flatnonzero(enough & (fit.share.diagonal() < share)).tolist()

    def _count_untracked(self, keyframes: Sequence[Keyframe], fit: Fit) -> None:
        for index, name in enumerate(self._names):
            images = [k.images[name] for k in keyframes if name in k.images]
            shown = 2 * sum(np.ptp(image[::8, ::8]) > _NOTHING_TO_SEE for image in images) > len(keyframes)
            none = fit.total[index, index] < self._config.assignment.min_tracks / 3
            self._untracked[name] = self._untracked[name] + 1 if none and shown else 0

    def _conclude(self) -> Iterator[Finding]:
        fits = {name: sum(some, start=_nothing(len(self._names))) for name, some in self._fits.items()}
        own = fits[self._rig.reference]
        odd = self._unexplained(own, self._config.min_share)
        cycles, fit = self._swaps(fits)
        swapped = {index for cycle in cycles for index in cycle}
        for cycle in cycles:
            yield say.swap(self._names, cycle, fit)
        if self._slip_rad > self._config.max_slip_rad:
            reason = f"the car seems to drive at {np.rad2deg(self._slip_rad):.0f} deg to its own long axis"
            yield say.wrong_reference(self._rig.reference, reason)
        elif not swapped and len(odd) > 1 and 2 * len(odd) >= len(self._names) - 1:
            reason = f"{len(odd)} of the {len(self._names) - 1} others contradict the way the car moves by it"
            yield say.wrong_reference(self._rig.reference, reason)
        for index in odd:
            if index not in swapped and fit.share[index, index] < self._config.min_share:
                yield say.unexplained(self._names, index, own)
        for name, windows in self._untracked.items():
            if windows >= self._config.untracked_windows:
                yield say.untracked(name, windows)

    def _swaps(self, fits: Mapping[str, Fit]) -> tuple[list[tuple[int, ...]], Fit]:
        """Return the swaps, and the fit they show in: first those that concern the reference itself.

        A reference stream from another mount gives a wrong path, along which other swaps only seem.
        """
        own = fits[self._rig.reference]
        reference = self._names.index(self._rig.reference)
        for mount, fit in enumerate(fits.values()):
            if mount != reference and swap_explains(fit, own, (reference, mount), self._config.assignment):
                return [(reference, mount)], fit
        return swapped_cycles(own, self._config.assignment), own


def _nothing(count: int) -> Fit:
    return Fit(np.zeros((count, count)), np.zeros((count, count)))
