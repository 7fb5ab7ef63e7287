"""ROS 2 messages for the bags of tests."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np
from rosbags.typesys import Stores, get_typestore

from estimator.camera import Camera
from estimator.se3 import SE3

TYPES = get_typestore(Stores.ROS2_JAZZY)
NS = 1_000_000_000


@dataclass(frozen=True)
class Frame:
    """One image: whose, when by its header, its pixels, and when by the log (if not at its stamp)."""

    camera: str
    stamp_ns: int
    pixels: np.ndarray
    log_ns: int | None = None


def image_message(frame: Frame, encoding: str = "mono8", padding: int = 0, big_endian: bool = False) -> Any:
    """Return a sensor_msgs/Image, whose rows are ``padding`` bytes longer than they need be."""
    height = frame.pixels.shape[0]
    rows = np.ascontiguousarray(frame.pixels).view(np.uint8).reshape(height, -1)
    rows = np.pad(rows, ((0, 0), (0, padding)), constant_values=7)
    width, step = frame.pixels.shape[1], rows.shape[1]
    kind = TYPES.types["sensor_msgs/msg/Image"]
    return kind(header(frame), height, width, encoding, int(big_endian), step, rows.reshape(-1))


def compressed_message(frame: Frame, suffix: str = ".png") -> Any:
    """Return a sensor_msgs/CompressedImage."""
    data = cv2.imencode(suffix, frame.pixels)[1].reshape(-1)
    return TYPES.types["sensor_msgs/msg/CompressedImage"](header(frame), suffix.removeprefix("."), data)


def info_message(frame: Frame, camera: Camera, focal_px: float | None = None) -> Any:
    """Return the CameraInfo of a pinhole camera, or one that claims another focal length."""
    fx, fy = (focal_px, focal_px) if focal_px else camera.focal_px
    k = np.array([fx, 0, camera.center_px[0], 0, fy, camera.center_px[1], 0, 0, 1])
    region = TYPES.types["sensor_msgs/msg/RegionOfInterest"](0, 0, 0, 0, False)
    kind = TYPES.types["sensor_msgs/msg/CameraInfo"]
    width, height = camera.size_px
    p = np.zeros(12)
    return kind(header(frame), height, width, "plumb_bob", np.zeros(5), k, np.eye(3).ravel(), p, 0, 0, region)


def header(frame: Frame) -> Any:
    time = TYPES.types["builtin_interfaces/msg/Time"](frame.stamp_ns // NS, frame.stamp_ns % NS)
    return TYPES.types["std_msgs/msg/Header"](time, frame.camera)


def extrinsics_message(ego_from_cams: Mapping[str, SE3], stamp_ns: int) -> Any:
    stamped = TYPES.types["geometry_msgs/msg/TransformStamped"]
    transform = TYPES.types["geometry_msgs/msg/Transform"]
    ego = header(Frame("ego", stamp_ns, np.zeros(0)))
    return TYPES.types["tf2_msgs/msg/TFMessage"](
        [
            stamped(ego, name, transform(_vector(pose), _quaternion(pose)))
            for name, pose in ego_from_cams.items()
        ]
    )


def odometry_message(world_from_ego: SE3, stamp_ns: int) -> Any:
    named = TYPES.types
    point = named["geometry_msgs/msg/Point"](*map(float, world_from_ego.translation))
    pose = named["geometry_msgs/msg/Pose"](point, _quaternion(world_from_ego))
    zero = named["geometry_msgs/msg/Vector3"](0.0, 0.0, 0.0)
    twist = named["geometry_msgs/msg/TwistWithCovariance"](
        named["geometry_msgs/msg/Twist"](zero, zero), np.zeros(36)
    )
    world = header(Frame("world", stamp_ns, np.zeros(0)))
    with_covariance = named["geometry_msgs/msg/PoseWithCovariance"](pose, np.zeros(36))
    return named["nav_msgs/msg/Odometry"](world, "ego", with_covariance, twist)


def _vector(pose: SE3) -> Any:
    return TYPES.types["geometry_msgs/msg/Vector3"](*map(float, pose.translation))


def _quaternion(pose: SE3) -> Any:
    return TYPES.types["geometry_msgs/msg/Quaternion"](*map(float, pose.quaternion_xyzw))
