"""A path of poses in time: read it between its stamps, measure its length."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation, Slerp

from estimator.se3 import SE3, Array

# A stamp this far outside the path still reads the pose at its end.
_EDGE_NS = 1_000_000


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Poses ``world_from_ego`` at strictly increasing stamps, of any one world.

    Attributes:
        stamps_ns: (N,).
        positions_world: (N, 3) in metres.
        rotations: (N, 3, 3).
    """

    stamps_ns: npt.NDArray[np.int64]
    positions_world: Array
    rotations: Array

    @staticmethod
    def from_poses(stamps_ns: Sequence[int], world_from_egos: Sequence[SE3]) -> Trajectory:
        """Build from poses in order; of stamps that do not grow, the first stays."""
        kept: list[int] = []
        last = None
        for index, stamp in enumerate(stamps_ns):
            if last is None or stamp > last:
                kept.append(index)
                last = stamp
        poses = [world_from_egos[index] for index in kept]
        return Trajectory(
            np.array([stamps_ns[index] for index in kept], np.int64),
            np.array([pose.translation for pose in poses]).reshape(-1, 3),
            np.array([pose.rotation for pose in poses]).reshape(-1, 3, 3),
        )

    def __len__(self) -> int:
        return len(self.stamps_ns)

    @property
    def distance_m(self) -> Array:
        """(N,) length of the path up to each stamp."""
        steps = np.linalg.norm(np.diff(self.positions_world, axis=0), axis=1)
        return np.concatenate([[0.0], np.cumsum(steps)])

    def distance_m_at(self, stamps_ns: Sequence[int]) -> Array:
        """Return (M,) lengths at stamps, held constant outside the path."""
        return np.interp(self._seconds(stamps_ns), self._seconds(self.stamps_ns), self.distance_m)

    def covers(self, stamps_ns: Sequence[int] | npt.NDArray[np.int64]) -> npt.NDArray[np.bool_]:
        """Tell which stamps lie within the path, a millisecond of slack at its ends."""
        stamps = np.asarray(stamps_ns, np.int64)
        if not len(self):
            return np.zeros(len(stamps), bool)
        first, last = self.stamps_ns[0] - _EDGE_NS, self.stamps_ns[-1] + _EDGE_NS
        return np.asarray((stamps >= first) & (stamps <= last))

    def at(self, stamps_ns: Sequence[int] | npt.NDArray[np.int64]) -> Trajectory:
        """Interpolate at covered stamps: straight lines between positions, slerp between rotations."""
        stamps = np.asarray(stamps_ns, np.int64)
        own_s = self._seconds(self.stamps_ns)
        at_s = np.clip(self._seconds(stamps), own_s[0], own_s[-1])
        positions = np.column_stack([np.interp(at_s, own_s, axis) for axis in self.positions_world.T])
        if len(self) == 1:
            rotations = np.repeat(self.rotations, len(stamps), axis=0)
        else:
            rotations = Slerp(own_s, Rotation.from_matrix(self.rotations))(at_s).as_matrix()
        return Trajectory(stamps, positions, rotations)

    def pose(self, index: int) -> SE3:
        return SE3(self.rotations[index], self.positions_world[index])

    def _seconds(self, stamps_ns: Sequence[int] | npt.NDArray[np.int64]) -> Array:
        # Relative to the first stamp: a Unix epoch in nanoseconds does not fit a float.
        return np.asarray(np.asarray(stamps_ns, np.int64) - self.stamps_ns[0], float) * 1e-9
