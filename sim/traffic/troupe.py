"""Actors of one kind: where they are on their tracks, how they stand on the ground, and their bodies."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from estimator.se3 import Array
from sim.traffic.conflicts import Cells
from sim.traffic.model import Bodies, Model
from sim.traffic.pose import Stance
from sim.traffic.track import CELL_M, Track

HeightOf = Callable[[Array], Array]  # world xy (..., 2) -> (...)
Posing = Callable[["Instant"], Array]


@dataclass(frozen=True, eq=False)
class Instant:
    """The actors of a troupe at one time.

    Attributes:
        way_m: (N,) u on their tracks.
        speed_mps: (N,).
        curvature_1pm: (N,) of the track under them.
    """

    way_m: Array
    speed_mps: Array
    curvature_1pm: Array


class Troupe:
    """Moves the bodies of some actors."""

    def __init__(
        self,
        name: str,
        models: Sequence[Model],
        tracks: Sequence[Track],
        track: Cells,
        state_at: Callable[[float], tuple[Array, Array]],
        posing: Posing,
        heights: HeightOf | Sequence[Array],
    ) -> None:
        """Assemble.

        Args:
            name: Prefix of the bodies' names.
            models: One an actor.
            tracks: All there are.
            track: (N,) index of each actor's.
            state_at: Way on the track and speed of all actors at a time.
            posing: Poses of all parts at an instant.
            heights: Of the ground at world xy, or in the middle of each cell of every track.
        """
        self.name, self.tracks, self.track = name, tuple(tracks), track
        self.models = list(models)
        self._state_at, self._posing, self._heights = state_at, posing, heights
        self._bodies = Bodies(f"traffic_{name}", self.models)
        self._axles_m = np.array([model.axles_m for model in models]).reshape(-1, 2)

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add the bodies."""
        self._bodies.write_into(spec)

    def place(self, data: mujoco.MjData, time_s: float) -> None:
        """Put all actors where they are at a time."""
        if not self.models:
            return
        way, speed = self._state_at(time_s)
        parts = self._posing(Instant(way, speed, self._curvature_1pm(way)))
        self._bodies.place(data, self.stance(time_s), parts)

    def stance(self, time_s: float) -> Stance:
        """Stand every actor with both axles on its track and on the ground."""
        way, _ = self._state_at(time_s)
        rear, front = (self._on_ground(way, self._axles_m[:, k]) for k in (0, 1))
        along = front - rear
        share = (-self._axles_m[:, 0] / (self._axles_m[:, 1] - self._axles_m[:, 0]))[:, None]
        flat = np.hypot(along[:, 0], along[:, 1])
        return Stance(
            rear + share * along, np.arctan2(along[:, 1], along[:, 0]), -np.arctan2(along[:, 2], flat)
        )

    def _on_ground(self, way_m: Array, offset_m: Array) -> Array:
        """(N, 3) points of the ground on the tracks, some way ahead of the actors' middles."""
        points = np.zeros((len(way_m), 3))
        for index, track in enumerate(self.tracks):
            mine = self.track == index
            if not mine.any():
                continue
            u, ahead = way_m[mine], offset_m[mine]
            points[mine, :2] = track.path.point_m(track.s_m(u) + ahead)
            if not callable(self._heights):
                at = np.mod((u + ahead) / CELL_M - 0.5, track.cell_count)
                cells = np.arange(track.cell_count)
                points[mine, 2] = np.interp(at, cells, self._heights[index], period=track.cell_count)
        if callable(self._heights):
            points[:, 2] = self._heights(points[:, :2])
        return points

    def _curvature_1pm(self, way_m: Array) -> Array:
        curvature = np.zeros(len(way_m))
        for index, track in enumerate(self.tracks):
            mine = self.track == index
            curvature[mine] = track.path.curvature_1pm(track.s_m(way_m[mine]), 2.0)
        return curvature
