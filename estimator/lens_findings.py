"""Accuse a lens or a clock, where the whole drive's evidence is clear and it matters."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from estimator.config import Config
from estimator.evidence import Posterior
from estimator.finding import Finding, FindingKind
from estimator.ranges import Factor, PositiveShare, SizePx, TimeS
from estimator.rig import Rig
from estimator.se3 import Array
from estimator.unknowns import Unknowns


class AccusationConfig(Config):
    """What is worth telling, and how sure it must be.

    A principal point off by a pixel turns the camera by a tenth of a degree or more; a clock off by 3 ms
    moves it by 15 mm at 5 m/s.
    """

    focal_share: PositiveShare = 0.003
    center_px: SizePx = 1.0
    clock_s: TimeS = 0.003
    sigmas: Factor = 6.0


def accusations(posterior: Posterior, nominal: Rig, config: AccusationConfig) -> tuple[Finding, ...]:
    """Return a finding for every lens and every clock that is clearly wrong.

    Sure means: so many sigmas off in the posterior of all lenses, clocks and poses together, the sigma
    widened by what the windows disagree.
    """
    unknowns = Unknowns(nominal)
    covariance = posterior.covariance * max(1.0, posterior.disagreement)
    findings = list(_lenses(posterior.mean, covariance, unknowns, config))
    findings += _clocks(posterior.mean, covariance, unknowns, config)
    return tuple(findings)


def _lenses(
    mean: Array, covariance: Array, unknowns: Unknowns, config: AccusationConfig
) -> Iterator[Finding]:
    for camera, name in enumerate(unknowns.names):
        block = unknowns.lens(camera)
        focal, *center = mean[block]
        sigma = np.sqrt(np.diag(covariance)[block])
        off = np.linalg.norm(center)
        center_sigma = np.sqrt(center @ covariance[block, block][1:, 1:] @ center) / max(off, 1e-12)
        longer = abs(focal) > max(config.focal_share, config.sigmas * sigma[0])
        shifted = off > max(config.center_px, config.sigmas * center_sigma)
        if longer or shifted:
            side = "longer" if focal > 0 else "shorter"
            about = (
                f"{name}: focal length {100 * abs(focal):.2f} +- {100 * sigma[0]:.2f} % {side} than the rig "
                f"file says, principal point off by ({center[0]:.1f}, {center[1]:.1f}) "
                f"+- {max(sigma[1:]):.1f} px"
            )
            yield Finding(FindingKind.WRONG_INTRINSICS, (name,), about)


def _clocks(
    mean: Array, covariance: Array, unknowns: Unknowns, config: AccusationConfig
) -> Iterator[Finding]:
    for camera, name in enumerate(unknowns.names):
        row = unknowns.clock(camera)
        ahead_s, sigma_s = mean[row], np.sqrt(covariance[row, row])
        if abs(ahead_s) > max(config.clock_s, config.sigmas * sigma_s):
            side = "ahead of" if ahead_s > 0 else "behind"
            about = (
                f"{name}: stamps {1e3 * abs(ahead_s):.1f} +- {1e3 * sigma_s:.1f} ms {side} "
                f"those of {unknowns.rig.reference}"
            )
            yield Finding(FindingKind.CLOCK_OFFSET, (name,), about)
