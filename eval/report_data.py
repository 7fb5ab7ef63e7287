"""Everything the report shows besides the scores, as JSON values, so that it can be made again."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from estimator.estimate import CameraEstimate
from estimator.rig import Rig
from estimator.se3 import SE3
from eval.collect import RunLog
from eval.errors import PoseError, pose_error, stated_error95
from eval.findings import finding_rows
from eval.header import RunHeader
from eval.metrics_consistency import inside_region95
from eval.mounting import car_rows, roll_pitch_yaw_deg, view_fan_ego
from eval.paths import driven_m
from eval.report_paths import map_paths
from eval.report_pictures import match_pictures, moment_pictures
from eval.report_series import error_series, stage_series
from eval.scale import scale_data
from eval.tables import status_changes
from eval.truth import TruthTrack


def report_data(log: RunLog, header: RunHeader, truth: TruthTrack | None) -> dict[str, Any]:
    """Gather the data of ``report.html``; no NaN, so that it is JSON."""
    driven = driven_m(log, truth)
    front, rear = car_rows(log.rig)
    return {
        "about": header.about,
        "warnings": list(header.warnings),
        "has_truth": truth is not None,
        "reference": log.rig.reference,
        "bundle_count": len(log.entries),
        "duration_s": (log.last_stamp_ns - log.first_stamp_ns) * 1e-9,
        "driven_m": None if driven is None else float(driven[-1]),
        "rows": [front, rear],
        "cameras": {name: _camera(name, log, truth) for name in log.rig.cameras},
        "series": error_series(log, truth),
        "scale": scale_data(log.final),
        "stages": stage_series(log),
        "paths": map_paths(log, truth),
        "moments": moment_pictures(log),
        "matches": match_pictures(log),
        "findings": finding_rows(log),
        "events": [
            {**event, "time_s": (event["stamp_ns"] - log.first_stamp_ns) * 1e-9}
            for event in status_changes(log)
        ],
    }


def _camera(name: str, log: RunLog, truth: TruthTrack | None) -> dict[str, Any]:
    estimate = log.final.cameras.get(name)
    true = None if truth is None else truth.ego_from_cams_at(log.last_stamp_ns).get(name)
    poses = {"nominal": log.rig[name].ego_from_cam}
    if estimate is not None and np.isfinite(estimate.ego_from_cam.matrix).all():
        poses["estimated"] = estimate.ego_from_cam
    if true is not None:
        poses["true"] = true
    return {
        "is_reference": name == log.rig.reference,
        "poses": {kind: _pose(pose, name, log.rig) for kind, pose in poses.items()},
        **_evidence(estimate, true, log.rig[name].ego_from_cam),
    }


def _evidence(estimate: CameraEstimate | None, true: SE3 | None, nominal: SE3) -> dict[str, Any]:
    """Return status, inliers, errors and what the covariance allows; None for what there is not."""
    start = None if true is None else pose_error(nominal, true)
    if estimate is None:
        return {"status": None, "inlier_count": 0, "error": None, "start_error": _error(start)} | {
            "stated95": None,
            "inside95": None,
            "weak_axes": [],
        }
    return {
        "status": str(estimate.status),
        "inlier_count": int(estimate.inlier_count),
        "weak_axes": list(estimate.weak_axes),
        "error": None if true is None else _error(pose_error(estimate.ego_from_cam, true)),
        "start_error": _error(start),
        "stated95": _error(stated_error95(estimate.covariance)),
        "inside95": None if true is None else inside_region95(estimate, true),
    }


def _pose(pose: SE3, name: str, rig: Rig) -> dict[str, list[float]]:
    return {
        "roll_pitch_yaw_deg": list(roll_pitch_yaw_deg(pose, rig[name].ego_from_cam)),
        "translation_mm": [1000 * float(x) for x in pose.translation],
        "fan_m": np.round(view_fan_ego(rig[name].camera, pose), 4).tolist(),
    }


def _error(error: PoseError | None) -> dict[str, float | None] | None:
    if error is None:
        return None
    values = {"rotation_deg": error.rotation_deg, "translation_mm": error.translation_mm}
    return {key: value if math.isfinite(value) else None for key, value in values.items()}
