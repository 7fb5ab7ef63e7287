"""Where the metres come from: how sure the scale is, and what share each source has in it.

Images leave scale open. Three sources close it, each by its information (one over the variance) on the
logarithm of scale: the road under the reference camera's stated height, the rear axle in turns, and the
nominal rig. Their information adds up over the windows of a drive.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

ROAD, REAR_AXLE, NOMINAL_RIG = "road", "rear axle", "nominal rig"
BELIEF = "belief"  # within a window: all that was known before it
SOURCES = (ROAD, REAR_AXLE, NOMINAL_RIG)
ScaleInformation = Mapping[str, float]


@dataclass(frozen=True, eq=False)
class ScaleEvidence:
    """What is known of metric scale.

    Attributes:
        sigma_percent: Standard deviation of the scale, all in all.
        common_sigma_percent: The part of it that more driving does not lessen: the reference camera's stated
            height may be off, by load or tyres.
        share: By source, its share in the information; they sum to one.
    """

    sigma_percent: float
    common_sigma_percent: float
    share: Mapping[str, float]


def after_window(before: ScaleInformation, window: ScaleInformation) -> ScaleInformation:
    """Return the information by source after a window.

    Args:
        before: By source, before it; empty if only the nominal rig was known.
        window: What the window found in each source, ``BELIEF`` among them, which is passed on to the sources
            that the belief came from.
    """
    total = sum(before.values())
    origin = {source: value / total for source, value in before.items()} if total > 0 else {NOMINAL_RIG: 1.0}
    inherited = window.get(BELIEF, 0.0)
    return {source: window.get(source, 0.0) + inherited * origin.get(source, 0.0) for source in SOURCES}


def scale_evidence(information: ScaleInformation, common_sigma: float) -> ScaleEvidence | None:
    """Return the evidence; None without any information.

    Args:
        information: By source, of the logarithm of scale.
        common_sigma: Relative standard deviation that all windows share.
    """
    total = sum(information.values())
    if total <= 0:
        return None
    share = {source: information.get(source, 0.0) / total for source in SOURCES}
    return ScaleEvidence(100 * float(np.hypot(total**-0.5, common_sigma)), 100 * common_sigma, share)
