"""Lens distortion on the normalised image plane, and its inverse.

Every model maps undistorted to distorted normalised coordinates. Forward functions also return the (N, 2, 2)
Jacobian, from which ``invert`` builds Newton steps. Coefficients are in OpenCV order; the Kannala-Brandt model
works on rays and so lives on angles rather than on the plane.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array

_NEWTON_STEPS = 50
_CONVERGED = 1e-14


def distort_brown_conrady(plane: Array, coefficients: Array) -> tuple[Array, Array]:
    """Distort (N, 2) normalised points with k1 k2 p1 p2 k3.

    Returns:
        The (N, 2) distorted points and the (N, 2, 2) Jacobian of distorted by undistorted.

    Reference:
        Brown 1966; OpenCV ``calib3d``, "plumb bob".
    """
    k1, k2, p1, p2, k3 = coefficients
    x, y = plane[:, 0], plane[:, 1]
    r2 = x * x + y * y
    radial = 1 + r2 * (k1 + r2 * (k2 + r2 * k3))
    slope = k1 + r2 * (2 * k2 + 3 * r2 * k3)  # d radial / d r2
    out = np.stack(
        [
            x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
            y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y,
        ],
        -1,
    )
    cross = 2 * x * y * slope + 2 * p1 * x + 2 * p2 * y
    jacobian = np.empty((len(plane), 2, 2))
    jacobian[:, 0, 0] = radial + 2 * x * x * slope + 2 * p1 * y + 6 * p2 * x
    jacobian[:, 1, 1] = radial + 2 * y * y * slope + 6 * p1 * y + 2 * p2 * x
    jacobian[:, 0, 1] = jacobian[:, 1, 0] = cross
    return out, jacobian


def undistort_brown_conrady(distorted: Array, coefficients: Array) -> Array:
    """Invert ``distort_brown_conrady`` by damped Newton steps from the distorted point."""
    plane = distorted.copy()
    value, jacobian = distort_brown_conrady(plane, coefficients)
    error = np.linalg.norm(value - distorted, axis=1)
    for _ in range(_NEWTON_STEPS):
        determinant = np.linalg.det(jacobian)
        solvable = np.abs(determinant) > 1e-9
        step = np.zeros_like(plane)
        step[solvable] = np.linalg.solve(jacobian[solvable], (distorted - value)[solvable, :, None])[..., 0]
        length = np.ones(len(plane))
        for _ in range(8):  # halve a step that makes the error grow: far corners start beyond the basin
            trial = plane + length[:, None] * step
            trial_value, trial_jacobian = distort_brown_conrady(trial, coefficients)
            trial_error = np.linalg.norm(trial_value - distorted, axis=1)
            worse = trial_error > error
            if not worse.any():
                break
            length[worse] *= 0.5
        keep = trial_error <= error
        plane[keep], value[keep], jacobian[keep] = trial[keep], trial_value[keep], trial_jacobian[keep]
        improvement = float(np.max(np.abs(step[keep]), initial=0.0))
        error = np.where(keep, trial_error, error)
        if improvement < _CONVERGED:
            break
    return plane


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
    """Invert ``distorted_angle`` by Newton steps, kept inside 0 to pi."""
    theta = np.clip(theta_d, 0.0, np.pi)
    for _ in range(_NEWTON_STEPS):
        value, slope = distorted_angle(theta, coefficients)
        step = (theta_d - value) / np.where(np.abs(slope) < 1e-6, 1e-6, slope)
        theta = np.clip(theta + np.clip(step, -0.3, 0.3), 0.0, np.pi)
        if float(np.max(np.abs(step), initial=0.0)) < _CONVERGED:
            break
    return theta
