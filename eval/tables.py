"""The plain-text files of a run folder: the extrinsics as CSV, paths in TUM format, events as JSON lines.

None of them depends on truth, but for ``truth.tum``; the same run gives the same bytes.
"""

from __future__ import annotations

import csv
import json
from collections.abc import Iterator
from io import StringIO
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from estimator.estimate import CameraEstimate, Status
from estimator.rig import Rig
from eval.collect import RunLog
from eval.findings import finding_events
from eval.scale import scale_data
from eval.trajectory import Trajectory

CSV_COLUMNS = (
    *("stamp_ns", "camera", "tx_m", "ty_m", "tz_m", "qx", "qy", "qz", "qw"),
    *("sigma_rx_rad", "sigma_ry_rad", "sigma_rz_rad", "sigma_tx_m", "sigma_ty_m", "sigma_tz_m", "status"),
)


def extrinsics_csv(log: RunLog) -> str:
    """Return the online estimates as CSV: a row a bundle and camera, the reference with zero sigmas."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(CSV_COLUMNS)
    for entry in log.entries:
        cameras = {log.rig.reference: _reference(log.rig), **entry.cameras}
        writer.writerows(
            _csv_row(entry.stamp_ns, name, cameras[name]) for name in log.rig.cameras if name in cameras
        )
    return text.getvalue()


def _reference(rig: Rig) -> CameraEstimate:
    """The reference camera as the rig gives it, for an estimator that does not repeat it."""
    return CameraEstimate(rig[rig.reference].ego_from_cam, np.zeros((6, 6)), Status.CONVERGED)


def _csv_row(stamp_ns: int, name: str, camera: CameraEstimate) -> list[str]:
    pose = camera.ego_from_cam
    sigma = np.sqrt(np.maximum(np.diag(camera.covariance), 0.0))
    is_finite = bool(np.isfinite(pose.matrix).all())
    seven = [*pose.translation, *pose.quaternion_xyzw] if is_finite else [np.nan] * 7
    numbers = [*seven, *sigma]
    return [str(stamp_ns), name, *map(_decimal, numbers), str(camera.status)]


def _decimal(number: float) -> str:
    text = f"{number:.9f}"
    return text.removeprefix("-") if float(text) == 0 else text


def tum(path: Trajectory) -> str:
    """Return a path as ``t x y z qx qy qz qw`` lines; seconds with 9 decimals, exact to the nanosecond."""
    if not len(path):
        return ""
    quaternions = Rotation.from_matrix(path.rotations).as_quat(canonical=True)
    lines = []
    for stamp, position, quaternion in zip(path.stamps_ns, path.positions_world, quaternions, strict=True):
        numbers = " ".join(_decimal(number) for number in (*position, *quaternion))
        lines.append(f"{seconds_text(int(stamp))} {numbers}\n")
    return "".join(lines)


def seconds_text(stamp_ns: int) -> str:
    """Write integer nanoseconds as seconds without rounding."""
    sign = "-" if stamp_ns < 0 else ""
    seconds, rest = divmod(abs(stamp_ns), 10**9)
    return f"{sign}{seconds}.{rest:09d}"


def events_jsonl(log: RunLog, warnings: tuple[str, ...]) -> str:
    """Return what happened: the reader's warnings, then changes of status and findings in order of time.

    Last comes where the metres came from.
    """
    events: list[dict[str, Any]] = [{"event": "warning", "text": text} for text in warnings]
    events += sorted([*status_changes(log), *finding_events(log)], key=lambda event: event["stamp_ns"])
    scale = scale_data(log.final)
    events += [] if scale is None else [{"event": "scale", "stamp_ns": log.final.stamp_ns, **scale}]
    return "".join(json.dumps(event) + "\n" for event in events)


def status_changes(log: RunLog) -> Iterator[dict[str, Any]]:
    """Yield the first status of each camera and every later change, in order of time."""
    before: dict[str, Status] = {}
    for entry in log.entries:
        for name in log.rig.estimated_names:
            camera = entry.cameras.get(name)
            if camera is None or before.get(name) is camera.status:
                continue
            previous = before.get(name)
            yield {
                "event": "status",
                "stamp_ns": entry.stamp_ns,
                "camera": name,
                "from": None if previous is None else str(previous),
                "to": str(camera.status),
            }
            before[name] = camera.status
