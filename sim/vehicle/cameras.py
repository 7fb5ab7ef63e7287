"""Cameras as MuJoCo ``<camera>`` elements on the chassis, and their true poses read back.

MuJoCo's camera frame (``glcam``) is x right, y up, z back; only this file knows it.
"""

from __future__ import annotations

from collections.abc import Mapping

import mujoco
import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.vehicle.miscalibration import Mounts

_CAM_FROM_GLCAM = SE3(np.diag([1.0, -1.0, -1.0]))
_SENSOR_SIZE_M = (0.0064, 0.004)  # any size will do, but without one the intrinsics are ignored


def write_cameras(
    body: mujoco.MjsBody, sources: Mapping[str, Camera], body_from_cams: Mapping[str, SE3]
) -> None:
    """Add one camera a source pinhole to a body, at its true pose; other camera models have no element."""
    for name, source in sources.items():
        position_m, quaternion_wxyz = _in_mujoco(body_from_cams[name])
        camera = body.add_camera(name=name, pos=position_m, quat=quaternion_wxyz)
        camera.resolution = source.size_px
        camera.sensor_size = _SENSOR_SIZE_M
        camera.focal_pixel = source.focal_px
        # MuJoCo counts from the image's corner and with the opposite sign.
        camera.principal_pixel = [
            -(center_px + 0.5 - length_px / 2)
            for center_px, length_px in zip(source.center_px, source.size_px, strict=True)
        ]


class MovingCameras:
    """The cameras of a freshly compiled model whose mounting changes during the drive."""

    def __init__(self, model: mujoco.MjModel, mounts: Mounts) -> None:
        self._model, self.mounts = model, mounts
        self._compiled = {
            name: (model.camera(name).pos.copy(), model.camera(name).quat.copy()) for name in mounts.movements
        }

    def put(self, time_s: float) -> None:
        """Mount each where it is at a time; where nothing has happened yet, as compiled, to the bit."""
        for name, compiled in self._compiled.items():
            moved = self.mounts.moved(name, time_s)
            camera = self._model.camera(name)
            camera.pos[:], camera.quat[:] = compiled if moved is None else _in_mujoco(moved)


def world_from_cam(data: mujoco.MjData, name: str) -> SE3:
    """Return a camera's pose as MuJoCo computed it last (``cam_xpos``, ``cam_xmat``)."""
    camera = data.camera(name)
    return SE3(camera.xmat.reshape(3, 3), camera.xpos) @ _CAM_FROM_GLCAM.inverse()


def _in_mujoco(body_from_cam: SE3) -> tuple[Array, Array]:
    """Return position and w x y z quaternion of the camera element."""
    pose = body_from_cam @ _CAM_FROM_GLCAM
    return pose.translation, pose.quaternion_xyzw[[3, 0, 1, 2]]
