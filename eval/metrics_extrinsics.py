"""How well the cameras' poses were found: at the end, and after set distances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from statistics import median

import numpy as np

from estimator.estimate import CameraEstimate
from eval.collect import RunLog
from eval.errors import PoseError, pose_error
from eval.metric import Missing, Value
from eval.metric_keys import CHECKPOINTS_M, NO_TRUTH, extrinsic_key
from eval.paths import driven_m
from eval.truth import TruthTrack

_QUANTITIES = ("rotation_deg", "translation_mm")
_NO_BOUND = Missing("no bound was computed for this run")
# A drive of 50 m whose last bundle is taken at 49.5 m, one frame short of the end, still counts as 50 m.
_CHECKPOINT_SLACK = 0.02

Errors = Mapping[str, PoseError | Missing]


def extrinsic_metrics(log: RunLog, truth: TruthTrack | None) -> dict[str, Value]:
    """Return every ``extrinsics.*`` value."""
    names = log.rig.estimated_names
    values: dict[str, Value] = {f"extrinsics.{name}.bound_ratio": _NO_BOUND for name in (*names, "worst")}
    values |= _summary(camera_errors(log.final.cameras, truth, log.last_stamp_ns, names), None)
    driven = driven_m(log, truth)
    for checkpoint in CHECKPOINTS_M:
        values |= _summary(_errors_at(checkpoint, driven, log, truth), checkpoint)
    return values


def camera_errors(
    estimates: Mapping[str, CameraEstimate], truth: TruthTrack | None, stamp_ns: int, names: Sequence[str]
) -> dict[str, PoseError | Missing]:
    """Return each camera's error at a stamp, or why it has none."""
    if truth is None:
        return dict.fromkeys(names, Missing(NO_TRUTH))
    true_poses = truth.ego_from_cams_at(stamp_ns)
    errors: dict[str, PoseError | Missing] = {}
    for name in names:
        if name not in true_poses:
            errors[name] = Missing(f"the truth does not hold camera {name!r}")
        elif name not in estimates:
            errors[name] = Missing(f"the estimator gave no pose of camera {name!r}")
        else:
            errors[name] = pose_error(estimates[name].ego_from_cam, true_poses[name])
    return errors


def checkpoint_index(checkpoint_m: float, driven: np.ndarray) -> int | None:
    """Return the first bundle at or past a distance; None where the drive ends before it."""
    reached = np.flatnonzero(driven >= checkpoint_m)
    if len(reached):
        return int(reached[0])
    return len(driven) - 1 if driven[-1] >= checkpoint_m * (1 - _CHECKPOINT_SLACK) else None


def _errors_at(
    checkpoint_m: int, driven: np.ndarray | None, log: RunLog, truth: TruthTrack | None
) -> dict[str, PoseError | Missing]:
    names = log.rig.estimated_names
    if driven is None:
        return dict.fromkeys(names, Missing("the distance driven is not known"))
    index = checkpoint_index(checkpoint_m, driven)
    if index is None:
        return dict.fromkeys(names, Missing(f"the drive is {driven[-1]:.1f} m long"))
    entry = log.entries[index]
    return camera_errors(entry.cameras, truth, entry.stamp_ns, names)


def _summary(errors: Errors, checkpoint_m: int | None) -> dict[str, Value]:
    """Name the errors of each camera, of the worst and of the median, each quantity by itself."""
    values: dict[str, Value] = {}
    missing = next((error for error in errors.values() if isinstance(error, Missing)), None)
    found = [error for error in errors.values() if isinstance(error, PoseError)]
    for quantity in _QUANTITIES:
        for name, error in errors.items():
            value = error if isinstance(error, Missing) else getattr(error, quantity)
            values[extrinsic_key(name, quantity, checkpoint_m)] = value
        numbers = [float(getattr(error, quantity)) for error in found]
        for name, reduce in (("worst", max), ("median", median)):
            lacking = missing or (None if numbers else Missing("the rig has only its reference camera"))
            values[extrinsic_key(name, quantity, checkpoint_m)] = lacking or float(reduce(numbers))
    return values
