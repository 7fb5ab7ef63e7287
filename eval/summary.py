"""The few lines that end a run: how far off each camera is, and where the report lies."""

from __future__ import annotations

import numpy as np

from estimator.estimate import CameraEstimate, Status
from eval.findings import finding_line
from eval.judge import RunResult
from eval.metric_keys import extrinsic_key
from eval.print_table import print_table
from eval.scale import scale_line

_COLUMNS = ("camera", "status", "rotation_deg", "translation_mm", "sigma_deg", "sigma_mm")


def print_summary(result: RunResult) -> None:
    """Print errors against truth, and the sigmas that the estimator states (norms over the three axes)."""
    rows = [_camera_row(result, camera) for camera in result.rig.estimated_names]
    rows += [(pooled, "", *_errors(result, pooled), "", "") for pooled in ("median", "worst")]
    print_table(_COLUMNS, rows, right=_COLUMNS[2:])
    line = scale_line(result.final)
    if line:
        print(line)
    reason = result.metrics[extrinsic_key("worst", "rotation_deg")].reason
    if reason:
        print(f"errors are not known: {reason}")
    for finding in result.final.findings:
        print(finding_line(finding))
    print(f"report: {result.folder / 'report.html'}")


def _camera_row(result: RunResult, camera: str) -> tuple[str, ...]:
    estimate = result.final.cameras[camera]
    sigma_deg = float(np.degrees(np.linalg.norm(estimate.sigma[:3])))
    sigma_mm = 1000 * float(np.linalg.norm(estimate.sigma[3:]))
    return camera, _status_text(estimate), *_errors(result, camera), f"{sigma_deg:.3f}", f"{sigma_mm:.1f}"


def _status_text(estimate: CameraEstimate) -> str:
    """Return the status, with the axes that the drive has not shown once it has shown any."""
    if not estimate.weak_axes or estimate.status is Status.INITIALISING:
        return estimate.status.value
    return f"{estimate.status.value} in {', '.join(estimate.weak_axes)}"


def _errors(result: RunResult, camera: str) -> tuple[str, str]:
    rotation = result.metrics[extrinsic_key(camera, "rotation_deg")].value
    translation = result.metrics[extrinsic_key(camera, "translation_mm")].value
    return (
        "-" if rotation is None else f"{rotation:.3f}",
        "-" if translation is None else f"{translation:.1f}",
    )
