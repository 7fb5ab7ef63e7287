"""What is kept of a run while it runs: every camera's estimate, the motion, the cost, a few pictures.

Knows no truth. The loop that drives an estimator fills it; the scores and the report read it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass

from estimator.bundle import FrameBundle
from estimator.errors import InputError
from estimator.estimate import CameraEstimate, Estimate
from estimator.finding import Finding
from estimator.rig import Rig
from estimator.se3 import SE3
from eval.match_pictures import MatchPictureKeeper
from eval.thumbnails import MomentKeeper, TailHistory, thumbnail
from eval.usage import UsageMeter


@dataclass(frozen=True, eq=False)
class LogEntry:
    """What an estimator answered to one bundle.

    Attributes:
        stamp_ns: Of the bundle.
        cameras: The estimate of every camera.
        world_from_ego: In the estimator's own world; None while the motion is unknown.
        stage_s: Wall seconds by stage.
        findings: What the estimator noticed and still held.
    """

    stamp_ns: int
    cameras: Mapping[str, CameraEstimate]
    world_from_ego: SE3 | None
    stage_s: Mapping[str, float]
    findings: Sequence[Finding] = ()


class RunLog:
    """Grows by one entry a bundle until ``finish``.

    Use::

        log = RunLog(rig)
        for bundle in bundles:
            with log.measuring():
                estimate = estimator.update(bundle)
            log.add(bundle, estimate)
        with log.measuring():
            final = estimator.close()
        log.finish(final)

    Attributes:
        rig: The nominal rig.
        entries: One a bundle, in order.
        moments: A few instants with images and tracks.
        match_pictures: The best picture of each camera pair, and how many matches each pair had.
        usage: CPU time and memory.
    """

    def __init__(self, rig: Rig) -> None:
        self.rig = rig
        self.entries: list[LogEntry] = []
        self.moments = MomentKeeper()
        self.match_pictures = MatchPictureKeeper(tuple(rig.cameras))
        self.usage = UsageMeter()
        self._tails = TailHistory()
        self._final: Estimate | None = None
        self._cpu_s: float | None = None

    def measuring(self) -> AbstractContextManager[None]:
        """Count the block as time spent in the estimator."""
        return self.usage.measuring()

    def add(self, bundle: FrameBundle, estimate: Estimate) -> None:
        """Keep what is needed of one update; images only as thumbnails, and only a bounded number."""
        entry = LogEntry(
            bundle.stamp_ns,
            dict(estimate.cameras),
            estimate.world_from_ego,
            estimate.stage_s,
            tuple(estimate.findings),
        )
        self.entries.append(entry)
        thumbnails = {name: thumbnail(image) for name, image in bundle.images.items()}
        self._tails.add(estimate.tracks_px)
        self.moments.offer(bundle, thumbnails, self._tails)
        self.match_pictures.remember(bundle.stamp_ns, thumbnails)
        self.match_pictures.offer(estimate.matches)

    def finish(self, final: Estimate) -> None:
        """Take the answer of ``close()``.

        Raises:
            InputError: The recording held no bundle, so there is nothing to judge.
        """
        if not self.entries:
            raise InputError("the recording gave no bundle; at least one is needed")
        self.match_pictures.offer(final.matches)
        self._final = final
        self._cpu_s = self.usage.cpu_s if self.usage.call_count else None

    @property
    def final(self) -> Estimate:
        """The answer of ``close()``."""
        if self._final is None:
            raise ValueError("the run has not finished: there is no final estimate")
        return self._final

    @property
    def cpu_s(self) -> float | None:
        """CPU seconds of the estimator; None where no call was measured."""
        return self._cpu_s

    @property
    def first_stamp_ns(self) -> int:
        return self.entries[0].stamp_ns

    @property
    def last_stamp_ns(self) -> int:
        return self.entries[-1].stamp_ns

    @property
    def stamps_ns(self) -> list[int]:
        return [entry.stamp_ns for entry in self.entries]
