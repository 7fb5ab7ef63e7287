"""Truth channels as ROS 2 messages under ``/truth/``."""

from __future__ import annotations

import json
from collections.abc import Collection, Iterator
from typing import Any

import numpy as np
import numpy.typing as npt

from sim.channels.channels import Channels
from sim.channels.labels import CLASSES
from sim.channels.names import TruthChannel
from sim.messages import TYPES

_T = TYPES.types
_IMAGE, _TEXT = "sensor_msgs/msg/Image", "std_msgs/msg/String"


def channel_topics(cameras: Collection[str], wanted: Collection[TruthChannel]) -> Iterator[tuple[str, str]]:
    """Yield topic and message type of everything that ``channel_messages`` may yield."""
    kinds = {"depth": ("depth",), "segmentation": ("class", "instance"), "optical_flow": ("optical_flow",)}
    for channel in dict.fromkeys(wanted):
        for kind in kinds.get(channel, ()):
            for name in cameras:
                yield f"/truth/{name}/{kind}", _IMAGE
    if "segmentation" in wanted:
        yield "/truth/labels", _TEXT
    if "visibility" in wanted:
        yield "/truth/visibility", _TEXT


def channel_messages(
    channels: Channels, stamp_ns: int, with_labels: bool = False
) -> Iterator[tuple[str, Any]]:
    """Yield topic and message of each channel of a bundle, and what its numbers mean if asked for."""
    if with_labels and channels.classes:
        names = {"classes": CLASSES, "instances": channels.labels.instance_names}
        yield "/truth/labels", _T[_TEXT](json.dumps(names))
    for name, range_m in channels.range_m.items():
        yield f"/truth/{name}/depth", _image(range_m, "32FC1", stamp_ns, name)
    for name, classes in channels.classes.items():
        yield f"/truth/{name}/class", _image(classes, "mono8", stamp_ns, name)
    for name, instances in channels.instances.items():
        yield f"/truth/{name}/instance", _image(instances, "16UC1", stamp_ns, name)
    for name, flow in channels.flow_px.items():
        yield f"/truth/{name}/optical_flow", _image(flow, "32FC2", stamp_ns, name)
    if channels.visibility:
        yield "/truth/visibility", _T[_TEXT](json.dumps(channels.visibility))


def _image(values: npt.NDArray[Any], encoding: str, stamp_ns: int, camera: str) -> Any:
    height, width = values.shape[:2]
    stamp = _T["builtin_interfaces/msg/Time"](*divmod(stamp_ns, 1_000_000_000))
    return _T[_IMAGE](
        header=_T["std_msgs/msg/Header"](stamp, camera),
        height=height,
        width=width,
        encoding=encoding,
        is_bigendian=0,
        step=values[0].nbytes,
        data=np.frombuffer(np.ascontiguousarray(values).tobytes(), np.uint8),
    )
