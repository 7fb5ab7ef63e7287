"""Where tracks come so near to each other that two actors cannot both be there."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from estimator.se3 import Array
from sim.traffic.track import CELL_M, Track

_CROSSING_RAD = np.deg2rad(20)
_BRIDGE_M = 11.0  # two boxes nearer than this are one: no car would fit between them
_SLACK_M = 0.05

Cells = NDArray[np.int64]


@dataclass(frozen=True, eq=False)
class ConflictMap:
    """Which cells of other tracks each cell of some tracks excludes.

    Cells of all tracks are numbered through: those of track j begin at ``first[j]``.

    Attributes:
        first: (T + 1,) first cell of each track, and the total.
        starts: Row pointers: cell k excludes ``cells[starts[k]:starts[k + 1]]``.
        cells: Cells of other tracks, sorted by row.
        boxed: (total,) whether the cell is inside a box: to be entered only when it can be left again.
        box_left: (total,) how many cells it takes from here to leave the box.
        to_box: (total,) how many cells from here to the next box of the track, 0 inside one.
    """

    first: Cells
    starts: Cells
    cells: Cells
    boxed: NDArray[np.bool_]
    box_left: Cells
    to_box: Cells

    def excluded_by(self, track: int, first: int, last: int) -> tuple[Cells, Cells]:
        """Return what cells ``first`` to ``last`` (unwrapped) of a track exclude, and by which of them."""
        base, count = int(self.first[track]), int(self.first[track + 1] - self.first[track])
        rows = base + np.arange(first, last + 1) % count
        sizes = self.starts[rows + 1] - self.starts[rows]
        offsets = np.repeat(np.arange(len(rows)), sizes)
        within = np.arange(len(offsets)) - np.repeat(np.cumsum(sizes) - sizes, sizes)
        return self.cells[np.repeat(self.starts[rows], sizes) + within], offsets


def find_conflicts(tracks: Sequence[Track], fixed: Sequence[bool]) -> ConflictMap:
    """Compare all tracks; where one is shared with or crossed by a fixed one is a box.

    Args:
        tracks: All of them.
        fixed: Whether each one's actors give way to nobody.
    """
    first = np.concatenate([[0], np.cumsum([track.cell_count for track in tracks])]).astype(np.int64)
    points = np.vstack([track.cell_points_m for track in tracks])
    headings = np.concatenate([track.cell_headings_rad for track in tracks])
    half = np.concatenate([track.cell_half_widths_m for track in tracks])
    owner = np.repeat(np.arange(len(tracks)), np.diff(first))
    pairs = (
        cKDTree(points).query_pairs(2 * float(half.max()) + _SLACK_M, output_type="ndarray").astype(np.int64)
    )
    a, b = np.concatenate([pairs, pairs[:, ::-1]]).T
    away = np.linalg.norm(points[a] - points[b], axis=1)
    kept = (owner[a] != owner[b]) & (away < half[a] + half[b] + _SLACK_M)
    a, b = a[kept], b[kept]
    order = np.lexsort((b, a))
    a, b = a[order], b[order]
    turn = np.abs(np.angle(np.exp(1j * (headings[a] - headings[b]))))
    is_fixed = np.asarray(fixed, bool)
    boxing = (turn > _CROSSING_RAD) | is_fixed[owner[b]]
    boxed = np.zeros(len(points), bool)
    boxed[a[boxing]] = True
    box_left, to_box = np.zeros(len(points), np.int64), np.zeros(len(points), np.int64)
    for track, (start, end) in zip(tracks, itertools.pairwise(first), strict=True):
        _open_at_stop_line(boxed[start:end], track.stop_cell)
        boxed[start:end], box_left[start:end], to_box[start:end] = _boxes(boxed[start:end])
    starts = np.searchsorted(a, np.arange(len(points) + 1)).astype(np.int64)
    return ConflictMap(first, starts, b, boxed, box_left, to_box)


def _open_at_stop_line(boxed: NDArray[np.bool_], stop: int | None) -> None:
    """Let the box behind a stop line begin at the line, so that nobody waits with the nose in the way."""
    if stop is not None and stop < len(boxed) and boxed[stop:].any():
        boxed[stop : stop + int(np.argmax(boxed[stop:]))] = True


def _boxes(boxed: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], Cells, Cells]:
    """Bridge narrow gaps round the ring; count cells to leave a box and to reach one."""
    count = len(boxed)
    if boxed.all() or not boxed.any():
        far = np.full(count, 4 * count)
        return boxed, far * boxed, far * ~boxed
    gaps = _ahead(~boxed, boxed)
    behind = _ahead((~boxed)[::-1], boxed[::-1])[::-1]
    boxed = boxed | (gaps + behind <= _BRIDGE_M / CELL_M)
    if boxed.all():
        return _boxes(boxed)
    return boxed, _ahead(boxed, ~boxed), _ahead(~boxed, boxed)


def _ahead(through: NDArray[np.bool_], to: NDArray[np.bool_]) -> Cells:
    """How many cells from each cell of ``through`` to the next of ``to``, round the ring; else 0."""
    count = len(through)
    marks = np.flatnonzero(np.concatenate([to, to]))
    index = np.arange(count)
    following = marks[np.searchsorted(marks, index)]
    result: Array = np.where(through, following - index, 0)
    return result.astype(np.int64)
