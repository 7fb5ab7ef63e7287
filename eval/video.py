"""A recording as a film for people: all cameras side by side, with time and speed."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np

from estimator.bag import Bag
from estimator.bag_message import BagMessage
from estimator.bag_rosbags import parse
from estimator.bundle import Image
from estimator.errors import InputError
from estimator.image_decode import decode_image
from estimator.rig import Rig
from eval.console import Console
from eval.mosaic import Mosaic, Picture, rows_of

_ODOMETRY = "/truth/odometry"
_QUALITY = "23"  # x264's constant rate factor
_KMH_PER_MPS = 3.6


def write_video(bag: Path, rig: Rig, rate_hz: float, file: Path, title: str, console: Console) -> None:
    """Write an MP4 (H.264) that plays a simulated recording in real time.

    Args:
        bag: With truth, as the simulator records it.
        rig: Its cameras and where they look.
        rate_hz: Bundles a second.
        file: What to write; it holds a whole film or an error is raised.
        title: Shown in every picture.
        console: Told how far it is.
    """
    import av  # takes a while to load, and only films need it

    mosaic = Mosaic(rows_of(rig))
    with av.open(str(file), "w", format="mp4", options={"movflags": "+faststart"}) as container:
        stream = container.add_stream("libx264", rate=Fraction(rate_hz).limit_denominator(1000))
        stream.width, stream.height = mosaic.size_px
        stream.pix_fmt = "yuv420p"  # what every player knows
        stream.options = {"crf": _QUALITY, "preset": "veryfast"}
        for picture in pictures(bag, mosaic, rig, title, console):
            container.mux(stream.encode(av.VideoFrame.from_ndarray(picture, format="bgr24")))
        container.mux(stream.encode())


def pictures(bag: Path, mosaic: Mosaic, rig: Rig, title: str, console: Console) -> Iterator[Picture]:
    """Yield a picture for every truth of a recording, of the images that had arrived by then."""
    topics = {f"/{name}/image_raw": name for name in rig.cameras}
    shown: dict[str, Image] = {}
    fresh: set[str] = set()
    with Bag(bag) as source:
        total = source.message_counts.get(_ODOMETRY, 0)
        if not total:
            raise InputError(f"{bag}: has no truth, wanted a simulated recording")
        first_ns: int | None = None
        done = 0
        for message in source.messages([*topics, _ODOMETRY]):
            if message.topic in topics:
                name = topics[message.topic]
                shown[name] = decode_image(parse(message))
                fresh.add(name)
                continue
            first_ns = message.header_stamp_ns if first_ns is None else first_ns
            time_s = (message.header_stamp_ns - first_ns) / 1e9
            yield mosaic.compose(
                shown,
                frozenset(shown) - fresh,
                f"{title}   {time_s:6.2f} s   {_speed_kmh(message):5.1f} km/h",
            )
            fresh.clear()
            done += 1
            console.progress("filming", done, total)


def _speed_kmh(odometry: BagMessage) -> float:
    linear = parse(odometry).twist.twist.linear
    return _KMH_PER_MPS * float(np.hypot(linear.x, linear.y))
