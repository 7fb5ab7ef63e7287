"""Kannala-Brandt distortion of the angle between a ray and the optical axis, and its inverse."""

from __future__ import annotations

import numpy as np

from estimator.fold import first_turn
from estimator.se3 import Array

_NEWTON_STEPS = 40
_CONVERGED = 1e-14  # of the angle in rad, times the value where it exceeds 1: 1e-11 px at f = 1000
_ACCEPTED = 1e-13
_TABLE_SIZE = 512


def distorted_angle(theta: Array, coefficients: Array) -> tuple[Array, Array]:
    """Return theta_d and d theta_d / d theta of the Kannala-Brandt polynomial k1 k2 k3 k4.

    Reference:
        Kannala & Brandt 2006, eq. 6.
    """
    k1, k2, k3, k4 = coefficients
    t2 = theta * theta
    value = theta * (1 + t2 * (k1 + t2 * (k2 + t2 * (k3 + t2 * k4))))
    slope = 1 + t2 * (3 * k1 + t2 * (5 * k2 + t2 * (7 * k3 + t2 * 9 * k4)))
    return value, slope


def undistorted_angle(theta_d: Array, coefficients: Array) -> Array:
    """Invert ``distorted_angle`` for (N,) angles; NaN where no angle up to the fold or pi answers."""
    table = np.linspace(0.0, fold_angle(coefficients), _TABLE_SIZE)
    table_d = distorted_angle(table, coefficients)[0]
    theta = np.interp(theta_d, table_d, table, right=np.nan)
    for _ in range(_NEWTON_STEPS):
        value, slope = distorted_angle(theta, coefficients)
        error = theta_d - value
        if not np.any(np.abs(error) > _CONVERGED * np.maximum(1.0, theta_d)):  # NaN is not greater
            break
        theta = np.clip(theta + error / np.maximum(slope, 1e-9), 0.0, table[-1])
    good = np.abs(theta_d - distorted_angle(theta, coefficients)[0]) <= _ACCEPTED * np.maximum(1.0, theta_d)
    return np.where(good, theta, np.nan)


def fold_angle(coefficients: Array) -> float:
    """Return the angle in rad at which k1 k2 k3 k4 turns back, at most pi."""
    k1, k2, k3, k4 = (float(each) for each in coefficients)
    return min(first_turn((9 * k4, 7 * k3, 5 * k2, 3 * k1, 1.0)), float(np.pi))
