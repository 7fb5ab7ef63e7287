"""Tell where a camera seems far off along the way, and a late clock would explain it as well."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from estimator.belief import Belief
from estimator.clock_doubt import ClockDoubt, shift_by_clock
from estimator.config import Config
from estimator.evidence import Evidence, UsualErrors
from estimator.finding import Finding, FindingKind
from estimator.se3 import Array
from estimator.unknowns import Unknowns


class ClockOrShiftConfig(Config):
    """What is worth telling: so many sigmas of the rig file's prior, and a clock that is so far off.

    At three sigmas of a prior of 100 mm a clock that is off by a usual error is twenty times as likely.
    """

    sigmas: float = 3.0
    clock_s: float = 0.003


def late_or_shifted(
    evidence: Evidence, belief: Belief, doubt: ClockDoubt, usual: UsualErrors, config: ClockOrShiftConfig
) -> tuple[Finding, ...]:
    """Return a finding for every camera that is far along the way from where the rig file has it.

    Args:
        evidence: Of all windows.
        belief: What it says of poses with clocks held as right.
        doubt: What clocks leave open; once they leave less than would explain the shift, nothing is told.
        usual: How far lenses and clocks may be off.
        config: Thresholds.
    """
    if not evidence.window_count:
        return ()
    return tuple(_found(evidence, belief, doubt, shift_by_clock(evidence, usual), config))


def _found(
    evidence: Evidence, belief: Belief, doubt: ClockDoubt, response: Array, config: ClockOrShiftConfig
) -> Iterator[Finding]:
    nominal, unknowns = evidence.nominal, Unknowns(evidence.nominal)
    prior = Belief.nominal(nominal)
    for name in unknowns.estimated:
        camera = unknowns.names.index(name)
        velocity = response[unknowns.extrinsics(camera), camera][3:]
        speed_mps = max(float(np.linalg.norm(velocity)), 1e-6)
        way = velocity / speed_mps
        shift_m = float(nominal[name].ego_from_cam.local(belief.rig[name].ego_from_cam)[3:] @ way)
        prior_m = float(np.sqrt(way @ prior.camera_covariance(name)[3:, 3:] @ way))
        open_m = float(np.sqrt(way @ doubt.hidden_of(name, nominal)[3:, 3:] @ way))
        ahead_s, sigmas = -shift_m / speed_mps, abs(shift_m) / prior_m
        is_open = abs(shift_m) < config.sigmas * open_m
        if is_open and sigmas > config.sigmas and abs(ahead_s) > config.clock_s:
            further, side = ("back", "ahead of") if ahead_s > 0 else ("on", "behind")
            about = (
                f"{name}: sits {1e3 * abs(shift_m):.0f} mm further {further} along the way than the rig file "
                f"says, {sigmas:.1f} sigmas of its prior; stamps {1e3 * abs(ahead_s):.0f} ms {side} those of "
                f"{nominal.reference} would look the same, until the car turns or changes speed"
            )
            yield Finding(FindingKind.CLOCK_OFFSET, (name,), about)
