"""An open ROS 2 bag being written: topics for every camera's image and info, and for the truth."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer

from estimator.rig import Rig
from estimator.se3 import SE3
from sim.channels.messages import channel_messages, channel_topics
from sim.channels.names import TruthChannel
from sim.faults.fault import Fault
from sim.frame import Frame
from sim.inertial_messages import INERTIAL_TOPICS, InertialTopics
from sim.messages import TYPES, camera_info, extrinsics, faults, image, odometry, serialize
from sim.outbox import Outbox
from sim.vehicle.inertial import InertialConfig
from sim.world import Snapshot, Truth

_SAME_POSE = 1e-9  # rad and m: rounding, not movement


class BagWriter:
    """Writes snapshots with MCAP storage; leaving the block by an exception leaves an unfinished bag."""

    def __init__(
        self,
        path: Path,
        rig: Rig,
        inertial: InertialConfig | None = None,
        truth: Collection[TruthChannel] = (),
    ) -> None:
        """Create the bag; ``inertial`` says which sensors besides cameras there are, None: none."""
        self._rig, self._inertial = rig, None if inertial is None else InertialTopics(inertial)
        self._sent: Mapping[str, SE3] = {}
        self._told: tuple[Fault, ...] = ()
        self._labelled = False
        self._outbox: Outbox[tuple[str, bytes]] = Outbox(self._send)
        self._writer = Writer(path, version=9, storage_plugin=StoragePlugin.MCAP)
        self._writer.set_compression(CompressionMode.STORAGE, CompressionFormat.ZSTD)
        self._writer.open()
        more = {} if inertial is None else INERTIAL_TOPICS
        self._connections = {
            topic: self._writer.add_connection(topic, message_type, typestore=TYPES)
            for topic, message_type in (*_topics(rig), *more.items(), *channel_topics(rig.cameras, truth))
        }

    def write(self, snapshot: Snapshot) -> None:
        """Take in what was exposed at one instant; messages go into the bag as they arrive."""
        truth = snapshot.truth
        for frame in snapshot.frames:
            self._post_frame(frame)
        if self._inertial is not None:
            for topic, arrival_ns, message in self._inertial.messages(snapshot.samples, truth.stamp_ns):
                self._post(topic, arrival_ns, message)
        self._post("/truth/odometry", truth.stamp_ns, odometry(truth))
        if self._has_moved(truth):
            self._post("/truth/extrinsics", truth.stamp_ns, extrinsics(truth))
            self._sent = truth.ego_from_cams
        if snapshot.faults != self._told:
            self._post("/truth/faults", truth.stamp_ns, faults(snapshot.faults, truth.stamp_ns))
            self._told = snapshot.faults
        self._post_channels(snapshot)
        self._outbox.deliver(until_ns=truth.stamp_ns)

    def _post_channels(self, snapshot: Snapshot) -> None:
        channels, stamp_ns = snapshot.channels, snapshot.truth.stamp_ns
        if channels is None:
            return
        for topic, message in channel_messages(channels, stamp_ns, with_labels=not self._labelled):
            self._post(topic, stamp_ns, message)
        self._labelled = True

    def _post_frame(self, frame: Frame) -> None:
        name, stamp_ns, arrival_ns = frame.camera, frame.stamp_ns, frame.arrival_ns
        self._post(f"/{name}/image_raw", arrival_ns, image(frame.image, stamp_ns, name))
        info = camera_info(self._rig[name].camera, stamp_ns, name)
        self._post(f"/{name}/camera_info", arrival_ns, info)

    def _has_moved(self, truth: Truth) -> bool:
        return any(
            name not in self._sent or np.abs(self._sent[name].local(pose)).max() > _SAME_POSE
            for name, pose in truth.ego_from_cams.items()
        )

    def _post(self, topic: str, arrival_ns: int, message: Any) -> None:
        self._outbox.post(arrival_ns, (topic, serialize(message)))

    def _send(self, arrival_ns: int, addressed: tuple[str, bytes]) -> None:
        topic, message = addressed
        self._writer.write(self._connections[topic], arrival_ns, message)

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if kind is None:
            self._outbox.deliver()
        self._writer.__exit__(kind, error, trace)


def _topics(rig: Rig) -> Iterator[tuple[str, str]]:
    for name in rig.cameras:
        yield f"/{name}/image_raw", "sensor_msgs/msg/Image"
        yield f"/{name}/camera_info", "sensor_msgs/msg/CameraInfo"
    yield "/truth/odometry", "nav_msgs/msg/Odometry"
    yield "/truth/extrinsics", "tf2_msgs/msg/TFMessage"
    yield "/truth/faults", "diagnostic_msgs/msg/DiagnosticArray"
