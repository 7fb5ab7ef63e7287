"""Watch whether the car moves at all, and whether the reference camera can tell how."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from estimator.bundle import FrameBundle, Image
from estimator.config import Config
from estimator.finding import Finding, FindingKind
from estimator.front_end import FrontEnd
from estimator.observations import Index
from estimator.ranges import PositiveCount, SizePx, TimeS


class MotionWatchConfig(Config):
    """When the car counts as standing, and how long it may stand or go unknown ways without a word."""

    still_px: SizePx = 0.3
    min_tracks: PositiveCount = 20
    standing_s: TimeS = 3.0
    unknown_s: TimeS = 10.0


class MotionWatch:
    """Remembers since when the car has stood, all images were the same, or nobody can tell how it moves."""

    def __init__(self, config: MotionWatchConfig) -> None:
        self._config = config
        self._still_since_ns: int | None = None
        self._same_since_ns: int | None = None
        self._unknown_since_ns: int | None = None
        self._stamp_ns = 0
        self._shift_px = 0.0
        self._ids: Index = np.zeros(0, np.int64)

    def see(self, bundle: FrameBundle, front_end: FrontEnd) -> None:
        """Take note of a bundle that the front end has followed."""
        self._stamp_ns = bundle.stamp_ns
        same = bool(bundle.images) and front_end.repeats.names == frozenset(bundle.images)
        same = same and any(_shows_something(image) for image in bundle.images.values())
        self._same_since_ns = self._since(self._same_since_ns, same)
        reference = front_end.trackers[front_end.rig.reference]
        if not reference.current:
            return
        tracks = reference.tracks
        followed = np.isin(tracks.ids, self._ids)  # the others began in this very image
        self._ids = tracks.ids
        moved = np.linalg.norm(tracks.pixels - tracks.previous_pixels, axis=1)[followed]
        self._shift_px = float(np.median(moved)) if len(moved) else 0.0
        still = len(moved) >= self._config.min_tracks and self._shift_px < self._config.still_px
        self._still_since_ns = self._since(self._still_since_ns, still)
        self._unknown_since_ns = self._since(self._unknown_since_ns, not still and not front_end.metric)

    def _since(self, since_ns: int | None, is_so: bool) -> int | None:
        if not is_so:
            return None
        return self._stamp_ns if since_ns is None else since_ns

    def findings(self, reference: str) -> Iterator[Finding]:
        """Yield what lasts."""
        still_s, unknown_s = self._seconds(self._still_since_ns), self._seconds(self._unknown_since_ns)
        same_s = self._seconds(self._same_since_ns)
        if same_s >= self._config.standing_s:
            about = (
                f"for {same_s:.0f} s all cameras have repeated their images to the byte: the car stands, or "
                "every camera hangs, or what records them; nothing can be learnt meanwhile"
            )
            yield Finding(FindingKind.NO_MOTION, (reference,), about, doubtful=False)
        elif still_s >= self._config.standing_s:
            about = (
                f"the car has stood still for {still_s:.0f} s: {reference} moves by {self._shift_px:.2f} px "
                "an image; a standing car teaches nothing"
            )
            yield Finding(FindingKind.NO_MOTION, (reference,), about, doubtful=False)
        elif unknown_s >= self._config.unknown_s:
            about = (
                f"for {unknown_s:.0f} s the images of {reference} have not shown how the car moves, so "
                "nothing can be calibrated"
            )
            yield Finding(FindingKind.UNEXPLAINED_IMAGES, (reference,), about, doubtful=False)

    def _seconds(self, since_ns: int | None) -> float:
        return 0.0 if since_ns is None else (self._stamp_ns - since_ns) * 1e-9


def _shows_something(image: Image) -> bool:
    return bool(image.min() < image.max())
