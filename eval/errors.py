"""How far an estimated pose is from the true one, and how far its covariance says it may be."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2

from estimator.se3 import SE3, Array


@dataclass(frozen=True)
class PoseError:
    """The error of an extrinsic pose.

    Attributes:
        rotation_deg: Angle of ``R_est^T R_true``.
        translation_mm: Distance between the camera centres, in the ego frame.
    """

    rotation_deg: float
    translation_mm: float

    @property
    def is_finite(self) -> bool:
        return bool(np.isfinite([self.rotation_deg, self.translation_mm]).all())


def pose_error(estimated: SE3, true: SE3) -> PoseError:
    """Compare two ``ego_from_cam``; an estimate that is not finite has an infinite error."""
    if not np.isfinite(estimated.matrix).all():
        return PoseError(float("inf"), float("inf"))
    turn = SE3(estimated.rotation.T @ true.rotation)
    distance_m = float(np.linalg.norm(estimated.translation - true.translation))
    return PoseError(float(np.degrees(turn.angle_rad)), 1000 * distance_m)


def tangent_error(estimated: SE3, true: SE3) -> Array:
    """Return the (6,) error ``log(inv(estimated) @ true)``, in the tangent of the stated covariance.

    NaN where the estimate is not finite.
    """
    if not np.isfinite(estimated.matrix).all():
        return np.full(6, np.nan)
    return estimated.local(true)


def squared_mahalanobis(error: Array, covariance: Array) -> float | None:
    """Return ``e^T inv(Sigma) e``; None where the covariance is not positive definite."""
    if not (np.isfinite(covariance).all() and np.isfinite(error).all()):
        return None
    try:
        whitened = np.linalg.solve(np.linalg.cholesky(covariance), error)
    except np.linalg.LinAlgError:
        return None
    return float(whitened @ whitened)


def stated_norm95(covariance: Array) -> float:
    """Return the radius that the norm of a Gaussian 3-vector stays below with probability 0.95.

    Matches the first two moments of the squared norm by a scaled chi-square, which is exact for an
    isotropic covariance and within a few percent otherwise.

    Args:
        covariance: (3, 3) of the vector.

    Returns:
        The radius in the vector's unit; NaN where the covariance is not one.

    Reference:
        Satterthwaite 1946.
    """
    trace = float(np.trace(covariance))
    trace_of_square = float(np.sum(covariance * covariance.T))
    if not np.isfinite(trace_of_square) or trace < 0:
        return float("nan")
    if trace == 0:
        return 0.0
    freedom = trace**2 / trace_of_square
    return float(np.sqrt(trace_of_square / trace * chi2.ppf(0.95, freedom)))


def stated_error95(covariance: Array) -> PoseError:
    """Return the rotation and translation error that a (6, 6) covariance allows with probability 0.95."""
    return PoseError(
        float(np.degrees(stated_norm95(covariance[:3, :3]))),
        1000 * stated_norm95(covariance[3:, 3:]),
    )
