"""Small ROS 2 bags for tests: a few frames of noise images, in every variety a recording may come in.

Written by ``rosbags`` alone, not by the recorder of ``sim``: reader and recorder cannot share a mistake.
The messages are made in ``tests.bag_messages``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer

from estimator.camera import Camera
from estimator.rig import MountedCamera, Rig
from estimator.se3 import SE3
from tests.bag_messages import (
    NS,
    TYPES,
    Frame,
    compressed_message,
    extrinsics_message,
    image_message,
    odometry_message,
)

OPTICAL = SE3.from_quaternion_xyzw(np.array([-0.5, 0.5, -0.5, 0.5]), np.array([1.8, 0.1, 1.45]))


def small_rig(sizes_px: Mapping[str, tuple[int, int]] | None = None) -> Rig:
    """Return a rig of pinhole cameras, the first one the reference."""
    sizes_px = sizes_px or {"front": (48, 32), "left": (40, 24), "rear": (48, 32)}
    cameras = {
        name: MountedCamera(
            Camera("pinhole", size, (float(size[0]), float(size[0])), (size[0] / 2 - 0.5, size[1] / 2 - 0.5)),
            OPTICAL,
        )
        for name, size in sizes_px.items()
    }
    return Rig(next(iter(cameras)), cameras)


def frames_of(
    rig: Rig,
    *,
    count: int = 6,
    rate_hz: float = 10.0,
    start_ns: int = NS,
    jitter_ns: int = 0,
    skip: Callable[[str, int], bool] = lambda camera, index: False,
    seed: int = 0,
) -> list[Frame]:
    """Return noise images of all cameras, bundle by bundle; ``skip(camera, index)`` leaves one out."""
    rng = np.random.default_rng(seed)
    frames = []
    for index in range(count):
        for name, mounted in rig.cameras.items():
            width, height = mounted.camera.size_px
            pixels = rng.integers(0, 256, (height, width), np.uint8)
            offset_ns = int(rng.integers(-jitter_ns, jitter_ns + 1))
            if not skip(name, index):
                frames.append(Frame(name, start_ns + round(index * NS / rate_hz) + offset_ns, pixels))
    return frames


@dataclass
class Entry:
    """A message on its way into a bag."""

    topic: str
    message: Any
    log_ns: int


def raw_entries(frames: Sequence[Frame], encoding: str = "mono8", **options: Any) -> list[Entry]:
    """Return the frames as messages on ``/<camera>/image_raw``."""
    return [
        Entry(f"/{frame.camera}/image_raw", image_message(frame, encoding, **options), _log_ns(frame))
        for frame in frames
    ]


def compressed_entries(frames: Sequence[Frame], suffix: str = ".png") -> list[Entry]:
    """Return the frames as messages on ``/<camera>/image_raw/compressed``."""
    return [
        Entry(f"/{frame.camera}/image_raw/compressed", compressed_message(frame, suffix), _log_ns(frame))
        for frame in frames
    ]


def truth_entries(
    ego_from_cams: Mapping[str, SE3], stamps_ns: Sequence[int], speed_mps: float = 5.0
) -> list[Entry]:
    """Return the truth of a car that drives straight along x, its extrinsics sent once at the start."""
    entries = [Entry("/truth/extrinsics", extrinsics_message(ego_from_cams, stamps_ns[0]), stamps_ns[0])]
    for stamp_ns in stamps_ns:
        x_m = speed_mps * (stamp_ns - stamps_ns[0]) / NS
        message = odometry_message(SE3(np.eye(3), np.array([x_m, 0.0, 0.0])), stamp_ns)
        entries.append(Entry("/truth/odometry", message, stamp_ns))
    return entries


def write_bag(
    folder: Path,
    entries: Sequence[Entry],
    *,
    storage: str = "mcap",
    compression: CompressionMode = CompressionMode.STORAGE,
) -> Path:
    """Write messages in the order given; topics are made in the order in which they first come."""
    plugin = StoragePlugin.MCAP if storage == "mcap" else StoragePlugin.SQLITE3
    writer = Writer(folder, version=9, storage_plugin=plugin)
    if storage == "mcap" and compression is not CompressionMode.NONE:
        writer.set_compression(compression, CompressionFormat.ZSTD)
    with writer:
        connections: dict[str, Any] = {}
        for entry in entries:
            kind = entry.message.__msgtype__
            if entry.topic not in connections:
                connections[entry.topic] = writer.add_connection(entry.topic, kind, typestore=TYPES)
            writer.write(connections[entry.topic], entry.log_ns, TYPES.serialize_cdr(entry.message, kind))
    return folder


def cut(bag: Path, folder: Path, share: float, *, keep_metadata: bool = False) -> Path:
    """Copy the first share of a bag's bytes, as a recorder that died leaves it."""
    folder.mkdir()
    for file in bag.glob("*.mcap"):
        data = file.read_bytes()
        (folder / file.name).write_bytes(data[: int(len(data) * share)])
    if keep_metadata:
        (folder / "metadata.yaml").write_bytes((bag / "metadata.yaml").read_bytes())
    return folder


def _log_ns(frame: Frame) -> int:
    return frame.stamp_ns if frame.log_ns is None else frame.log_ns
