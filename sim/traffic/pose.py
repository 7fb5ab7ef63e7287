"""Poses of the parts of many actors at once, and how they become poses in the world.

A part's pose relative to its actor is a row (x, y, z, pitch, yaw): shifted, turned by ``yaw`` about the
actor's +z, then by ``pitch`` about its own +y (positive tips forward and down). The actor's frame has x
ahead, y left, z up and its origin on the ground.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

X, Y, Z, PITCH, YAW = range(5)


@dataclass(frozen=True, eq=False)
class Stance:
    """Where N actors are at one instant.

    Attributes:
        origins_m: (N, 3) world positions on the ground.
        yaws_rad: (N,) heading.
        pitches_rad: (N,) slope they stand on, positive downhill ahead.
    """

    origins_m: Array
    yaws_rad: Array
    pitches_rad: Array


def in_world(stance: Stance, parts: Array) -> tuple[Array, Array]:
    """Return (N, K, 3) positions and (N, K, 4) quaternions, w first as in MuJoCo, of (N, K, 5) parts."""
    frame = _product(_about_z(stance.yaws_rad), _about_y(stance.pitches_rad))[:, None]
    own = _product(_about_z(parts[..., YAW]), _about_y(parts[..., PITCH]))
    return stance.origins_m[:, None] + _rotated(frame, parts[..., :3]), _product(frame, own)


def _about_z(angle_rad: Array) -> Array:
    zero = np.zeros_like(angle_rad)
    return np.stack([np.cos(angle_rad / 2), zero, zero, np.sin(angle_rad / 2)], axis=-1)


def _about_y(angle_rad: Array) -> Array:
    zero = np.zeros_like(angle_rad)
    return np.stack([np.cos(angle_rad / 2), zero, np.sin(angle_rad / 2), zero], axis=-1)


def _product(one: Array, other: Array) -> Array:
    """Hamilton product, w first."""
    w, v = one[..., :1], one[..., 1:]
    w2, v2 = other[..., :1], other[..., 1:]
    scalar = w * w2 - (v * v2).sum(axis=-1, keepdims=True)
    return np.concatenate([scalar, w * v2 + w2 * v + np.cross(v, v2)], axis=-1)


def _rotated(quaternion: Array, vector: Array) -> Array:
    w, v = quaternion[..., :1], quaternion[..., 1:]
    twice = 2.0 * np.cross(v, vector)
    result: Array = vector + w * twice + np.cross(v, twice)
    return result
