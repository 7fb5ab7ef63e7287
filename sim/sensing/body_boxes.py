"""The box around each body's visible shapes, to tell which body a point seen in a picture belongs to."""

from __future__ import annotations

import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import Array
from sim.rendering.view import NEAR_M
from sim.vehicle.car import HIDDEN_GROUP

_SLACK_M = 0.03
Window = tuple[slice, slice]


class BodyBoxes:
    """Axis-aligned boxes in the bodies' own frames; the world itself has none."""

    def __init__(self, model: mujoco.MjModel) -> None:
        low, high = np.full((model.nbody, 3), np.inf), np.full((model.nbody, 3), -np.inf)
        signs = np.stack(np.meshgrid(*[[-1.0, 1.0]] * 3), -1).reshape(-1, 3)
        for geom in np.flatnonzero((model.geom_bodyid > 0) & (model.geom_group != HIDDEN_GROUP)):
            rotation = np.zeros(9)
            mujoco.mju_quat2Mat(rotation, model.geom_quat[geom])
            center, half = model.geom_aabb[geom, :3], model.geom_aabb[geom, 3:]
            corners = model.geom_pos[geom] + (center + signs * half) @ rotation.reshape(3, 3).T
            body = model.geom_bodyid[geom]
            low[body] = np.minimum(low[body], corners.min(0))
            high[body] = np.maximum(high[body], corners.max(0))
        self._low, self._high = low - _SLACK_M, high + _SLACK_M
        self._signs = signs

    @property
    def has_box(self) -> npt.NDArray[np.bool_]:
        """(N,) which bodies have anything to see."""
        return np.asarray(np.isfinite(self._low[:, 0]))

    def window(self, body: int, face_from_body: Array, pinhole: Camera) -> Window | None:
        """Return the rows and columns of a picture that a body's box may reach; None if it is out of view."""
        middle, half = (self._low[body] + self._high[body]) / 2, (self._high[body] - self._low[body]) / 2
        corners = (middle + self._signs * half) @ face_from_body[:3, :3].T + face_from_body[:3, 3]
        if (corners[:, 2] < NEAR_M).all():
            return None
        width, height = pinhole.size_px
        if (corners[:, 2] < NEAR_M).any():
            return slice(0, height), slice(0, width)
        pixels = pinhole.project(corners)
        low = np.floor(pixels.min(0)).astype(int)
        high = np.ceil(pixels.max(0)).astype(int) + 1
        rows, columns = (
            slice(max(int(low[axis]), 0), min(int(high[axis]), pinhole.size_px[axis])) for axis in (1, 0)
        )
        return (rows, columns) if rows.start < rows.stop and columns.start < columns.stop else None

    def contains(
        self,
        body: int,
        face_from_body: Array,
        pinhole: Camera,
        window: Window,
        inverse_depth: npt.NDArray[np.float32],
    ) -> npt.NDArray[np.bool_]:
        """Tell for each pixel of a window of a picture whether its point lies in a body's box."""
        x, y = plane_grid(pinhole, window)
        body_from_face = np.linalg.inv(face_from_body).astype(np.float32)
        inside = np.ones(inverse_depth.shape, bool)
        for axis, row in enumerate(body_from_face[:3]):
            # Both sides times the inverse depth, so that the point need not be formed.
            scaled = row[0] * x + row[1] * y + row[2] + row[3] * inverse_depth
            inside &= scaled > np.float32(self._low[body, axis]) * inverse_depth
            inside &= scaled < np.float32(self._high[body, axis]) * inverse_depth
        return inside


def plane_grid(pinhole: Camera, window: Window) -> tuple[npt.NDArray[np.float32], npt.NDArray[np.float32]]:
    """Return (1, w) and (h, 1) coordinates at depth one of a window's columns and rows."""
    width, height = pinhole.size_px
    x = (np.arange(width) - pinhole.center_px[0]) / pinhole.focal_px[0]
    y = (np.arange(height) - pinhole.center_px[1]) / pinhole.focal_px[1]
    return x[None, window[1]].astype(np.float32), y[window[0], None].astype(np.float32)
