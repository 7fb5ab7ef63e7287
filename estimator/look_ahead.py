"""A look at the first seconds of a recording: does it fit the rig, and how fast do images come?"""

from __future__ import annotations

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.bundling import period_ns
from estimator.camera_image import read_image
from estimator.camera_info import camera_info_disagreement
from estimator.camera_topics import CameraTopics
from estimator.errors import InputError
from estimator.rig import Rig

_WANTED_STAMPS = 8
_MOST_IMAGES = 60  # of each camera: the look ahead ends here whatever is still missing
_FALLBACK_PERIOD_NS = 1e8  # where no camera gave two images, so that it hardly matters


def look_ahead(bag: Bag, topics: CameraTopics, rig: Rig) -> tuple[float, list[str]]:
    """Check the first image and the first ``camera_info`` of every camera.

    Returns:
        The time between images of the reference camera in ns, and a warning for each camera whose
        ``camera_info`` is not what the rig says.

    Raises:
        InputError: A first image that cannot be decoded or is not of the size the rig states.
    """
    stamps_ns: dict[str, list[int]] = {camera: [] for camera in rig.cameras}
    infos = dict(topics.infos)
    warnings: list[str] = []
    image_count = 0
    for message in bag.messages([*topics.images, *infos]):
        if message.topic in topics.images:
            camera = topics.images[message.topic]
            if not stamps_ns[camera]:
                read_image(message, rig[camera].camera)
            stamps_ns[camera].append(message.header_stamp_ns)
            image_count += 1
        elif message.topic in infos:
            camera = infos.pop(message.topic)
            if difference := camera_info_disagreement(parse(message), rig[camera].camera):
                warnings.append(f"camera {camera!r}: camera_info says {difference}; the rig file is used")
        enough = len(stamps_ns[rig.reference]) >= _WANTED_STAMPS and all(stamps_ns.values()) and not infos
        if enough or image_count >= _MOST_IMAGES * len(stamps_ns):
            break
    if image_count == 0:
        raise InputError(f"{bag.break_reason or 'damaged'}, and no image can be read")
    periods = (period_ns(each) for each in (stamps_ns[rig.reference], *stamps_ns.values()))
    return next((each for each in periods if each), _FALLBACK_PERIOD_NS), warnings
