"""The frames of one forward camera: from a folder of images, or a metre apart from a recording."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np

from estimator.bag import Bag
from estimator.bag_rosbags import parse
from estimator.bundle import Image
from estimator.errors import InputError
from estimator.image_decode import decode_compressed, decode_image
from eval.truth import read_truth

LEAST_FRAMES = 12
_SLACK = 0.05  # of the spacing: nearly there is there
_SUFFIXES = (".png", ".jpg", ".jpeg")


@dataclass(frozen=True)
class Cut:
    """What of each frame counts.

    Attributes:
        scale: Frames are resized by this first, to bring another focal length to that of the real drives.
        rows: First row, and the row after the last; without sky and the car's own bonnet.
        step: Every how manieth frame of a folder is used.
    """

    scale: float
    rows: tuple[int, int]
    step: int = 1


def read_frames(path: Path, camera: str, spacing_m: float, cut: Cut) -> list[Image]:
    """Return the grey frames of a folder in the order of their names, or of a recording ``spacing_m`` apart.

    Raises:
        InputError: Nothing there, too few frames, or rows that the frames do not have.
    """
    if not path.exists():
        raise InputError(f"{path}: no such folder; wanted frames of one forward camera, or a recording")
    files = (
        sorted(each for each in path.iterdir() if each.suffix.lower() in _SUFFIXES) if path.is_dir() else []
    )
    if path.is_dir() and not any(path.iterdir()):
        raise InputError(f"{path}: got an empty folder, wanted frames of one forward camera, or a recording")
    images = _of_files(files[:: cut.step]) if files else _of_bag(path, camera, spacing_m)
    frames: list[Image] = []
    shapes: set[tuple[int, ...]] = set()
    for image in images:
        shapes.add(image.shape)
        if len(shapes) > 1:
            raise InputError(f"{path}: got frames of several sizes, wanted those of one camera")
        frames.append(_cut(image, cut, path))
    if len(frames) < LEAST_FRAMES:
        raise InputError(f"{path}: got {len(frames)} frames, wanted at least {LEAST_FRAMES}")
    return frames


def _of_files(files: list[Path]) -> Iterator[Image]:
    for file in files:
        image = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
        if image is None:
            raise InputError(f"{file}: cannot be read as an image")
        yield np.asarray(image, np.uint8)


def _of_bag(path: Path, camera: str, spacing_m: float) -> Iterator[Image]:
    """Yield images whenever the car has come ``spacing_m`` further, by the truth; all where there is none."""
    truth = read_truth(path)
    if truth is not None:
        path_m = np.array([pose.translation for pose in truth.world_from_ego])
        driven_m = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(path_m, axis=0), axis=1))]
    due_m = 0.0
    with Bag(path) as bag:
        topics = [f"/{camera}/image_raw", f"/{camera}/image_raw/compressed"]
        there = [topic for topic in topics if bag.message_counts.get(topic)]
        if not there:
            raise InputError(
                f"{path}: no images of camera {camera!r}; topics: {', '.join(bag.message_types)}"
            )
        for message in bag.messages(there[:1]):
            if truth is not None:
                at_m = float(np.interp(message.header_stamp_ns, truth.stamps_ns, driven_m))
                if at_m < due_m - _SLACK * spacing_m:
                    continue
                due_m += spacing_m * np.ceil((at_m - due_m) / spacing_m + 0.5)
            decode = decode_compressed if message.topic.endswith("/compressed") else decode_image
            yield decode(parse(message))


def _cut(image: Image, cut: Cut, path: Path) -> Image:
    if cut.scale != 1.0:
        image = np.asarray(cv2.resize(image, None, fx=cut.scale, fy=cut.scale, interpolation=cv2.INTER_AREA))
    first, end = cut.rows
    if end > len(image):
        raise InputError(f"{path}: got frames of {len(image)} rows, wanted rows {first}:{end} (see --rows)")
    return image[first:end]
