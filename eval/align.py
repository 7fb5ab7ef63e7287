"""Bring one path onto another: the estimator's world has its own origin and heading."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import SE3, Array


@dataclass(frozen=True, eq=False)
class Alignment:
    """The best similarity between two point sets.

    Attributes:
        true_from_estimated: The rigid part, for a scale of 1.
        scale: Factor that fits the estimated points to the true ones; None where they do not spread.
    """

    true_from_estimated: SE3
    scale: float | None


def align(estimated_m: Array, true_m: Array) -> Alignment:
    """Align (N, 3) estimated positions to (N, 3) true ones in the least-squares sense.

    Reference:
        Umeyama 1991, eq. 34-43.
    """
    estimated_mean, true_mean = estimated_m.mean(axis=0), true_m.mean(axis=0)
    estimated_centred, true_centred = estimated_m - estimated_mean, true_m - true_mean
    covariance = true_centred.T @ estimated_centred / len(true_m)
    u, singular_values, vt = np.linalg.svd(covariance)
    signs = np.ones(3)
    signs[2] = np.sign(np.linalg.det(u) * np.linalg.det(vt))
    rotation = u @ np.diag(signs) @ vt
    spread = float((estimated_centred**2).sum() / len(estimated_m))
    scale = float(singular_values @ signs) / spread if spread > 1e-12 else None
    return Alignment(SE3(rotation, true_mean - rotation @ estimated_mean), scale)


def align_on_ground(estimated_m: Array, true_m: Array) -> SE3:
    """Return the turn about the vertical and the shift that bring (N, 3) positions onto the true ones.

    For drawing: both worlds are gravity-aligned, and a straight path leaves a full rotation undetermined.
    """
    estimated_mean, true_mean = estimated_m.mean(axis=0), true_m.mean(axis=0)
    a, b = (estimated_m - estimated_mean)[:, :2], (true_m - true_mean)[:, :2]
    yaw_rad = np.arctan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a * b).sum())
    cos, sin = np.cos(yaw_rad), np.sin(yaw_rad)
    rotation = np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return SE3(rotation, true_mean - rotation @ estimated_mean)
