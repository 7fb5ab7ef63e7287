"""How a walker's limbs move, as a function of the way walked: feet stay where they touch the ground.

Angles follow those of normal gait in outline: two flexions of the knee in a cycle, a small one under load
and a large one in swing, and a heel that rises before the toe leaves the ground.

Reference:
    Perry & Burnfield 2010, Gait Analysis, ch. 4-6.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.person import ANKLE_M, FOREARM_M, HIP_M, SHIN_M, SHOULDER_M, THIGH_M, UPPER_ARM_M
from sim.traffic.pose import PITCH, YAW, X, Y, Z

LIMBS = ("thigh", "shin", "foot", "upper_arm", "forearm")
PARTS = ("trunk", *(f"{side}_{limb}" for side in ("left", "right") for limb in LIMBS))
_STRIDE_M = 1.38  # two steps, of somebody 1.75 m tall
_SETTLES_MPS = 0.5  # below this speed the swing dies away
_SOLE_M = np.array([[-0.08, -ANKLE_M], [0.14, -ANKLE_M], [0.185, -ANKLE_M + 0.014]])  # x, z from the ankle


def walking(travelled_m: Array, speed_mps: Array, scale: Array, start_turns: Array) -> Array:
    """Return where the limbs of N walkers are, each relative to the ground under its walker.

    Args:
        travelled_m: (N,) way walked so far.
        speed_mps: (N,).
        scale: (N,) height over 1.75 m.
        start_turns: (N,) share of the cycle at which each began.

    Returns:
        (N, 11, 5) part poses in the order of ``PARTS``.
    """
    swing = np.clip(speed_mps / _SETTLES_MPS, 0.0, 1.0)
    swing = swing * swing * (3.0 - 2.0 * swing)
    turns = travelled_m / (_STRIDE_M * scale) + start_turns
    poses = np.zeros((len(turns), len(PARTS), 5))
    legs = [_leg(turns + offset, swing) for offset in (0.0, 0.5)]
    hip_m = np.maximum(*(leg[-1] for leg in legs))
    rock = swing * np.sin(2 * np.pi * turns)
    poses[:, 0, Z], poses[:, 0, Y] = hip_m, -0.018 * rock
    poses[:, 0, PITCH], poses[:, 0, YAW] = 0.045 * swing, 0.07 * swing * np.cos(2 * np.pi * turns)
    for k, side in enumerate((1.0, -1.0)):
        _place_leg(poses, 1 + 5 * k, side, legs[k][:-1])
        _place_arm(poses, 4 + 5 * k, side, turns + 0.5 * k, swing)
    poses[..., :3] *= np.asarray(scale)[:, None, None]
    return poses


def _leg(turns: Array, swing: Array) -> tuple[Array, Array, Array, Array]:
    """Pitch of thigh, shin and foot, and how high above the ground the hip is when this leg stands on it."""
    flexion = swing * (0.10 + 0.40 * np.cos(2 * np.pi * turns))
    knee = 0.06 + swing * (0.20 * _bump(turns, 0.15, 9.0) + 0.98 * _bump(turns, 0.73, 5.5))
    foot = swing * (0.80 * _bump(turns, 0.62, 16.0) - 0.34 * _bump(turns, 0.985, 14.0))
    thigh = -flexion - 0.03
    shin = thigh + knee
    drop = THIGH_M * np.cos(thigh) + SHIN_M * np.cos(shin)
    sole = [x * np.sin(foot) - z * np.cos(foot) for x, z in _SOLE_M]
    return thigh, shin, foot, drop + np.max(sole, axis=0)


def _place_leg(poses: Array, first: int, side: float, pitches: tuple[Array, ...]) -> None:
    x, z = np.full(len(poses), HIP_M[0]), poses[:, 0, Z]
    for k, (pitch, length_m) in enumerate(zip(pitches, (THIGH_M, SHIN_M, 0.0), strict=True)):
        poses[:, first + k, X], poses[:, first + k, Z] = x, z
        poses[:, first + k, Y] = poses[:, 0, Y] + side * HIP_M[1]
        poses[:, first + k, PITCH] = pitch
        x, z = x - length_m * np.sin(pitch), z - length_m * np.cos(pitch)


def _place_arm(poses: Array, first: int, side: float, turns: Array, swing: Array) -> None:
    lean, twist = poses[:, 0, PITCH], poses[:, 0, YAW]
    upper = 0.06 + swing * 0.42 * np.cos(2 * np.pi * turns)
    fore = upper - 0.16 - swing * (0.22 - 0.14 * np.cos(2 * np.pi * turns))
    x, z = SHOULDER_M[0] - side * SHOULDER_M[1] * twist + SHOULDER_M[2] * lean, poses[:, 0, Z] + SHOULDER_M[2]
    for k, (pitch, length_m) in enumerate(((upper, UPPER_ARM_M), (fore, FOREARM_M))):
        poses[:, first + k, X], poses[:, first + k, Z] = x, z
        poses[:, first + k, Y] = poses[:, 0, Y] + side * (SHOULDER_M[1] + 0.02 * k)
        poses[:, first + k, PITCH] = pitch
        x, z = x - length_m * np.sin(pitch), z - length_m * np.cos(pitch)


def _bump(turns: Array, at: float, sharpness: float) -> Array:
    """A smooth periodic bump of height 1."""
    result: Array = np.exp(sharpness * (np.cos(2 * np.pi * (turns - at)) - 1.0))
    return result
