"""Which ground is claimed by whom, cell by cell, and whether more of it may be."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from sim.traffic.conflicts import Cells, ConflictMap
from sim.traffic.movers import Movers, is_swept
from sim.traffic.track import CELL_M, Track
from sim.traffic.turns import Turns

_TAIL_M = 1.0  # claimed behind a box beyond an actor's own length
_SPARE_S = 0.7  # between leaving a box and somebody else coming
_LONG_S = 8.0  # for which somebody who stands must be let alone when traffic begins


@dataclass(frozen=True)
class Request:
    """An actor's wish for more ground.

    Attributes:
        actor: Who.
        track: Where.
        claimed_m: u at which its claim ends so far.
        wish_m: Where it should end.
        room_m: Where whoever is ahead on the same track stands in the way.
        length_m: Of the actor.
        now_s: The time.
    """

    actor: int
    track: int
    claimed_m: float
    wish_m: float
    room_m: float
    length_m: float
    now_s: float


class Claims:
    """Every actor holds the cells from its rear to where it may drive."""

    def __init__(self, conflicts: ConflictMap, tracks: Sequence[Track], above: Sequence[Movers]) -> None:
        """Take the conflicts of ``tracks`` followed by those of everybody ``above``, in that order."""
        self._map, self._tracks = conflicts, tuple(tracks)
        self._claimed = np.zeros(int(conflicts.first[-1]), np.int32)
        self._held: list[tuple[int, int]] = []  # first and last cell of each actor, unwrapped
        self._turns = Turns()
        self._above = [(movers, k) for movers in above for k in range(len(movers.tracks))]

    def in_box(self, track: int, cell: int) -> bool:
        """Whether a cell of a track is part of a box."""
        return self._boxed(track, cell, cell)

    def stand(self, track: int, rear_m: float, front_m: float, now_s: float) -> bool:
        """Let the next actor stand somewhere, unless that is in a box or on ground that is taken."""
        first, last = _cell(rear_m), _cell(front_m)
        cells, _ = self._map.excluded_by(track, first, last)
        if self._boxed(track, first, last) or self._claimed[cells].any():
            return False
        if self._swept(cells, now_s, now_s + _LONG_S):
            return False
        self._hold(track, first, last, 1)
        self._held.append((first, last))
        return True

    def extend(self, asked: Request, clears_s: Callable[[float, float], float]) -> float:
        """Claim more ground ahead, as much as is free; return where the claim ends.

        Args:
            asked: Who wants what.
            clears_s: When the actor has certainly left u (second argument) if its claim ends at u (first).
        """
        first, held = self._held[asked.actor]
        goal = min(_cell(asked.wish_m), _cell(asked.room_m) - 1)
        end = held
        while end < goal:
            upto = self._next_piece(asked, end + 1, goal, clears_s)
            if upto <= end:
                break
            self._hold(asked.track, end + 1, upto, 1)
            end = upto
        self._held[asked.actor] = (first, end)
        return asked.claimed_m if end == held else min((end + 1) * CELL_M, asked.room_m)

    def _next_piece(
        self, asked: Request, start: int, goal: int, clears_s: Callable[[float, float], float]
    ) -> int:
        """Last cell of the next piece from ``start`` that may be claimed: open ground, or a whole box."""
        place = self._index(asked.track, start)
        to_box = int(self._map.to_box[place])
        if to_box > 0:
            upto = min(goal, start + to_box - 1)
            cells, offsets = self._map.excluded_by(asked.track, start, upto)
            taken = self._claimed[cells] > 0
            return start + int(offsets[taken].min()) - 1 if taken.any() else upto
        out = start + int(self._map.box_left[place])
        upto = out + int(np.ceil((asked.length_m + _TAIL_M) / CELL_M))
        if upto >= _cell(asked.room_m):
            self._turns.forget(asked.actor)
            return start - 1
        return upto if self._may_cross(asked, start, out, upto, clears_s) else start - 1

    def release_behind(self, actor: int, track: int, rear_m: float) -> None:
        """Give back what lies behind an actor's rear."""
        first, last = self._held[actor]
        rear = _cell(rear_m)
        if rear > first:
            self._hold(track, first, rear - 1, -1)
            self._held[actor] = (rear, last)

    def _may_cross(
        self, asked: Request, first: int, out: int, upto: int, clears_s: Callable[[float, float], float]
    ) -> bool:
        cells, _ = self._map.excluded_by(asked.track, first, upto)
        own = self._index(asked.track, np.arange(first, upto + 1))
        if self._claimed[cells].any() or self._turns.must_wait(asked.actor, own, asked.now_s):
            self._turns.wait(asked.actor, cells, asked.now_s)
            return False
        self._turns.forget(asked.actor)
        if self._boxed(asked.track, out, upto):
            return False  # another box begins before there is room to wait
        gone_s = clears_s((upto + 1) * CELL_M, out * CELL_M) + _SPARE_S
        return not self._swept(cells, asked.now_s, gone_s)

    def _swept(self, cells: Cells, from_s: float, to_s: float) -> bool:
        base = len(self._tracks)
        for number, (movers, k) in enumerate(self._above):
            low, high = self._map.first[base + number : base + number + 2]
            mine = cells[(cells >= low) & (cells < high)] - low
            if len(mine) and is_swept(np.unique(mine), movers.tracks[k], movers.swept_m(k, from_s, to_s)):
                return True
        return False

    def _hold(self, track: int, first: int, last: int, change: int) -> None:
        self._claimed[self._index(track, np.arange(first, last + 1))] += change

    def _boxed(self, track: int, first: int, last: int) -> bool:
        return bool(self._map.boxed[self._index(track, np.arange(first, last + 1))].any())

    def _index(self, track: int, cell: Cells | int) -> Cells:
        base, count = int(self._map.first[track]), int(self._map.first[track + 1] - self._map.first[track])
        return np.asarray(base + np.mod(cell, count))


def _cell(u_m: float) -> int:
    return int(np.floor(u_m / CELL_M))
