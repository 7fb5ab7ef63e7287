"""Snapshots as ROS 2 messages: images, camera info, and the truth."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any

import numpy as np
from rosbags.typesys import Stores, get_typestore

from estimator.bundle import Image
from estimator.camera import Camera, CameraModel
from estimator.se3 import SE3
from sim.faults.fault import Fault
from sim.world import Truth

TYPES = get_typestore(Stores.ROS2_HUMBLE)
_T = TYPES.types
_ERROR = _T["diagnostic_msgs/msg/DiagnosticStatus"].ERROR
_INFO_MODEL: dict[CameraModel, str] = {
    "pinhole": "plumb_bob",
    "brown_conrady": "plumb_bob",
    "kannala_brandt": "equidistant",
}


def serialize(message: Any) -> bytes:
    """Return a message's CDR bytes."""
    return bytes(TYPES.serialize_cdr(message, message.__msgtype__))


def image(pixels: Image, stamp_ns: int, camera: str) -> Any:
    """Return a ``mono8`` sensor_msgs/Image of (H, W) pixels."""
    height, width = pixels.shape
    return _T["sensor_msgs/msg/Image"](
        header=header(stamp_ns, camera),
        height=height,
        width=width,
        encoding="mono8",
        is_bigendian=0,
        step=width,
        data=np.ascontiguousarray(pixels).reshape(-1),
    )


def camera_info(camera: Camera, stamp_ns: int, name: str) -> Any:
    """Return the sensor_msgs/CameraInfo of a camera; a pinhole has five zero coefficients."""
    (fx, fy), (cx, cy) = camera.focal_px, camera.center_px
    return _T["sensor_msgs/msg/CameraInfo"](
        header=header(stamp_ns, name),
        height=camera.size_px[1],
        width=camera.size_px[0],
        distortion_model=_INFO_MODEL[camera.model],
        d=np.array(camera.distortion or (0.0,) * 5),
        k=np.array([fx, 0, cx, 0, fy, cy, 0, 0, 1.0]),
        r=np.eye(3).reshape(-1),
        p=np.array([fx, 0, cx, 0, 0, fy, cy, 0, 0, 0, 1.0, 0]),
        binning_x=0,
        binning_y=0,
        roi=_T["sensor_msgs/msg/RegionOfInterest"](0, 0, 0, 0, False),
    )


def odometry(truth: Truth) -> Any:
    """Return the nav_msgs/Odometry from ``world`` to ``ego``; the twist is in the ego frame."""
    pose, no_covariance = truth.world_from_ego, np.zeros(36)
    position = _T["geometry_msgs/msg/Point"](*map(float, pose.translation))
    angular, linear = (vector(part) for part in np.split(truth.velocity_ego, 2))
    return _T["nav_msgs/msg/Odometry"](
        header=header(truth.stamp_ns, "world"),
        child_frame_id="ego",
        pose=_T["geometry_msgs/msg/PoseWithCovariance"](
            _T["geometry_msgs/msg/Pose"](position, _quaternion(pose)), no_covariance
        ),
        twist=_T["geometry_msgs/msg/TwistWithCovariance"](
            _T["geometry_msgs/msg/Twist"](linear, angular), no_covariance
        ),
    )


def extrinsics(truth: Truth) -> Any:
    """Return the tf2_msgs/TFMessage from ``ego`` to every camera."""
    transforms = [
        _T["geometry_msgs/msg/TransformStamped"](
            header(truth.stamp_ns, "ego"),
            name,
            _T["geometry_msgs/msg/Transform"](vector(pose.translation), _quaternion(pose)),
        )
        for name, pose in truth.ego_from_cams.items()
    ]
    return _T["tf2_msgs/msg/TFMessage"](transforms)


def faults(lasting: Sequence[Fault], stamp_ns: int) -> Any:
    """Return the diagnostic_msgs/DiagnosticArray of all faults that are there, one entry each."""
    states = [
        _T["diagnostic_msgs/msg/DiagnosticStatus"](
            level=_ERROR,
            name=fault.kind,
            message=f"{fault.kind}: {', '.join(fault.names)}",
            hardware_id=",".join(fault.names),
            values=[
                _T["diagnostic_msgs/msg/KeyValue"](key, json.dumps(value))
                for key, value in fault.model_dump(exclude={"kind", "camera"}).items()
            ],
        )
        for fault in lasting
    ]
    return _T["diagnostic_msgs/msg/DiagnosticArray"](header(stamp_ns, ""), states)


def header(stamp_ns: int, frame: str) -> Any:
    """Return a std_msgs/Header."""
    stamp = _T["builtin_interfaces/msg/Time"](*divmod(stamp_ns, 1_000_000_000))
    return _T["std_msgs/msg/Header"](stamp, frame)


def vector(values: np.ndarray[Any, np.dtype[np.float64]]) -> Any:
    """Return a geometry_msgs/Vector3."""
    return _T["geometry_msgs/msg/Vector3"](*map(float, values))


def _quaternion(pose: SE3) -> Any:
    return _T["geometry_msgs/msg/Quaternion"](*map(float, pose.quaternion_xyzw))
