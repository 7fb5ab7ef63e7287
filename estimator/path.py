"""The car's path as known so far: refined where windows have been solved, odometry beyond."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from itertools import pairwise

from estimator.se3 import SE3


class Path:
    """Poses by stamp, in order of stamps."""

    def __init__(self) -> None:
        self._stamps_ns: list[int] = []
        self._world_from_egos: list[SE3] = []
        self._begun = False
        self._guessed = 0  # bundles at the end whose pose nobody measured

    @property
    def newest(self) -> SE3 | None:
        """The newest ``world_from_ego``; None before the first."""
        return self._world_from_egos[-1] if self._world_from_egos else None

    def begin(self, stamp_ns: int, world_from_ego: SE3) -> None:
        """Add the place that motion counts from; if none came of the last such place, forget that one."""
        if self._begun:
            del self._stamps_ns[-1], self._world_from_egos[-1]
        self.append(stamp_ns, world_from_ego)
        self._begun = True

    def append(self, stamp_ns: int, world_from_ego: SE3, measured: bool = True) -> None:
        """Add a bundle; where the ones before it were guessed, put them evenly on the way here."""
        self._begun = False
        self._stamps_ns.append(stamp_ns)
        self._world_from_egos.append(world_from_ego)
        if not measured:
            self._guessed += 1
            return
        last = len(self._stamps_ns) - 1
        first = last - self._guessed - 1
        self._guessed = 0
        for row in range(first + 1, last):
            start = self._world_from_egos[first]
            change = self._share(first, row, last) * start.local(world_from_ego)
            self._world_from_egos[row] = start.retract(change)

    def _share(self, first: int, row: int, last: int) -> float:
        span_ns = self._stamps_ns[last] - self._stamps_ns[first]
        return (self._stamps_ns[row] - self._stamps_ns[first]) / span_ns

    def correct(self, keyframe_stamps_ns: Sequence[int], world_from_egos: Sequence[SE3]) -> None:
        """Put keyframes where a window found them.

        Bundles between two keyframes share out the difference between the two corrections by time; those
        beyond the last move along with it.
        """
        rows = [bisect_left(self._stamps_ns, stamp_ns) for stamp_ns in keyframe_stamps_ns]
        world_from_old = [
            pose @ self._world_from_egos[row].inverse()
            for row, pose in zip(rows, world_from_egos, strict=True)
        ]
        for (first, last), (before, after) in zip(pairwise(rows), pairwise(world_from_old), strict=True):
            change = before.local(after)
            for row in range(first, last):
                share = self._share(first, row, last)
                self._world_from_egos[row] = before.retract(share * change) @ self._world_from_egos[row]
        for row in range(rows[-1], len(self._stamps_ns)):
            self._world_from_egos[row] = world_from_old[-1] @ self._world_from_egos[row]

    def poses(self) -> tuple[tuple[int, SE3], ...]:
        """Return (stamp_ns, world_from_ego) of every bundle whose motion is known."""
        return tuple(zip(self._stamps_ns, self._world_from_egos, strict=True))
