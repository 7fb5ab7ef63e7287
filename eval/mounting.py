"""How a camera sits on the car, in words people use: roll, pitch, yaw, a row of the car, a fan of view."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.camera import Camera
from estimator.rig import Rig
from estimator.se3 import SE3, Array

# Axes of a camera's body (x along the view, y left, z up) in its optical frame.
_CAM_FROM_BODY = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
# Two cameras with nearly the same heading are ordered by where they sit: 1 m counts as 30 deg.
_DEG_PER_M = 30.0
_FAN_POINTS = 9


def roll_pitch_yaw_deg(ego_from_cam: SE3, near: SE3) -> tuple[float, float, float]:
    """Return the angles that turn the ego axes into the camera's body axes.

    Yaw about z (left positive), then pitch about y (down positive), then roll about x: ISO 8855. Full turns
    are chosen so that the angles lie near those of another pose: 180.1 deg beside 179.9, not -179.9.
    """
    angles, wanted = _angles_deg(ego_from_cam), _angles_deg(near)
    roll, pitch, yaw = angles - 360 * np.round((angles - wanted) / 360)
    return float(roll), float(pitch), float(yaw)


def _angles_deg(ego_from_cam: SE3) -> Array:
    """Return roll, pitch, yaw, each within half a turn of zero."""
    body = ego_from_cam.rotation @ _CAM_FROM_BODY
    roll, yaw = np.arctan2(body[2, 1], body[2, 2]), np.arctan2(body[1, 0], body[0, 0])
    return np.asarray(np.degrees([roll, -np.arcsin(np.clip(body[2, 0], -1, 1)), yaw]))


def car_rows(rig: Rig) -> tuple[list[str], list[str]]:
    """Return the cameras that look forward and those that look back, each from left to right of the car."""
    places = {name: _place(rig[name].ego_from_cam) for name in rig.cameras}
    front = {name: yaw + _DEG_PER_M * y for name, (yaw, y) in places.items() if abs(yaw) <= 90}
    rear = {
        name: (180 - yaw + 180) % 360 - 180 + _DEG_PER_M * y
        for name, (yaw, y) in places.items()
        if abs(yaw) > 90
    }
    return sorted(front, key=lambda name: -front[name]), sorted(rear, key=lambda name: -rear[name])


def is_left_of(first: SE3, second: SE3) -> bool:
    """Tell whether a camera's image belongs left of another's when both are laid side by side."""
    first_from_second = first.inverse() @ second
    looks_right, sits_right_m = first_from_second.rotation[0, 2], first_from_second.translation[0]
    return bool(looks_right + np.radians(_DEG_PER_M) * sits_right_m > 0)


def view_fan_ego(camera: Camera, ego_from_cam: SE3) -> Array:
    """Return the (N + 1, 2) outline, in ego x and y, of what the middle row of the image sees within 1 m."""
    columns = np.linspace(-0.5, camera.size_px[0] - 0.5, _FAN_POINTS)
    pixels = np.column_stack([columns, np.full(_FAN_POINTS, camera.center_px[1])])
    arc = ego_from_cam.apply(camera.unproject(pixels))
    return np.vstack([ego_from_cam.translation, arc])[:, :2]


def _place(ego_from_cam: SE3) -> Sequence[float]:
    """Return the heading in degrees, left positive, and the sideways position in metres."""
    forward = ego_from_cam.rotation[:, 2]
    return float(np.degrees(np.arctan2(forward[1], forward[0]))), float(ego_from_cam.translation[1])
