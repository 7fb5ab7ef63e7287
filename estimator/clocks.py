"""Cameras whose clock is ahead show the car where it was a moment before their stamp."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from estimator.se3 import SE3, Array


@dataclass(frozen=True)
class Clocks:
    """When a window's images were stamped, and by how much each camera's clock is ahead.

    Attributes:
        stamps_ns: Of each keyframe.
        ahead_s: Of each camera, in the rig's order; negative where it is behind.
    """

    stamps_ns: tuple[int, ...]
    ahead_s: tuple[float, ...]

    def stances(self, world_from_egos: Sequence[SE3]) -> tuple[Array, Array]:
        """Return (K, C, 3, 3) rotations and (K, C, 3) translations of the car as each camera shows it."""
        twists = body_twists(world_from_egos, self.stamps_ns)
        shown = [
            [pose.retract(-ahead_s * twist) if ahead_s else pose for ahead_s in self.ahead_s]
            for pose, twist in zip(world_from_egos, twists, strict=True)
        ]
        rotations = np.stack([[pose.rotation for pose in row] for row in shown])
        return rotations, np.stack([[pose.translation for pose in row] for row in shown])


def body_twists(world_from_egos: Sequence[SE3], stamps_ns: Sequence[int]) -> Array:
    """Return (K, 6) velocities (rad/s, m/s) in the car's own axes: x(t + dt) = x(t) @ exp(twist dt).

    Between keyframes the velocity is the mean one; at a keyframe it is interpolated between the two beside
    it, and extrapolated at the ends. Fewer than three keyframes give one velocity.
    """
    seconds = np.asarray(stamps_ns, float) * 1e-9
    gaps = np.diff(seconds)
    steps = np.array([before.local(after) for before, after in pairwise(world_from_egos)])
    rates = steps.reshape(-1, 6) / gaps[:, None]
    if len(rates) < 2:
        return np.tile(rates.sum(0), (len(world_from_egos), 1))
    middles = 0.5 * (seconds[1:] + seconds[:-1])
    slopes = np.diff(rates, axis=0) / np.diff(middles)[:, None]
    inner = rates[:-1] + slopes * (seconds[1:-1] - middles[:-1])[:, None]
    first = rates[0] + slopes[0] * (seconds[0] - middles[0])
    last = rates[-1] + slopes[-1] * (seconds[-1] - middles[-1])
    return np.vstack([first, inner, last])
