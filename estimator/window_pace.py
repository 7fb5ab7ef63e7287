"""When to keep a bundle as a keyframe, and how many make a window."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.config import Config
from estimator.keyframe import Keyframe
from estimator.odometry import Odometry
from estimator.ranges import AngleRad, KeyframeCount, LengthM


class PaceConfig(Config):
    """Keyframes every metre; ten to a window, fewer to the first, so that there is an answer soon."""

    spacing_m: LengthM = 1.0
    turn_rad: AngleRad = 0.2
    keyframes: KeyframeCount = 10
    first_keyframes: KeyframeCount = 9
    min_keyframes: KeyframeCount = 5


def is_keyframe(keyframes: Sequence[Keyframe], odometry: Odometry, config: PaceConfig) -> bool:
    """Tell whether the car has come far enough since the last keyframe.

    The bundle nearest to the spacing is taken: half a step short is as good as half a step beyond.
    """
    if not keyframes:
        return True
    since = keyframes[-1].world_from_ego.inverse() @ odometry.world_from_ego
    moved_m = float(np.linalg.norm(since.translation))
    half_step_m = 0.5 * odometry.step_m
    return moved_m + half_step_m >= config.spacing_m or since.angle_rad > config.turn_rad
