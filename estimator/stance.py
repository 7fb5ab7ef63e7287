"""How a car stands on the road: near where the rig file says, less so while it brakes or turns.

On its springs the body leans, dives and rises by an amount that grows with the acceleration. So a calm
stretch says more of the height of the cameras, and with it of metric scale, than a bend does.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from estimator.config import Config
from estimator.ranges import Share, SigmaM, SigmaRad
from estimator.se3 import SE3, Array

_REACH = 2  # steps before and after a keyframe that its acceleration is taken from


class StanceConfig(Config):
    """How far the body is from its stated stance: one sigma of height and of tilt.

    ``tilt_rad_per_mps2`` is what a metre per second squared adds; cars lean 4 to 6 degrees at 1 g.
    """

    height_sigma_m: SigmaM = 0.01
    height_m_per_mps2: Share = 0.006
    tilt_sigma_rad: SigmaRad = 0.01
    tilt_rad_per_mps2: Share = 0.008

    def height_m(self, acceleration_mps2: float) -> float:
        """Return the sigma of the height over the road."""
        return float(np.hypot(self.height_sigma_m, self.height_m_per_mps2 * acceleration_mps2))

    def tilt_rad(self, acceleration_mps2: float) -> float:
        """Return the sigma of pitch and of roll against the road."""
        return float(np.hypot(self.tilt_sigma_rad, self.tilt_rad_per_mps2 * acceleration_mps2))


def acceleration_mps2(world_from_egos: Sequence[SE3], stamps_ns: Sequence[int]) -> Array:
    """Return (K,) how hard the car accelerates, brakes or turns at each pose; zeros without stamps.

    The velocity's slope over the steps around a pose, so that the noise of one step counts for little.
    """
    result = np.zeros(len(world_from_egos))
    times_s = np.asarray(stamps_ns, float) * 1e-9
    if len(times_s) < 3 or not np.all(np.diff(times_s) > 0):
        return result
    places_m = np.array([pose.translation[:2] for pose in world_from_egos])
    velocity_mps = np.diff(places_m, axis=0) / np.diff(times_s)[:, None]
    middle_s = np.array([0.5 * (before + after) for before, after in pairwise(times_s)])
    for index in range(len(result)):
        around = slice(max(0, index - _REACH), index + _REACH)
        if len(middle_s[around]) > 1:
            slope = np.polyfit(middle_s[around] - middle_s[around][0], velocity_mps[around], 1)[0]
            result[index] = np.linalg.norm(slope)
    return result
