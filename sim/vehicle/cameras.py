"""Cameras as MuJoCo ``<camera>`` elements on the chassis, and their true poses read back.

MuJoCo's camera frame (``glcam``) is x right, y up, z back; only this file knows it.
"""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3

_CAM_FROM_GLCAM = SE3(np.diag([1.0, -1.0, -1.0]))
_SENSOR_SIZE_M = (0.0064, 0.004)  # any size will do, but without one the intrinsics are ignored


def write_cameras(
    body: mujoco.MjsBody, sources: Mapping[str, Camera], body_from_cams: Mapping[str, SE3]
) -> None:
    """Add one camera a source pinhole to a body, at its true pose; other camera models have no element."""
    for name, source in sources.items():
        pose = body_from_cams[name] @ _CAM_FROM_GLCAM
        camera = body.add_camera(name=name, pos=pose.translation, quat=pose.quaternion_xyzw[[3, 0, 1, 2]])
        camera.resolution = source.size_px
        camera.sensor_size = _SENSOR_SIZE_M
        camera.focal_pixel = source.focal_px
        # MuJoCo counts from the image's corner and with the opposite sign.
        camera.principal_pixel = [
            -(center_px + 0.5 - length_px / 2)
            for center_px, length_px in zip(source.center_px, source.size_px, strict=True)
        ]


def world_from_cam(data: mujoco.MjData, name: str) -> SE3:
    """Return a camera's pose as MuJoCo computed it last (``cam_xpos``, ``cam_xmat``)."""
    camera = data.camera(name)
    return SE3(camera.xmat.reshape(3, 3), camera.xpos) @ _CAM_FROM_GLCAM.inverse()
