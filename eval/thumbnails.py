"""Small copies of images, and the few instants of a drive worth showing, in bounded memory."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass

import cv2
import numpy as np

from estimator.bundle import FrameBundle, Image
from estimator.se3 import Array

_WIDTH_PX = 480
_MATCH_TOLERANCE_PX = 1e-3


@dataclass(frozen=True, eq=False)
class Thumbnail:
    """A reduced image that remembers its full size, so that pixels can be drawn in full coordinates."""

    image: Image
    full_size_px: tuple[int, int]


def thumbnail(image: Image) -> Thumbnail:
    """Reduce an image to at most 480 px of width, by area, and copy it."""
    height, width = image.shape[:2]
    factor = min(1.0, _WIDTH_PX / width)
    size = max(1, round(width * factor)), max(1, round(height * factor))
    small = image.copy() if factor == 1.0 else cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    return Thumbnail(np.asarray(small, np.uint8), (width, height))


@dataclass(frozen=True, eq=False)
class Moment:
    """All cameras at one instant, with the tails of the tracks then alive.

    Attributes:
        stamp_ns: Of the bundle.
        thumbnails: By camera.
        tails_px: By camera, polylines (M, 2) in full pixels, oldest point first.
    """

    stamp_ns: int
    thumbnails: Mapping[str, Thumbnail]
    tails_px: Mapping[str, tuple[Array, ...]]


class TailHistory:
    """Joins the two-point tracks of successive updates into short tails."""

    def __init__(self, length: int = 5) -> None:
        self._steps: deque[Mapping[str, Array]] = deque(maxlen=length)

    def add(self, tracks_px: Mapping[str, Array]) -> None:
        """Take the (N, 4) tracks of one update; those that are not finite lie nowhere."""
        rows = {name: np.asarray(track, float).reshape(-1, 4) for name, track in tracks_px.items()}
        self._steps.append({name: row[np.isfinite(row).all(axis=1)] for name, row in rows.items()})

    def tails(self, camera: str) -> tuple[Array, ...]:
        """Return the tails of the newest tracks of a camera, as long as their history connects."""
        steps = [step.get(camera, np.zeros((0, 4))) for step in reversed(self._steps)]
        if not steps:
            return ()
        indices = [{_key(row[2:]): row for row in step} for step in steps[1:]]
        return tuple(_chain(row, indices) for row in steps[0])


def _key(pixel: Array) -> tuple[int, int]:
    return round(float(pixel[0]) / _MATCH_TOLERANCE_PX), round(float(pixel[1]) / _MATCH_TOLERANCE_PX)


def _chain(newest: Array, indices: list[dict[tuple[int, int], Array]]) -> Array:
    points = [newest[2:], newest[:2]]
    for index in indices:
        row = index.get(_key(points[-1]))
        if row is None:
            break
        points.append(row[:2])
    return np.array(points[::-1])


class MomentKeeper:
    """Keeps a few moments, spread evenly over a drive of unknown length.

    When full it forgets every second one and doubles its stride.
    """

    def __init__(self, capacity: int = 6) -> None:
        self._capacity = capacity
        self._stride = 1
        self._seen = 0
        self.moments: list[Moment] = []

    def offer(self, bundle: FrameBundle, thumbnails: Mapping[str, Thumbnail], history: TailHistory) -> None:
        if self._seen % self._stride == 0:
            if len(self.moments) == self._capacity:
                self.moments = self.moments[::2]
                self._stride *= 2
            if self._seen % self._stride == 0:
                tails = {name: history.tails(name) for name in bundle.images}
                self.moments.append(Moment(bundle.stamp_ns, thumbnails, tails))
        self._seen += 1
