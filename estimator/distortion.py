"""Brown-Conrady distortion on the normalised image plane, and its inverse.

The polynomial turns back at some radius, the fold. Beyond it the model describes no lens, so the inverse
answers NaN there. Coefficients are in OpenCV's order, k1 k2 p1 p2 k3. The fisheye is in ``distortion_angle``.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import numpy.typing as npt

from estimator.fold import first_turn
from estimator.se3 import Array

_NEWTON_STEPS = 40
_CONVERGED = 1e-14  # of the plane's unit, times the value where it exceeds 1: 1e-11 px at f = 1000
_ACCEPTED = 1e-13
_TABLE_SIZE = 2048
_LARGEST_RADIUS = 1e6


def distort_brown_conrady(plane: Array, coefficients: Array) -> tuple[Array, Array]:
    """Distort (N, 2) normalised points with k1 k2 p1 p2 k3, whether or not they lie within the fold.

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


def within_fold_brown_conrady(plane: Array, jacobian: Array, coefficients: Array) -> npt.NDArray[np.bool_]:
    """Tell which (N, 2) undistorted points lie where the model is one to one; NaN does not.

    The determinant alone would not do: it is positive again beyond a second turn of the polynomial.
    """
    determinant = jacobian[:, 0, 0] * jacobian[:, 1, 1] - jacobian[:, 0, 1] ** 2
    within = (plane**2).sum(axis=1) < fold_radius(coefficients) ** 2
    return np.asarray(within & (determinant > 0))


def undistort_brown_conrady(distorted: Array, coefficients: Array) -> Array:
    """Invert ``distort_brown_conrady``: (N, 2) to (N, 2), NaN where no point within the fold answers.

    The radial polynomial is inverted from a table; Newton steps on what has not converged do the rest.
    """
    plane = _radial_guess(distorted, coefficients)
    tolerance = np.maximum(1.0, np.abs(distorted).max(axis=1, initial=0.0))
    active = np.flatnonzero(np.isfinite(plane).all(axis=1))
    limit = fold_radius(coefficients)
    for _ in range(_NEWTON_STEPS):
        if not active.size:
            break
        value, jacobian = distort_brown_conrady(plane[active], coefficients)
        error = distorted[active] - value
        todo = np.abs(error).max(axis=1) > _CONVERGED * tolerance[active]
        active = active[todo]
        plane[active] = _clamped(plane[active] + _solve_2x2(jacobian[todo], error[todo]), limit)
    value, jacobian = distort_brown_conrady(plane, coefficients)
    residual = np.abs(distorted - value).max(axis=1, initial=0.0)
    good = residual <= _ACCEPTED * tolerance
    good &= within_fold_brown_conrady(plane, jacobian, coefficients)
    return np.where(good[:, None], plane, np.nan)


def fold_radius(coefficients: Array) -> float:
    """Return the undistorted radius at which k1 k2 p1 p2 k3 turns back; infinite if it never does."""
    k1, k2, _, _, k3 = (float(each) for each in coefficients)
    return first_turn((7 * k3, 5 * k2, 3 * k1, 1.0))


def _radial_guess(distorted: Array, coefficients: Array) -> Array:
    """Invert the radial part alone, by a table up to the fold; NaN for what lies out of reach beyond it."""
    k1, k2, p1, p2, k3 = (float(each) for each in coefficients)
    radius_d = np.hypot(distorted[:, 0], distorted[:, 1])
    top = fold_radius(coefficients)
    reach = np.inf
    if np.isfinite(top):
        reach = _radial(np.array([top]), k1, k2, k3)[0] + 3 * (abs(p1) + abs(p2)) * top**2
    else:
        top = 1.0
        farthest = float(np.max(radius_d, initial=0.0, where=np.isfinite(radius_d)))
        while top < _LARGEST_RADIUS and _radial(np.array([top]), k1, k2, k3)[0] < farthest + 0.1:
            top *= 2.0
    table, table_d = _radial_table(k1, k2, k3, top)
    radius = np.interp(radius_d, table_d, table)
    radius[radius_d > reach] = np.nan
    return np.asarray(distorted * (radius / np.maximum(radius_d, 1e-300))[:, None])


@lru_cache(maxsize=64)
def _radial_table(k1: float, k2: float, k3: float, top: float) -> tuple[Array, Array]:
    table = np.linspace(0.0, top, _TABLE_SIZE)
    return table, _radial(table, k1, k2, k3)


def _radial(radius: Array, k1: float, k2: float, k3: float) -> Array:
    r2 = radius * radius
    return np.asarray(radius * (1 + r2 * (k1 + r2 * (k2 + r2 * k3))))


def _solve_2x2(matrix: Array, vector: Array) -> Array:
    """Solve (N, 2, 2) symmetric systems; a nearly singular one takes a bounded step."""
    a, b, d = matrix[:, 0, 0], matrix[:, 0, 1], matrix[:, 1, 1]
    determinant = a * d - b * b
    determinant = np.where(np.abs(determinant) < 1e-12, 1e-12, determinant)
    x, y = vector[:, 0], vector[:, 1]
    step = np.stack([d * x - b * y, a * y - b * x], -1) / determinant[:, None]
    return np.asarray(step / np.maximum(1.0, np.abs(step).max(axis=1, initial=0.0) / 0.5)[:, None])


def _clamped(plane: Array, limit: float) -> Array:
    """Pull (N, 2) points back to the disk of a radius."""
    if not np.isfinite(limit):
        return plane
    radius = np.hypot(plane[:, 0], plane[:, 1])
    return np.asarray(plane * np.minimum(1.0, limit / np.maximum(radius, 1e-300))[:, None])
