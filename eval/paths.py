"""The two paths of a run, estimated and true, and how far the car had driven at each bundle."""

from __future__ import annotations

import numpy as np

from estimator.se3 import SE3, Array
from eval.collect import RunLog
from eval.trajectory import Trajectory
from eval.truth import TruthTrack


def estimated_path(log: RunLog) -> Trajectory:
    """Return the trajectory of ``close()``, or the online poses where it gave none; finite poses only."""
    if log.final.trajectory:
        known: list[tuple[int, SE3 | None]] = list(log.final.trajectory)
    else:
        known = [(entry.stamp_ns, entry.world_from_ego) for entry in log.entries]
    finite = [(stamp, pose) for stamp, pose in known if pose is not None and np.isfinite(pose.matrix).all()]
    return Trajectory.from_poses([stamp for stamp, _ in finite], [pose for _, pose in finite])


def true_path(truth: TruthTrack | None) -> Trajectory | None:
    """Return the true path; None where there is none."""
    if truth is None or not len(truth.stamps_ns):
        return None
    return Trajectory.from_poses([int(stamp) for stamp in truth.stamps_ns], list(truth.world_from_ego))


def driven_m(log: RunLog, truth: TruthTrack | None) -> Array | None:
    """Return the (N,) distance driven at each bundle since the first one.

    Along the true path, or the estimated one where there is no truth; None where neither is known.
    """
    path = true_path(truth) or estimated_path(log)
    if not len(path):
        return None
    at_bundle = path.distance_m_at(log.stamps_ns)
    return np.asarray(at_bundle - at_bundle[0])
