"""The curves of the report: each camera's error and stated uncertainty over the drive, and stage times."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from estimator.estimate import CameraEstimate, Status
from estimator.se3 import SE3
from eval.collect import LogEntry, RunLog
from eval.errors import PoseError, pose_error, stated_error95
from eval.paths import driven_m
from eval.truth import TruthTrack

_MAX_POINTS = 400
_MAX_BINS = 60


def error_series(log: RunLog, truth: TruthTrack | None) -> dict[str, Any]:
    """Return, for at most 400 bundles, the distance from truth, or from the nominal pose without truth."""
    indices = np.unique(np.linspace(0, len(log.entries) - 1, _MAX_POINTS).astype(int))
    chosen = [log.entries[index] for index in indices]
    driven = driven_m(log, truth)
    return {
        "against": "nominal" if truth is None else "truth",
        "time_s": [(entry.stamp_ns - log.first_stamp_ns) * 1e-9 for entry in chosen],
        "driven_m": None if driven is None else finite_list(driven[indices]),
        "cameras": {name: _camera_series(name, chosen, log, truth) for name in log.rig.estimated_names},
    }


def _camera_series(
    name: str, entries: list[LogEntry], log: RunLog, truth: TruthTrack | None
) -> dict[str, list[float | None] | int | None]:
    found = [(entry.stamp_ns, entry.cameras.get(name)) for entry in entries]
    errors = [_distance(camera, _compared_with(name, stamp, log, truth)) for stamp, camera in found]
    stated = [None if camera is None else stated_error95(camera.covariance) for _, camera in found]
    converged = [camera is not None and camera.status is Status.CONVERGED for _, camera in found]
    return {
        "rotation_deg": finite_list(None if error is None else error.rotation_deg for error in errors),
        "translation_mm": finite_list(None if error is None else error.translation_mm for error in errors),
        "rotation95_deg": finite_list(None if error is None else error.rotation_deg for error in stated),
        "translation95_mm": finite_list(None if error is None else error.translation_mm for error in stated),
        "converged_index": converged.index(True) if any(converged) else None,
    }


def _distance(camera: CameraEstimate | None, against: SE3 | None) -> PoseError | None:
    return None if camera is None or against is None else pose_error(camera.ego_from_cam, against)


def _compared_with(name: str, stamp_ns: int, log: RunLog, truth: TruthTrack | None) -> SE3 | None:
    if truth is None:
        return log.rig[name].ego_from_cam
    return truth.ego_from_cams_at(stamp_ns).get(name)


def stage_series(log: RunLog) -> dict[str, Any]:
    """Return mean milliseconds a bundle by stage, in at most 60 bins of the drive, and seconds in all."""
    names = sorted({stage for entry in log.entries for stage in entry.stage_s} | set(log.final.stage_s))
    bins = np.array_split(np.arange(len(log.entries)), min(_MAX_BINS, len(log.entries)))
    middle_s = [(log.entries[part[len(part) // 2]].stamp_ns - log.first_stamp_ns) * 1e-9 for part in bins]
    return {
        "time_s": middle_s,
        "bin_bundles": len(bins[0]),
        "stages": {name: _stage(name, log, bins) for name in names},
    }


def _stage(name: str, log: RunLog, bins: list[Any]) -> Mapping[str, Any]:
    told_s = [
        stage_s.get(name, 0.0) for stage_s in (*(each.stage_s for each in log.entries), log.final.stage_s)
    ]
    seconds = np.nan_to_num(np.array(told_s), posinf=0.0, neginf=0.0)  # what is no number is no time
    return {
        "ms": [1000 * float(seconds[part].mean()) for part in bins],
        "updates_s": float(seconds[:-1].sum()),
        "close_s": float(seconds[-1]),
    }


def finite_list(numbers: Iterable[float | None]) -> list[float | None]:
    """Return floats with 6 significant digits; None for what is not finite."""
    return [None if x is None or not math.isfinite(x) else float(f"{x:.6g}") for x in numbers]
