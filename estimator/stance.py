"""How a car stands on the road: near where the rig file says, less so while it brakes or turns.

On its springs the body dives, leans and rises by an amount that grows with the acceleration. So a calm
stretch says more of the height of the cameras, and with it of metric scale, than a bend does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from estimator.config import Config
from estimator.ranges import MPerMps2, RadPerMps2, SigmaM, SigmaRad
from estimator.se3 import SE3, Array

_ALIGNED_RAD, _ALIGNED_M = 1e-4, 1e-3  # the road's frame is under the car's own, and heads the same way
_REACH = 2  # steps before and after a keyframe that its acceleration is taken from
_STOP = 4.0  # times the usual duration: a step in which the car stood, whose mean speed says nothing


class StanceConfig(Config):
    """How far the body is from its stated stance: one sigma of height and of tilt.

    ``tilt_rad_per_mps2`` is what a metre per second squared adds, whatever its direction: cars lean 4 to 6
    degrees at 1 g, dive by half as much, and in a turn they do both.
    """

    height_sigma_m: SigmaM = 0.01
    height_m_per_mps2: MPerMps2 = 0.003
    tilt_sigma_rad: SigmaRad = 0.01
    tilt_rad_per_mps2: RadPerMps2 = 0.008

    def covariance(self, acceleration_mps2: float, middle_m: float) -> Array:
        """Return the (6, 6) covariance of the road's pose in the ego frame.

        Braking dives the body about the middle of the wheelbase, which keeps its height. What tilts a calm
        car (load, a road that bends between its axles) has no such pivot.

        Args:
            acceleration_mps2: How hard the car accelerates, brakes or turns.
            middle_m: How far the middle of the wheelbase is ahead of the ego frame's origin.
        """
        calm = [self.tilt_sigma_rad] * 2 + [_ALIGNED_RAD, _ALIGNED_M, _ALIGNED_M, self.height_sigma_m]
        sprung = np.array([self.tilt_rad_per_mps2] * 2 + [0, 0, 0, self.height_m_per_mps2])
        at_origin = np.eye(6)
        at_origin[5, 1] = middle_m  # nose down, the road rises ahead: under the origin it lies lower
        moved = at_origin @ np.diag((acceleration_mps2 * sprung) ** 2) @ at_origin.T
        return np.asarray(np.diag(np.square(calm)) + moved)


def acceleration_mps2(world_from_egos: Sequence[SE3], stamps_ns: Sequence[int]) -> Array:
    """Return (K,) how hard the car accelerates, brakes or turns at each pose; zeros without stamps.

    The velocity's slope over the steps around a pose, so that the noise of one step counts for little.
    """
    result = np.zeros(len(world_from_egos))
    duration_s = np.diff(np.asarray(stamps_ns, float)) * 1e-9
    if len(duration_s) < 2 or not np.all(duration_s > 0):
        return result
    places_m = np.array([pose.translation[:2] for pose in world_from_egos])
    velocity_mps = np.diff(places_m, axis=0) / duration_s[:, None]
    middle_s = np.cumsum(duration_s) - 0.5 * duration_s
    for first, beyond in _stretches(duration_s):
        for index in range(first, beyond + 1):
            around = slice(max(first, index - _REACH), min(beyond, index + _REACH))
            if around.stop - around.start > 1:
                slope = np.polyfit(middle_s[around] - middle_s[around.start], velocity_mps[around], 1)[0]
                result[index] = np.linalg.norm(slope)
    return result


def _stretches(duration_s: Array) -> Iterator[tuple[int, int]]:
    """Yield the first step of each stretch without a stop, and the one beyond its last.

    What the car did before a stop says nothing of how it drives off.
    """
    moving = duration_s <= _STOP * np.median(duration_s)
    edges = np.flatnonzero(np.diff(np.concatenate([[False], moving, [False]]).astype(int)))
    yield from zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True)
