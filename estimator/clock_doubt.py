"""What clocks could do to the stated poses, as far as the drive has not shown the clocks.

Poses are stated with clocks held as right. Along a straight at constant speed a late clock and a camera that
sits further along the way are the same thing, for all cameras at once; only a turn or another speed tells
the two apart. Until then a pose along the way is no better known than the clock.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from pydantic import Field

from estimator.belief import Belief
from estimator.config import Config
from estimator.evidence import Evidence, Free, Posterior, UsualErrors
from estimator.ranges import ClockSigmaS
from estimator.rig import Rig, RigPrior
from estimator.se3 import Array
from estimator.unknowns import Unknowns

_ANYWHERE = RigPrior(1e4, 1e6)  # deg, mm: no rig file at all
_UNLIMITED = 1e6  # rad^2, m^2


class ClockDoubtConfig(Config):
    """What is thought of clocks before a drive.

    ``off_share`` of them are off by what is usual, the others are in step. ``broad_s`` is the prior under
    which it is asked what the drive by itself shows of them.
    """

    off_share: float = Field(0.5, gt=0, lt=1)
    broad_s: ClockSigmaS = 0.05


@dataclass(frozen=True, eq=False)
class ClockDoubt:
    """What clocks leave open of the extrinsics.

    Attributes:
        covariance: (6 C, 6 C) by which the stated one grows: of a usual error, as likely as it still is.
        hidden: (6 C, 6 C) of what the drive by itself leaves open, were clocks off by anything.
    """

    covariance: Array
    hidden: Array

    @staticmethod
    def none(nominal: Rig) -> ClockDoubt:
        """Return that of clocks which are known to be in step."""
        nothing = np.zeros((6 * len(nominal.estimated_names),) * 2)
        return ClockDoubt(nothing, nothing)

    def hidden_of(self, name: str, nominal: Rig) -> Array:
        """Return the (6, 6) part of ``hidden`` that concerns one camera; zero for the reference."""
        return Belief(nominal, self.hidden).camera_covariance(name)


def clock_doubt(
    evidence: Evidence, usual: UsualErrors, config: ClockDoubtConfig, corrected: frozenset[str]
) -> ClockDoubt:
    """Return what clocks leave open after the windows seen so far.

    Args:
        evidence: Of all windows.
        usual: How far lenses and clocks may be off.
        config: What is thought of clocks before a drive.
        corrected: Cameras whose pose is stated with the clock as found: its covariance knows of the clock.
    """
    nominal = evidence.nominal
    if not evidence.window_count:
        unknown = _UNLIMITED * np.eye(Unknowns(nominal).pose_size)
        return ClockDoubt(np.zeros_like(unknown), unknown)
    off, spread = late_clocks(evidence, usual)
    chance = _chance_of_being_off(off, spread, usual, config)
    chance[[name in corrected for name in nominal.cameras]] = 0.0
    response = shift_by_clock(evidence, usual) * np.sqrt(chance)
    by_itself = replace(evidence, nominal=replace(nominal, prior=_ANYWHERE))
    broad = usual.model_copy(update={"clock_s": config.broad_s})
    alone = shift_by_clock(by_itself, broad)
    return ClockDoubt(
        response @ (spread + np.outer(off, off)) @ response.T,
        alone @ late_clocks(by_itself, broad)[1] @ alone.T,
    )


def late_clocks(evidence: Evidence, usual: UsualErrors) -> tuple[Array, Array]:
    """Return the (N,) seconds that clocks are ahead and their (N, N) covariance, were all of them in doubt.

    Lenses are in doubt too, as clocks would otherwise have to explain them.
    """
    unknowns = Unknowns(evidence.nominal)
    clocks = _clocks(unknowns)
    posterior = _wary_posterior(evidence, usual)
    return posterior.mean[clocks], posterior.covariance[np.ix_(clocks, clocks)]


def shift_by_clock(evidence: Evidence, usual: UsualErrors) -> Array:
    """Return (6 C, N) how poses answer to clocks that are a second further ahead, with lenses as stated.

    Along a straight at constant speed that is the car's velocity, seen in each camera.
    """
    unknowns = Unknowns(evidence.nominal)
    size, everyone = unknowns.pose_size, frozenset(unknowns.names)
    information = evidence.information(usual, Free(frozenset(), everyone))
    to_clocks = information[:size, _clocks(unknowns)]
    return np.asarray(-np.linalg.solve(information[:size, :size], to_clocks), float)


def _wary_posterior(evidence: Evidence, usual: UsualErrors) -> Posterior:
    """Return the posterior with landmarks that scatter by as much more as windows disagree."""
    disagreement = max(1.0, evidence.posterior(usual).disagreement)
    return replace(evidence, scatter=disagreement * evidence.scatter).posterior(usual)


def _chance_of_being_off(off: Array, spread: Array, usual: UsualErrors, config: ClockDoubtConfig) -> Array:
    """Return (N,) how likely each clock is off by a usual error rather than in step.

    By how much likelier the evidence makes zero than it was before (Savage and Dickey).
    """
    variance = np.maximum(np.diag(spread), 1e-20)
    surprise = np.minimum(0.5 * off**2 / variance, 100.0)
    odds = np.sqrt(variance) / usual.clock_s * np.exp(surprise)
    odds *= config.off_share / (1 - config.off_share)
    return np.asarray(odds / (1 + odds))


def _clocks(unknowns: Unknowns) -> list[int]:
    return [unknowns.clock(camera) for camera in range(len(unknowns.names))]
