"""Rays and poses in PoseLib's words: points on a pinhole's image plane in pixels, and its camera and pose."""

from __future__ import annotations

import numpy as np
import poselib

from estimator.camera import Camera
from estimator.se3 import SE3, Array


def focal_of(camera: Camera) -> float:
    """Return the focal length that gives points on the plane about the pixels of the camera itself."""
    return float(np.mean(camera.focal_px))


def on_plane_px(rays_cam: Array, focal_px: float) -> Array:
    """Return (N, 2) where (N, 3) rays cross the plane of an ideal pinhole, from its middle."""
    return np.asarray(rays_cam[:, :2] / rays_cam[:, 2:] * focal_px)


def pinhole(focal_px: float) -> dict[str, object]:
    """Return that pinhole as PoseLib describes a camera."""
    return {"model": "PINHOLE", "width": 2, "height": 2, "params": [focal_px, focal_px, 0.0, 0.0]}


def to_poselib(to_from: SE3) -> poselib.CameraPose:
    """Return a transform as PoseLib's pose."""
    pose = poselib.CameraPose()
    pose.R, pose.t = to_from.rotation, to_from.translation
    return pose


def from_poselib(pose: poselib.CameraPose) -> SE3:
    """Return PoseLib's pose as a transform."""
    return SE3(np.array(pose.R), np.array(pose.t))
