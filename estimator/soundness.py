"""Refuse what an adjustment gives when it was asked for more than its sightings hold."""

from __future__ import annotations

import numpy as np

from estimator.window_result import WindowResult

_LEAST_EIGENVALUE = -1e-9  # of the greatest: rounding


def is_sound(result: WindowResult) -> bool:
    """Tell whether every pose is finite and the covariance is one: finite and positive semidefinite."""
    poses = [*result.scene.world_from_egos, *(m.ego_from_cam for m in result.belief.rig.cameras.values())]
    covariance = result.belief.covariance
    if not np.isfinite(covariance).all() or not all(np.isfinite(pose.matrix).all() for pose in poses):
        return False
    if covariance.size == 0:
        return True
    eigenvalues = np.linalg.eigvalsh(0.5 * (covariance + covariance.T))
    return bool(eigenvalues[0] >= _LEAST_EIGENVALUE * eigenvalues[-1])
