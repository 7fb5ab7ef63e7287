"""A camera's intrinsics: project, unproject, and their Jacobians.

Integer pixels are pixel centres (OpenCV). Points are in the optical frame: x right, y down, z forward.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from estimator.distortion import (
    distort_brown_conrady,
    undistort_brown_conrady,
    within_fold_brown_conrady,
)
from estimator.distortion_angle import distorted_angle, fold_angle, undistorted_angle
from estimator.se3 import Array

CameraModel = Literal["pinhole", "brown_conrady", "kannala_brandt"]
COEFFICIENT_COUNT: dict[CameraModel, int] = {"pinhole": 0, "brown_conrady": 5, "kannala_brandt": 4}
_MIN_DEPTH = 1e-9


@dataclass(frozen=True)
class Camera:
    """Intrinsics and distortion of one camera.

    Attributes:
        model: Name of the projection.
        size_px: Width and height.
        focal_px: fx and fy.
        center_px: cx and cy; integer pixels are pixel centres.
        distortion: OpenCV order, ``k1 k2 p1 p2 k3`` or ``k1 k2 k3 k4``; empty for a pinhole.
    """

    model: CameraModel
    size_px: tuple[int, int]
    focal_px: tuple[float, float]
    center_px: tuple[float, float]
    distortion: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        if self.model not in get_args(CameraModel):
            raise ValueError(f"camera model {self.model!r}; there are: {', '.join(get_args(CameraModel))}")
        wanted = COEFFICIENT_COUNT[self.model]
        if len(self.distortion) != wanted:
            raise ValueError(
                f"{self.model} takes {wanted} distortion coefficients, got {len(self.distortion)}"
            )
        if min(self.size_px) <= 0 or min(self.focal_px) <= 0:
            raise ValueError(f"size_px {self.size_px} and focal_px {self.focal_px} must be positive")
        if not np.isfinite([*self.focal_px, *self.center_px, *self.distortion]).all():
            raise ValueError(
                f"intrinsics must be finite: {self.focal_px}, {self.center_px}, {self.distortion}"
            )

    def project(self, points_cam: Array) -> Array:
        """Project (N, 3) points to (N, 2) pixels; NaN where the model cannot see the point."""
        return self._project(points_cam, False)[0]

    def project_with_jacobian(self, points_cam: Array) -> tuple[Array, Array]:
        """Project (N, 3) points; also return the (N, 2, 3) Jacobian of pixels by points."""
        pixels, jacobian = self._project(points_cam, True)
        assert jacobian is not None
        return pixels, jacobian

    def unproject(self, pixels: Array) -> Array:
        """Return the (N, 3) unit viewing rays of (N, 2) pixels, in the optical frame.

        NaN where the model has no inverse: beyond the radius at which its polynomial turns back.
        """
        pixels = np.asarray(pixels, float).reshape(-1, 2)
        plane = (pixels - np.array(self.center_px)) / np.array(self.focal_px)
        if self.model == "kannala_brandt":
            radius = np.linalg.norm(plane, axis=1)
            theta = undistorted_angle(radius, np.array(self.distortion))
            ratio = np.where(radius <= 1e-12, 1.0, np.sin(theta) / np.maximum(radius, 1e-12))
            return np.column_stack([plane * ratio[:, None], np.cos(theta)])
        if self.model == "brown_conrady":
            plane = undistort_brown_conrady(plane, np.array(self.distortion))
        rays = np.column_stack([plane, np.ones(len(plane))])
        with np.errstate(invalid="ignore"):
            return np.asarray(rays / np.linalg.norm(rays, axis=1, keepdims=True))

    def contains(self, pixels: Array, margin_px: float = 0.0) -> npt.NDArray[np.bool_]:
        """Tell which (N, 2) pixels lie inside the image, ``margin_px`` from its border; NaN is outside."""
        low = margin_px - 0.5
        high = np.array(self.size_px) - 0.5 - margin_px
        with np.errstate(invalid="ignore"):
            return np.asarray(((pixels > low) & (pixels < high)).all(axis=-1))

    def _project(self, points_cam: Array, want_jacobian: bool) -> tuple[Array, Array | None]:
        points = np.asarray(points_cam, float).reshape(-1, 3)
        if self.model == "kannala_brandt":
            plane, by_point = _fisheye_plane(points, np.array(self.distortion))
        else:
            plane, by_point = _perspective_plane(points, self.distortion)
        focal = np.array(self.focal_px)
        pixels = plane * focal + np.array(self.center_px)
        return pixels, by_point * focal[:, None] if want_jacobian else None


def _perspective_plane(points: Array, distortion: tuple[float, ...]) -> tuple[Array, Array]:
    """Return (N, 2) distorted plane coordinates and their (N, 2, 3) Jacobian; NaN at or behind z = 0."""
    depth = np.where(points[:, 2] > _MIN_DEPTH, points[:, 2], np.nan)
    plane = points[:, :2] / depth[:, None]
    jacobian = np.zeros((len(points), 2, 3))
    jacobian[:, 0, 0] = jacobian[:, 1, 1] = 1 / depth
    jacobian[:, :, 2] = -plane / depth[:, None]
    if distortion:
        undistorted = plane
        plane, by_plane = distort_brown_conrady(undistorted, np.array(distortion))
        seen = within_fold_brown_conrady(undistorted, by_plane, np.array(distortion))
        plane = np.where(seen[:, None], plane, np.nan)
        jacobian = by_plane @ jacobian
    return plane, jacobian


def _fisheye_plane(points: Array, coefficients: Array) -> tuple[Array, Array]:
    """Return (N, 2) plane coordinates and their (N, 2, 3) Jacobian of the Kannala-Brandt model."""
    x, y, z = points.T
    radius = np.hypot(x, y)
    norm2 = np.maximum(radius**2 + z**2, _MIN_DEPTH)
    theta = np.arctan2(radius, z)
    theta_d, slope = distorted_angle(theta, coefficients)
    on_axis = radius < 1e-9
    safe = np.where(on_axis, 1.0, radius)
    scale = np.where(on_axis, 1 / np.maximum(z, _MIN_DEPTH), theta_d / safe)
    scale = np.where((theta < fold_angle(coefficients)) & ~(on_axis & (z <= 0)), scale, np.nan)
    plane = points[:, :2] * scale[:, None]
    unit = points[:, :2] / safe[:, None]
    # theta = atan2(r, z): dtheta = (z dr - r dz) / (r^2 + z^2)
    by_radius = np.where(on_axis, 0.0, slope * z / norm2 - scale)
    jacobian = np.zeros((len(points), 2, 3))
    jacobian[:, :, :2] = scale[:, None, None] * np.eye(2) + by_radius[:, None, None] * (
        unit[:, :, None] * unit[:, None, :]
    )
    jacobian[:, :, 2] = -unit * (slope * radius / norm2)[:, None]
    return plane, jacobian
