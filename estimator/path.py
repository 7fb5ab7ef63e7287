"""The car's path as known so far: refined where windows have been solved, odometry beyond."""

from __future__ import annotations

from collections.abc import Sequence

from estimator.se3 import SE3


class Path:
    """Poses by stamp. What a window corrected is final; the rest moves along with the last correction."""

    def __init__(self) -> None:
        self._stamps_ns: list[int] = []
        self._world_from_egos: list[SE3] = []
        self._final = 0

    def append(self, stamp_ns: int, world_from_ego: SE3) -> None:
        self._stamps_ns.append(stamp_ns)
        self._world_from_egos.append(world_from_ego)

    def correct(self, keyframe_stamps_ns: Sequence[int], world_from_egos: Sequence[SE3]) -> None:
        """Put keyframes where a window found them; bundles between keep their step from the one before."""
        final = self._final
        targets = dict(zip(keyframe_stamps_ns, world_from_egos, strict=True))
        world_from_old = SE3()
        for index in range(self._final, len(self._stamps_ns)):
            target = targets.get(self._stamps_ns[index])
            if target is not None:
                world_from_old = target @ self._world_from_egos[index].inverse()
                if self._stamps_ns[index] == keyframe_stamps_ns[-1]:
                    final = index
            self._world_from_egos[index] = world_from_old @ self._world_from_egos[index]
        self._final = final

    def poses(self) -> tuple[tuple[int, SE3], ...]:
        """Return (stamp_ns, world_from_ego) of every bundle whose motion is known."""
        return tuple(zip(self._stamps_ns, self._world_from_egos, strict=True))
