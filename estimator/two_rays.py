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
    baseline = last_center_world - first_center_world
    cosine = np.clip(np.einsum("ni,ni->n", first_world, last_world), -1, 1)
    sine2 = np.maximum(1 - cosine**2, 1e-12)
    along_first = np.einsum("ni,ni->n", first_world, baseline)
    along_last = np.einsum("ni,ni->n", last_world, baseline)
    depth_first = (along_first - cosine * along_last) / sine2
    depth_last = (cosine * along_first - along_last) / sine2
    good = (
        (np.arccos(cosine) > min_angle_rad) & (depth_first > _LEAST_DEPTH_M) & (depth_last > _LEAST_DEPTH_M)
    )
    middle = 0.5 * (first_center_world + depth_first[:, None] * first_world)
    middle += 0.5 * (last_center_world + depth_last[:, None] * last_world)
    middle[~good] = np.nan
    return np.asarray(middle)
