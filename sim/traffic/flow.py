"""Actors that mind each other: each claims the ground it needs to stop on before it drives there.

No two claims ever meet, so nobody runs into anybody, however lanes follow, merge or cross. Ground where
tracks cross, or that belongs to somebody who gives way to nobody, is a box: it is claimed only as a
whole, together with room behind it, so that nobody stops in it and crossings never lock up.

Reference:
    Dresner & Stone 2008, A Multiagent Approach to Autonomous Intersection Management, JAIR 31.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from estimator.se3 import Array
from sim.traffic.claims import Claims, Request
from sim.traffic.conflicts import find_conflicts
from sim.traffic.movers import Movers
from sim.traffic.pace import Pace
from sim.traffic.track import CELL_M, Track
from sim.traffic.trajectory import Trajectories

Indices = NDArray[np.int64]

STEP_S = 0.2
WARM_UP_S = 16.0
_REACH_M = 1.5  # claimed beyond the way to stop, so that a start is possible


@dataclass(frozen=True)
class Entrant:
    """An actor before it has a place.

    Attributes:
        track: Index of its track.
        length_m: What it takes up of it.
        briskness: Its own speed over the lane's.
        jitter: Where between its neighbours it starts, -0.5 to 0.5.
    """

    track: int
    length_m: float
    briskness: float
    jitter: float


class Flow:
    """Actors of one kind on their tracks, moved ahead as far as times are asked for."""

    def __init__(
        self, tracks: Sequence[Track], entrants: Sequence[Entrant], above: Sequence[Movers], pace: Pace
    ) -> None:
        """Give every entrant a place on its track, where there is one, and let all run for a while.

        Args:
            tracks: Those of this kind.
            entrants: Grouped by track.
            above: Whom to give way to.
            pace: How they speed up and slow down.
        """
        self.tracks, self._pace = tuple(tracks), pace
        others = [track for movers in above for track in movers.tracks]
        fixed = [False] * len(self.tracks) + [True] * len(others)
        conflicts = find_conflicts([*self.tracks, *others], fixed)
        self._claims = Claims(conflicts, self.tracks, above)
        self.members: list[int] = []  # indices of the entrants that found a place
        way = self._line_up(entrants)
        placed = [entrants[k] for k in self.members]
        self.track = np.array([entrant.track for entrant in placed], int)
        self._length_m = np.array([entrant.length_m for entrant in placed])
        self._briskness = np.array([entrant.briskness for entrant in placed])
        self._next, self._round_m = self._neighbours()
        self._way_m, self._speed_mps = way, np.zeros(len(way))
        self._claimed_m = way + self._length_m / 2
        self._table = Trajectories(-WARM_UP_S, STEP_S, self._way_m, self._speed_mps)
        self.at(0.0)

    def at(self, time_s: float) -> tuple[Array, Array]:
        """Return (N,) u of the actors' middles and (N,) speed at any time from the warm-up on."""
        while len(self._way_m) and self._table.newest_s < time_s + STEP_S:
            self._step(self._table.newest_s)
        return self._table.at(time_s)

    def swept_m(self, track: int, from_s: float, to_s: float) -> Array:
        mine = self.track == track
        half = self._length_m[mine] / 2 + 0.3
        return np.stack([self.at(from_s)[0][mine] - half, self.at(to_s)[0][mine] + half], axis=1)

    def _line_up(self, entrants: Sequence[Entrant]) -> Array:
        """Spread the entrants of each track evenly; none in a box or on ground that is taken."""
        ways: list[float] = []
        for index, track in enumerate(self.tracks):
            if not track.closed and self._claims.in_box(index, 0):
                continue  # who waited to come in would stand where others have just left
            mine = [k for k, entrant in enumerate(entrants) if entrant.track == index]
            first_rear, last_front = None, -np.inf
            for place, k in enumerate(mine):
                half = entrants[k].length_m / 2
                wish = track.ring_m * (place + 0.5 + 0.6 * entrants[k].jitter) / len(mine)
                low = max(wish, last_front + half + self._pace.gap_m)
                end = track.ring_m if first_rear is None else first_rear + track.ring_m - self._pace.gap_m
                for way in np.arange(low, end - half, CELL_M):
                    if self._claims.stand(index, way - half, way + half, -WARM_UP_S):
                        ways.append(float(way))
                        self.members.append(k)
                        last_front = way + half
                        first_rear = way - half if first_rear is None else first_rear
                        break
        return np.array(ways)

    def _neighbours(self) -> tuple[Indices, Array]:
        """Whom each actor follows, and how much to add to that one's u to have it ahead."""
        ahead, rounds = np.arange(len(self.track), dtype=np.int64), np.zeros(len(self.track))
        for index, track in enumerate(self.tracks):
            mine = np.flatnonzero(self.track == index)
            ahead[mine] = np.roll(mine, -1)
            if len(mine):
                rounds[mine[-1]] = track.ring_m
        return ahead, rounds

    def _step(self, now_s: float) -> None:
        half = self._length_m / 2
        room = self._way_m[self._next] - half[self._next] + self._round_m - self._pace.gap_m
        for k in range(len(self._way_m)):
            self._claim_ahead(k, float(room[k]), now_s)
        limits = self._limits(self._way_m, np.arange(len(self._way_m)), now_s)
        speed = self._pace.next_speed(self._speed_mps, limits, self._claimed_m - self._way_m - half)
        self._way_m = self._way_m + (self._speed_mps + speed) / 2 * STEP_S
        self._speed_mps = speed
        for k, rear in enumerate(self._way_m - half):
            self._claims.release_behind(k, int(self.track[k]), float(rear))
        self._table.append(self._way_m, self._speed_mps)

    def _claim_ahead(self, k: int, room_m: float, now_s: float) -> None:
        speed, front = float(self._speed_mps[k]), float(self._way_m[k] + self._length_m[k] / 2)
        wish = front + self._pace.stopping_m(speed) + _REACH_M
        if wish <= self._claimed_m[k] or room_m <= self._claimed_m[k]:
            return
        track, length = int(self.track[k]), float(self._length_m[k])
        self._claimed_m[k] = self._claims.extend(
            Request(k, track, float(self._claimed_m[k]), wish, room_m, length, now_s),
            lambda end_m, out_m: self._clears_s(k, end_m, out_m, now_s),
        )

    def _clears_s(self, k: int, end_m: float, out_m: float, now_s: float) -> float:
        """When an actor's rear has left u = ``out_m`` for certain, if its claim ends at ``end_m``."""
        half = self._length_m[k] / 2
        way, speed, time_s = self._way_m[k : k + 1], self._speed_mps[k : k + 1], now_s
        who = np.array([k])
        while way[0] - half < out_m and time_s < now_s + 60.0:
            following = self._pace.next_speed(speed, self._limits(way, who, time_s), end_m - way - half)
            way, speed, time_s = way + (speed + following) / 2 * STEP_S, following, time_s + STEP_S
        return time_s

    def _limits(self, way_m: Array, who: Indices, time_s: float) -> Array:
        tracks = [self.tracks[k] for k in self.track[who]]
        cells = [int(u // CELL_M) % track.cell_count for u, track in zip(way_m, tracks, strict=True)]
        speeds = np.array([track.cell_speeds_mps[k] for track, k in zip(tracks, cells, strict=True)])
        return np.asarray(speeds * self._briskness[who] * self._pace.wave(way_m, self.track[who], time_s))
