"""Compare a recording's ``camera_info`` with the rig file, whose intrinsics win."""

from __future__ import annotations

from typing import Any

import numpy as np

from estimator.camera import Camera, CameraModel
from estimator.se3 import Array

_MODELS: dict[str, tuple[CameraModel, ...]] = {
    "plumb_bob": ("brown_conrady", "pinhole"),
    "rational_polynomial": ("brown_conrady", "pinhole"),
    "equidistant": ("kannala_brandt",),
    "": ("pinhole",),
}
_PIXEL_TOLERANCE_PX = 0.05
_COEFFICIENT_TOLERANCE = 1e-4


def camera_info_disagreement(info: Any, camera: Camera) -> str | None:
    """Say how a sensor_msgs/CameraInfo differs from the rig's camera; None if it agrees or says nothing."""
    fx, _, cx, _, fy, cy, *_ = np.asarray(info.k, float)
    if fx == 0.0:  # ROS's mark of an uncalibrated camera
        return None
    size_px = (int(info.width), int(info.height))
    if size_px != (0, 0) and size_px != tuple(camera.size_px):
        return f"size_px {list(size_px)}, the rig file {list(camera.size_px)}"
    for name, got, wanted in (
        ("focal_px", (fx, fy), camera.focal_px),
        ("center_px", (cx, cy), camera.center_px),
    ):
        if not np.allclose(got, wanted, rtol=0.0, atol=_PIXEL_TOLERANCE_PX):
            return f"{name} {_rounded(got)}, the rig file {_rounded(wanted)}"
    return _distortion_disagreement(info, camera)


def _distortion_disagreement(info: Any, camera: Camera) -> str | None:
    got = np.asarray(info.d, float)
    straight = not got.any() and not any(camera.distortion)
    if not straight and camera.model not in _MODELS.get(info.distortion_model, ()):
        return f"distortion model {info.distortion_model!r}, the rig file {camera.model}"
    length = max(len(got), len(camera.distortion))
    if not np.allclose(_padded(got, length), _padded(camera.distortion, length), atol=_COEFFICIENT_TOLERANCE):
        return f"distortion {_rounded(got)}, the rig file {_rounded(camera.distortion)}"
    return None


def _padded(values: Any, length: int) -> Array:
    return np.pad(np.asarray(values, float), (0, length - len(values)))


def _rounded(values: Any) -> list[float]:
    return [round(float(value), 6) for value in values]
