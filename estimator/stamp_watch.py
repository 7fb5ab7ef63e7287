"""Watch whether the cameras' stamps fall together: which camera is never in one bundle with the others.

A clock that is off by more than a quarter period puts a camera's images into bundles of their own. Then it
shares no instant with the others, and every one of them seems to miss every second image.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

import numpy as np
from pydantic import Field
from scipy.sparse.csgraph import connected_components

from estimator.bundle import FrameBundle
from estimator.config import Config
from estimator.finding import Finding, FindingKind
from estimator.observations import Index, Mask
from estimator.ranges import PositiveCount, Share
from estimator.rig import Rig
from estimator.se3 import Array


class StampWatchConfig(Config):
    """What it takes to say that a camera is out of step.

    ``max_shared`` is the share of its images that may come in one bundle with others' all the same,
    ``min_off`` a share of the others' period. ``min_steadiness`` is 1 for stamps that always lie as far
    off, 0 for any.
    """

    bundles: PositiveCount = 60
    min_images: int = Field(10, ge=3, le=1000)
    max_shared: Share = 0.3
    min_off: Share = 0.2
    min_steadiness: Share = 0.9


class StampWatch:
    """Remembers which cameras were in the newest bundles."""

    def __init__(self, rig: Rig, config: StampWatchConfig) -> None:
        self._names = tuple(rig.cameras)
        self._reference = self._names.index(rig.reference)
        self._config = config
        self._recent: deque[tuple[int, list[bool]]] = deque(maxlen=config.bundles)

    def see(self, bundle: FrameBundle) -> None:
        """Take note of a bundle."""
        self._recent.append((bundle.stamp_ns, [name in bundle.images for name in self._names]))

    def findings(self) -> Iterator[Finding]:
        """Yield the cameras that keep beside the others by the same time; one at another rate does not."""
        if not self._recent:
            return
        present = np.array([there for _, there in self._recent])
        group = self._groups(present)
        main = group == self._main_group(group)
        if main.sum() == (group >= 0).sum():
            return
        stamps_s = np.array([stamp_ns - self._recent[0][0] for stamp_ns, _ in self._recent]) * 1e-9
        for camera in np.flatnonzero(~main & (group >= 0)):
            off = self._off(stamps_s[present[:, camera]], stamps_s[present[:, main].any(1)])
            if off is not None:
                yield self._finding(self._names[camera], *off)

    def _groups(self, present: Mask) -> Index:
        """Return (C,) which cameras come together; -1 for those of which there are too few images."""
        together = present.T.astype(int) @ present
        count = np.diag(together)
        shared = together > self._config.max_shared * np.minimum.outer(count, count)
        judged = count >= self._config.min_images
        _, group = connected_components(shared & np.logical_and.outer(judged, judged), directed=False)
        return np.where(judged, group, -1)

    def _main_group(self, group: Index) -> int:
        """Return the group of most cameras; among equals that of the reference."""
        groups, size = np.unique(group[group >= 0], return_counts=True)
        if not len(groups):
            return -1
        ours = 0.5 * (groups == group[self._reference])
        return int(groups[np.argmax(size + ours)])

    def _off(self, mine_s: Array, others_s: Array) -> tuple[float, float] | None:
        """Return how much later than the nearest of the others' these stamps are, and the others' period."""
        period_s = float(np.median(np.diff(others_s)))
        nearest_s = others_s[np.abs(mine_s[:, None] - others_s).argmin(1)]
        phase = np.mean(np.exp(2j * np.pi * (mine_s - nearest_s) / period_s))
        off = float(np.angle(phase)) / (2 * np.pi)
        is_off = np.abs(phase) > self._config.min_steadiness and abs(off) > self._config.min_off
        return (off * period_s, period_s) if is_off else None

    def _finding(self, name: str, off_s: float, period_s: float) -> Finding:
        side = "later" if off_s > 0 else "earlier"
        about = (
            f"the stamps of {name} are {abs(1000 * off_s):.0f} ms {side} than those of the other cameras "
            f"(or that and whole periods of {1000 * period_s:.0f} ms): too far for one bundle with them, so "
            "its images are of no use"
        )
        return Finding(FindingKind.CLOCK_OFFSET, (name,), about)
