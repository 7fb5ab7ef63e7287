"""Whether the stated covariance is true: normalised errors, and coverage of the 95 % region."""

from __future__ import annotations

import numpy as np
from scipy.stats import chi2

from estimator.estimate import CameraEstimate
from estimator.se3 import SE3
from eval.collect import RunLog
from eval.errors import squared_mahalanobis, tangent_error
from eval.metric import Missing, Value
from eval.metric_keys import NO_TRUTH
from eval.truth import TruthTrack

_FREEDOM = 6
_REGION_95 = float(chi2.ppf(0.95, _FREEDOM))


def consistency_metrics(log: RunLog, truth: TruthTrack | None) -> dict[str, Value]:
    """Return ``consistency.*`` of the final estimate.

    Reference:
        Bar-Shalom, Li & Kirubarajan 2001, sec. 5.4.
    """
    distances = squared_distances(log, truth)
    if isinstance(distances, Missing):
        return dict.fromkeys(("consistency.nees", "consistency.coverage95"), distances)
    values = np.array(list(distances.values()))
    return {
        "consistency.nees": float(values.mean() / _FREEDOM),
        "consistency.coverage95": float((values <= _REGION_95).mean()),
    }


def inside_region95(estimate: CameraEstimate, true: SE3) -> bool | None:
    """Tell whether the truth lies in the stated 95 % region; None where the covariance is not one."""
    error = tangent_error(estimate.ego_from_cam, true)
    distance = squared_mahalanobis(error, estimate.covariance)
    return None if distance is None else distance <= _REGION_95


def squared_distances(log: RunLog, truth: TruthTrack | None) -> dict[str, float] | Missing:
    """Return ``e^T inv(Sigma) e`` of every estimated camera, or why one has none."""
    if truth is None:
        return Missing(NO_TRUTH)
    if not log.rig.estimated_names:
        return Missing("the rig has only its reference camera")
    true_poses = truth.ego_from_cams_at(log.last_stamp_ns)
    distances: dict[str, float] = {}
    for name in log.rig.estimated_names:
        estimate = log.final.cameras.get(name)
        if estimate is None or name not in true_poses:
            return Missing(f"camera {name!r} has no estimate or no truth")
        error = tangent_error(estimate.ego_from_cam, true_poses[name])
        distance = squared_mahalanobis(error, estimate.covariance)
        if distance is None:
            return Missing(
                f"the pose of camera {name!r} is not finite or its covariance not positive definite"
            )
        distances[name] = distance
    return distances
