"""Tell where a camera seems far off along the way, and a late clock would explain it as well."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from estimator.belief import Belief
from estimator.clock_doubt import ClockDoubt, shift_by_clock
from estimator.config import Config
from estimator.evidence import Evidence, Free, UsualErrors
from estimator.finding import Finding, FindingKind
from estimator.ranges import ClockSigmaS, Factor
from estimator.se3 import Array
from estimator.unknowns import Unknowns


class ClockOrShiftConfig(Config):
    """What is worth telling: so many sigmas of the rig file's prior, and a clock that is so far off.

    At three sigmas of a prior of 100 mm a clock that is off by a usual error is twenty times as likely.
    """

    sigmas: Factor = 3.0
    clock_s: ClockSigmaS = 0.003


def late_or_shifted(
    evidence: Evidence, doubt: ClockDoubt, broad_s: float, usual: UsualErrors, config: ClockOrShiftConfig
) -> tuple[Finding, ...]:
    """Return a finding for every camera that is far along the way from where the rig file has it.

    Args:
        evidence: Of all windows.
        doubt: What clocks leave open; once that is less than would explain the shift, nothing is told.
        broad_s: The prior on clocks that ``doubt.hidden`` still holds.
        usual: How far lenses and clocks may be off.
        config: Thresholds.
    """
    if not evidence.window_count or not doubt.hidden.any():
        return ()
    return tuple(_found(evidence, doubt, broad_s, usual, config))


def _found(
    evidence: Evidence, doubt: ClockDoubt, broad_s: float, usual: UsualErrors, config: ClockOrShiftConfig
) -> Iterator[Finding]:
    nominal, unknowns = evidence.nominal, Unknowns(evidence.nominal)
    prior, response = Belief.nominal(nominal), shift_by_clock(evidence, usual)
    in_time = evidence.posterior(usual, Free(frozenset(unknowns.names), frozenset())).mean
    for name in unknowns.estimated:
        camera = unknowns.names.index(name)
        block = unknowns.extrinsics(camera)
        velocity = response[block, camera][3:]
        speed_mps = max(float(np.linalg.norm(velocity)), 1e-6)
        way = velocity / speed_mps
        shift_m = float(in_time[block][3:] @ way)
        prior_m = np.sqrt(_variance(way, prior.camera_covariance(name)))
        shown = 1 / _variance(way, doubt.hidden_of(name, nominal)) - 1 / (broad_s * speed_mps) ** 2
        is_open = shift_m**2 * shown < config.sigmas**2
        ahead_s, sigmas = -shift_m / speed_mps, abs(shift_m) / prior_m
        if is_open and sigmas > config.sigmas and abs(ahead_s) > config.clock_s:
            further, side = ("back", "ahead of") if ahead_s > 0 else ("on", "behind")
            about = (
                f"{name}: sits {1e3 * abs(shift_m):.0f} mm further {further} along the way than the rig file "
                f"says, {sigmas:.1f} sigmas of its prior; stamps {1e3 * abs(ahead_s):.0f} ms {side} those of "
                f"{nominal.reference} would look the same, until the car turns or changes speed"
            )
            yield Finding(FindingKind.CLOCK_OFFSET, (name,), about)


def _variance(way: Array, covariance: Array) -> float:
    """Return the variance of a (6, 6) covariance along a (3,) direction of its translation."""
    return max(float(way @ covariance[3:, 3:] @ way), 1e-20)
