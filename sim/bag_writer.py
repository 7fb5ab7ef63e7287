"""An open ROS 2 bag being written: topics for every camera's image and info, and for the truth."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import Self

import numpy as np
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer

from estimator.rig import Rig
from estimator.se3 import SE3
from sim.messages import TYPES, camera_info, extrinsics, image, odometry, serialize
from sim.world import Snapshot, Truth

_SAME_POSE = 1e-9  # rad and m: rounding, not movement


class BagWriter:
    """Writes snapshots with MCAP storage; leaving the block by an exception leaves an unfinished bag."""

    def __init__(self, path: Path, rig: Rig) -> None:
        self._rig = rig
        self._sent: Mapping[str, SE3] = {}
        self._writer = Writer(path, version=9, storage_plugin=StoragePlugin.MCAP)
        self._writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
        self._writer.open()
        self._connections = {
            topic: self._writer.add_connection(topic, message_type, typestore=TYPES)
            for topic, message_type in _topics(rig)
        }

    def write(self, snapshot: Snapshot) -> None:
        """Append one bundle and its truth."""
        stamp_ns = snapshot.bundle.stamp_ns
        for name, pixels in snapshot.bundle.images.items():
            self._send(f"/{name}/image_raw", stamp_ns, serialize(image(pixels, stamp_ns, name)))
            info = camera_info(self._rig[name].camera, stamp_ns, name)
            self._send(f"/{name}/camera_info", stamp_ns, serialize(info))
        self._send("/truth/odometry", stamp_ns, serialize(odometry(snapshot.truth)))
        if self._has_moved(snapshot.truth):
            self._send("/truth/extrinsics", stamp_ns, serialize(extrinsics(snapshot.truth)))
            self._sent = snapshot.truth.ego_from_cams

    def _has_moved(self, truth: Truth) -> bool:
        return any(
            name not in self._sent or np.abs(self._sent[name].local(pose)).max() > _SAME_POSE
            for name, pose in truth.ego_from_cams.items()
        )

    def _send(self, topic: str, stamp_ns: int, message: bytes) -> None:
        self._writer.write(self._connections[topic], stamp_ns, message)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._writer.__exit__(kind, error, trace)


def _topics(rig: Rig) -> Iterator[tuple[str, str]]:
    for name in rig.cameras:
        yield f"/{name}/image_raw", "sensor_msgs/msg/Image"
        yield f"/{name}/camera_info", "sensor_msgs/msg/CameraInfo"
    yield "/truth/odometry", "nav_msgs/msg/Odometry"
    yield "/truth/extrinsics", "tf2_msgs/msg/TFMessage"
