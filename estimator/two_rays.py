"""Where two viewing rays of one point meet."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array

_LEAST_DEPTH_M = 0.3


def midpoints(
    first_world: Array,
    first_center_world: Array,
    last_world: Array,
    last_center_world: Array,
    min_angle_rad: float,
) -> Array:
    """Return (N, 3) points midway between pairs of rays, in metres.

    A point is NaN where the rays are less than ``min_angle_rad`` apart, where it lies behind or hardly before
    one of the cameras, and where a centre is NaN.

    Args:
        first_world: (N, 3) unit rays.
        first_center_world: (N, 3) where they begin, in metres.
        last_world: (N, 3) unit rays.
        last_center_world: (3,) where all of these begin, in metres.
        min_angle_rad: The least angle between the rays of a pair.

    Reference:
        Hartley & Sturm 1997, sec. 5.
    """
    depth_first, depth_last = depths_m(first_world, last_world, last_center_world - first_center_world)
    angle_rad = np.arccos(np.clip(np.einsum("ni,ni->n", first_world, last_world), -1, 1))
    good = (angle_rad > min_angle_rad) & (depth_first > _LEAST_DEPTH_M) & (depth_last > _LEAST_DEPTH_M)
    middle = 0.5 * (first_center_world + depth_first[:, None] * first_world)
    middle += 0.5 * (last_center_world + depth_last[:, None] * last_world)
    middle[~good] = np.nan
    return np.asarray(middle)


def depths_m(first: Array, last: Array, baseline: Array) -> tuple[Array, Array]:
    """Return (N,) how far along the first and the last ray of each pair the two are nearest to each other.

    Rays are (N, 3) unit vectors; ``baseline`` is (N, 3), from where first rays begin to where last ones do.
    """
    cosine = np.clip(np.einsum("ni,ni->n", first, last), -1, 1)
    sine2 = np.maximum(1 - cosine**2, 1e-12)
    along_first = np.einsum("ni,ni->n", first, baseline)
    along_last = np.einsum("ni,ni->n", last, baseline)
    return (along_first - cosine * along_last) / sine2, (cosine * along_first - along_last) / sine2
