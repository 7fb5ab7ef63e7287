"""Whose turn it is where many want the same ground: who has waited long and longest is let through next."""

from __future__ import annotations

import numpy as np

from sim.traffic.conflicts import Cells

PATIENCE_S = 6.0


class Turns:
    """Remembers who is waiting for others, since when, and for which ground to become free."""

    def __init__(self) -> None:
        self._waiting: dict[int, tuple[float, Cells]] = {}

    def wait(self, actor: int, cells: Cells, now_s: float) -> None:
        """Note that an actor waits for cells of others to become free."""
        since_s = self._waiting[actor][0] if actor in self._waiting else now_s
        self._waiting[actor] = (since_s, cells)

    def forget(self, actor: int) -> None:
        """Note that an actor goes, or waits for something else."""
        self._waiting.pop(actor, None)

    def must_wait(self, actor: int, own_cells: Cells, now_s: float) -> bool:
        """Whether somebody waits for an actor's cells who has lost patience, and has waited longer."""
        mine_s = self._waiting[actor][0] if actor in self._waiting else now_s
        return any(
            other != actor
            and since_s < min(mine_s, now_s - PATIENCE_S)
            and bool(np.isin(own_cells, cells, kind="sort").any())
            for other, (since_s, cells) in self._waiting.items()
        )
