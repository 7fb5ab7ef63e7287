"""Learn from the images which parts of them show the car itself, so that no track is spent on them.

Bonnet, mirrors, the car's own reflection and dirt on the lens keep their pixels for ever. A grid over the
image counts the metres for which tracks stood still there against those for which they moved through.
"""

from __future__ import annotations

import cv2
import numpy as np
import numpy.typing as npt

from estimator.config import Config
from estimator.ranges import CellPx, Count, LengthM, Share, SizePx
from estimator.se3 import SE3, Array
from estimator.still_tracks import StillConfig, not_of_the_street
from estimator.track_table import Chosen, TrackTable

Cells = npt.NDArray[np.bool_]


class OwnCarConfig(Config):
    """How much evidence bars a cell, and how barred cells get another chance.

    A track speaks against its cell once it has stood still for ``vote_m``; a cell counts for ``most_m`` at
    most either way, so that none is beyond recall. ``probes`` barred cells at a time are open for
    ``probe_m``; one that shows no still track in that time loses half of what speaks against it.
    """

    still: StillConfig = StillConfig()
    cell_px: CellPx = 16
    vote_m: LengthM = 3.0
    moving_px: SizePx = 3.0
    barred_m: LengthM = 2.0
    most_m: LengthM = 6.0
    probes: Count = 3
    probe_m: LengthM = 4.0
    most_barred: Share = 0.6


class OwnCarMask:
    """What one camera's image has shown of the car so far, by cell."""

    def __init__(self, size_px: tuple[int, int], config: OwnCarConfig) -> None:
        self.config = config
        self._size_px = size_px
        shape = -(-size_px[1] // config.cell_px), -(-size_px[0] // config.cell_px)
        self._score_m = np.zeros(shape)  # track-metres: stood still less moved through
        self._opened_at_m = np.full(shape, -np.inf)  # how far the car had driven
        self._confirmed = np.zeros(shape, bool)  # since it was opened
        self._open = np.zeros(shape, bool)
        self._driven_m = 0.0

    @property
    def barred(self) -> Cells:
        """Which cells show the car; those beside them, too, until something moves there.

        Or no cell at all, if it is most of the image: no car hides that, but a camera that hangs shows it.
        """
        own = self._score_m >= self.config.barred_m
        beside = cv2.dilate(own.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        barred = own | (beside & (self._score_m > -0.5 * self.config.barred_m))
        return barred if barred.mean() <= self.config.most_barred else np.zeros_like(barred)

    @property
    def usable(self) -> Cells:
        """Which cells may get new tracks: those that are not barred, and those on probation."""
        return ~self.barred | self._open

    def usable_px(self, height: int, width: int) -> Cells | None:
        """Return ``usable`` by pixel, (H, W); None if nothing is barred, or the image is no such camera's."""
        usable = self.usable
        if usable.all() or (width, height) != self._size_px:
            return None
        return usable.repeat(self.config.cell_px, 0).repeat(self.config.cell_px, 1)[:height, :width]

    def may_show_car(self, tracks: TrackTable) -> Chosen:
        """Return (N,) which tracks have stood still so far, and not where it is the street that shows."""
        unknown = self._score_m > -self.config.barred_m
        return np.asarray(self._stands(tracks) & unknown[tuple(self._cell_of(tracks.pixels).T)])

    def see(
        self, tracks: TrackTable, focal_px: float, world_from_ego: SE3, ego_from_cam: SE3, step_m: float
    ) -> Chosen:
        """Learn from the tracks' newest step, mark those on the car, and return (N,) which tracks to keep."""
        self._driven_m += step_m
        cell = self._cell_of(tracks.pixels)
        moved_px = np.linalg.norm(tracks.pixels - tracks.anchor_pixels, axis=1)
        center_world = (world_from_ego @ ego_from_cam).translation
        travel_m = np.linalg.norm(tracks.anchor_center_world - center_world, axis=1)
        tracks.on_car = not_of_the_street(tracks, focal_px, world_from_ego, ego_from_cam, self.config.still)
        own = tracks.on_car & (travel_m > self.config.vote_m)
        through = (moved_px > self.config.moving_px) & (tracks.strikes == 0)
        np.add.at(self._score_m, tuple(cell[own].T), self.config.vote_m)
        np.add.at(self._score_m, tuple(cell[through].T), -step_m)
        np.clip(self._score_m, -self.config.most_m, self.config.most_m, out=self._score_m)
        self._confirmed[tuple(cell[own].T)] = True
        self._take_turns()
        return np.asarray(~own & ~(self._stands(tracks) & ~self.usable[tuple(cell.T)]))

    def _stands(self, tracks: TrackTable) -> Chosen:
        moved_px = np.linalg.norm(tracks.pixels - tracks.anchor_pixels, axis=1)
        return np.asarray(moved_px < self.config.still.still_px)

    def _take_turns(self) -> None:
        """Close cells whose probation is over, and open those that have waited longest."""
        over = self._open & (self._driven_m - self._opened_at_m > self.config.probe_m)
        self._score_m[over & ~self._confirmed & (self._score_m > 0)] *= 0.5
        self._open &= ~over
        self._open &= self.barred
        waiting = np.flatnonzero(self.barred & ~self._open)
        room = self.config.probes - int(self._open.sum())
        never = np.isneginf(self._opened_at_m.ravel()[waiting])
        self._opened_at_m.ravel()[waiting[never]] = self._driven_m  # barred just now, so just tried
        ready = waiting[self._driven_m - self._opened_at_m.ravel()[waiting] > self.config.probe_m]
        order = np.argsort(self._opened_at_m.ravel()[ready], kind="stable")
        chosen = ready[order[: max(room, 0)]]
        self._open.ravel()[chosen], self._confirmed.ravel()[chosen] = True, False
        self._opened_at_m.ravel()[chosen] = self._driven_m

    def _cell_of(self, pixels: Array) -> npt.NDArray[np.int64]:
        """Return (N, 2) row and column."""
        cell = np.floor((pixels[:, ::-1] + 0.5) / self.config.cell_px).astype(np.int64)
        return np.asarray(np.clip(cell, 0, np.array(self._score_m.shape) - 1))
