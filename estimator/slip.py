"""How far the way of a car is from its own long axis."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from estimator.keyframe import Keyframe


def slip_rad(keyframes: Sequence[Keyframe]) -> float:
    """Return the angle between the car's long axis and the way it went, forwards or back, over a window.

    A rear axle rolls along the long axis; within a step of a tight turn the way is off by half the turn.
    """
    poses = [keyframe.world_from_ego for keyframe in keyframes]
    steps = np.array([(a.inverse() @ b).translation for a, b in pairwise(poses)])
    length = np.linalg.norm(steps, axis=1)
    along = np.abs(steps[:, 0])[length > 0.1].sum() / max(length[length > 0.1].sum(), 1e-9)
    return float(np.arccos(np.clip(along, 0.0, 1.0))) if (length > 0.1).any() else 0.0
