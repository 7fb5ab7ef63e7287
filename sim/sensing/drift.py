"""How fast everything that a picture shows moves across it, exactly, from depth and the bodies' motion.

What is seen at a pixel moves with the body whose box its point lies in: the car that carries the camera,
other cars, people; anything else stands in the world. Nothing is fitted to images.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import cv2
import mujoco
import numpy as np
import numpy.typing as npt

from estimator.camera import Camera
from estimator.se3 import SE3, Array
from sim.rendering.view import DepthImage, View
from sim.sensing.body_boxes import BodyBoxes, plane_grid
from sim.sensing.face import PixelRates
from sim.stage import Stage
from sim.vehicle.cameras import world_from_cam

_HALF_STEP_S = 0.001
_RIM_PX = 4  # around what stands in front, which moves with it: a sample mixes what its pixels show
_STEP_IN_DEPTH = 1.1  # ratio of depths from which one thing stands in front of another


@dataclass(frozen=True, eq=False)
class _Moment:
    """Poses of all bodies and cameras at one instant."""

    world_from_bodies: Array  # (N, 4, 4)
    world_from_cams: Mapping[str, SE3]


class Drift:
    """The motion of cameras and bodies around one instant."""

    def __init__(self, stage: Stage, time_s: float, cameras: tuple[str, ...], boxes: BodyBoxes) -> None:
        self._before = _moment(stage.at(time_s - _HALF_STEP_S), cameras)
        self._after = _moment(stage.at(time_s + _HALF_STEP_S), cameras)
        self._now = _moment(stage.at(time_s), cameras)
        self._boxes = boxes
        change = np.abs(self._after.world_from_bodies - self._before.world_from_bodies)
        self._moving = np.flatnonzero((change.max((1, 2)) > 1e-7) & boxes.has_box)

    def pixel_rates(
        self, camera: str, view: View, cam_from_face: SE3, depth_m: DepthImage | None
    ) -> PixelRates:
        """Return (H, W, 2) px/s of a picture taken at the instant by a face of a camera.

        Args:
            camera: The camera's name.
            view: The face's.
            cam_from_face: Where it looks.
            depth_m: (H, W) of the picture.
        """
        moments = (self._before, self._now, self._after)
        face_from_world = [
            (moment.world_from_cams[camera] @ cam_from_face).inverse().matrix for moment in moments
        ]
        assert depth_m is not None, "the picture was taken without depth"
        inverse_depth = np.float32(1) / _front_depth(depth_m)
        everything = (slice(None), slice(None))
        rates = _rates(view.pinhole, everything, inverse_depth, _rate_matrix(face_from_world))
        for body in self._moving:
            pose = face_from_world[1] @ self._now.world_from_bodies[body]
            window = self._boxes.window(int(body), pose, view.pinhole)
            if window is None:
                continue
            inside = self._boxes.contains(int(body), pose, view.pinhole, window, inverse_depth[window])
            if inside.any():
                poses = [
                    face @ moment.world_from_bodies[body]
                    for face, moment in zip(face_from_world, moments, strict=True)
                ]
                own = _rates(view.pinhole, window, inverse_depth[window], _rate_matrix(poses))
                np.copyto(rates[window], own, where=inside[..., None])
        return rates


def _moment(data: mujoco.MjData, cameras: tuple[str, ...]) -> _Moment:
    poses = np.zeros((len(data.xpos), 4, 4))
    poses[:, :3, :3] = data.xmat.reshape(-1, 3, 3)
    poses[:, :3, 3] = data.xpos
    poses[:, 3, 3] = 1
    return _Moment(poses, {name: world_from_cam(data, name) for name in cameras})


def _rate_matrix(face_from_body: list[Array]) -> Array:
    """Return the (3, 4) matrix from a point of a body, in the face's frame now, to its velocity there."""
    before, now, after = face_from_body
    return np.asarray(((after - before) / (2 * _HALF_STEP_S) @ np.linalg.inv(now))[:3])


def _front_depth(depth_m: DepthImage) -> DepthImage:
    """Let what stands in front reach a rim further, so that its edge moves with it."""
    size = 2 * _RIM_PX + 1
    least = cv2.erode(depth_m, np.ones((size, size), np.uint8))
    return np.where(depth_m > _STEP_IN_DEPTH * least, least, depth_m).astype(np.float32)


def _rates(
    pinhole: Camera, window: tuple[slice, slice], inverse_depth: npt.NDArray[np.float32], matrix: Array
) -> PixelRates:
    """Return (h, w, 2) px/s within a window of a picture."""
    x, y = plane_grid(pinhole, window)
    m = matrix.astype(np.float32)
    forward = m[2, 0] * x + m[2, 1] * y + m[2, 2] + m[2, 3] * inverse_depth  # per unit of depth
    right = m[0, 0] * x + m[0, 1] * y + m[0, 2] + m[0, 3] * inverse_depth
    down = m[1, 0] * x + m[1, 1] * y + m[1, 2] + m[1, 3] * inverse_depth
    fx, fy = (np.float32(focal) for focal in pinhole.focal_px)
    return np.dstack([fx * (right - x * forward), fy * (down - y * forward)])
