"""Which topics of a bag carry the images of which camera."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from estimator.bag import Bag
from estimator.errors import InputError
from estimator.rig import Rig

_IMAGE_TYPES = {"": "sensor_msgs/msg/Image", "/compressed": "sensor_msgs/msg/CompressedImage"}
_IMAGE_TOPIC = re.compile(r"/(?P<camera>.+)/image_raw(?P<transport>|/compressed)")


@dataclass(frozen=True)
class CameraTopics:
    """Topics by camera, and cameras by topic.

    Attributes:
        images: By image topic, its camera.
        infos: By ``camera_info`` topic, its camera.
    """

    images: Mapping[str, str]
    infos: Mapping[str, str]


def find_camera_topics(bag: Bag, rig: Rig) -> CameraTopics:
    """Match the bag's cameras with the rig's; of a raw and a compressed topic of one camera the raw one wins.

    A camera whose topic was announced but never used was off all drive long: it is there, and silent.

    Raises:
        InputError: No image topics, a topic of a wrong type, or the bag's cameras are not the rig's.
    """
    by_camera: dict[str, str] = {}
    silent: dict[str, str] = {}
    for topic in sorted(bag.message_types, reverse=True):  # "…/compressed" first, so that raw replaces it
        match = _IMAGE_TOPIC.fullmatch(topic)
        if match is not None:
            _check_type(bag, topic, _IMAGE_TYPES[match["transport"]])
            found = by_camera if bag.message_counts.get(topic, 0) > 0 else silent
            found[match["camera"]] = topic
    if not by_camera:
        topics = ", ".join(sorted(bag.message_types)) or "none"
        raise InputError(f"{_state(bag)}no images, wanted some on /<camera>/image_raw; topics: {topics}")
    by_camera = silent | by_camera
    _check_cameras(bag, set(by_camera), rig)
    infos = {f"/{camera}/camera_info": camera for camera in rig.cameras}
    infos = {topic: camera for topic, camera in infos.items() if _is_info(bag, topic)}
    return CameraTopics({by_camera[camera]: camera for camera in rig.cameras}, infos)


def _state(bag: Bag) -> str:
    return f"{bag.break_reason}, and up to the break: " if bag.break_reason else ""


def _is_info(bag: Bag, topic: str) -> bool:
    return bag.message_types.get(topic) == "sensor_msgs/msg/CameraInfo"


def _check_type(bag: Bag, topic: str, wanted: str) -> None:
    got = bag.message_types[topic]
    if got != wanted:
        raise InputError(f"topic {topic}: got {got}, wanted {wanted}")


def _check_cameras(bag: Bag, in_bag: set[str], rig: Rig) -> None:
    lacking = [camera for camera in rig.cameras if camera not in in_bag]
    extra = sorted(in_bag - set(rig.cameras))
    if not lacking and not extra:
        return
    problems = []
    if lacking:
        problems.append(f"the rig's {', '.join(lacking)} not in the recording")
    if extra:
        problems.append(f"the recording's {', '.join(extra)} not in the rig")
    raise InputError(
        f"{_state(bag)}{'; '.join(problems)}; cameras of the recording: {', '.join(sorted(in_bag))}; "
        f"cameras of the rig: {rig.names_text}"
    )
