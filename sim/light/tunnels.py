"""How much daylight reaches into tunnels: all of it at the portals, less and less towards the middle."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from estimator.se3 import Array
from sim.light.surfaces import Floats

_CELL_M = 0.5
_WALL_M = 1.0  # what counts as inside beyond the outline, so that walls do
_SOFT_M = 0.6  # over which the roof's edge fades


@dataclass(frozen=True, eq=False)
class CoveredRoad:
    """A tunnel as the light sees it.

    Attributes:
        outline_m: (N, 2) what is covered, in world xy.
        portals_m: (K, 2) the middles of its openings.
        ceiling_m: World z of its ceiling.
    """

    outline_m: Array
    portals_m: Array
    ceiling_m: float


class TunnelShade:
    """A map of the share of daylight that gets in, made once and looked up for every picture."""

    def __init__(self, tunnels: Sequence[CoveredRoad], reach_m: float) -> None:
        """``reach_m`` is how far from a portal daylight has fallen to 0.3."""
        self._maps = [(_low(tunnel), _map(tunnel, reach_m), tunnel.ceiling_m) for tunnel in tunnels]

    def daylight(self, points_m: Floats) -> Floats:
        """Return the share of daylight, 0 to 1, at (3, h, w) world points."""
        share = np.ones(points_m.shape[1:], np.float32)
        for low, shares, ceiling_m in self._maps:
            x, y = ((points_m[axis] - np.float32(low[axis])) / np.float32(_CELL_M) for axis in (0, 1))
            here = cv2.remap(shares, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=1.0)
            above = np.clip((points_m[2] - np.float32(ceiling_m + 0.2)) / np.float32(_SOFT_M), 0, 1)
            share *= here + (1 - here) * above
        return share


def _low(tunnel: CoveredRoad) -> Array:
    return np.asarray(tunnel.outline_m.min(0) - 4 * _WALL_M)


def _map(tunnel: CoveredRoad, reach_m: float) -> Floats:
    low = _low(tunnel)
    columns, rows = np.ceil((tunnel.outline_m.max(0) + 4 * _WALL_M - low) / _CELL_M).astype(int) + 1
    inside = np.zeros((rows, columns), np.uint8)
    corners = np.rint((tunnel.outline_m - low) / _CELL_M).astype(np.int32)
    cv2.fillPoly(inside, [corners], 1)
    size = 2 * round(_WALL_M / _CELL_M) + 1
    inside = cv2.dilate(inside, np.ones((size, size), np.uint8))
    x, y = np.meshgrid(low[0] + _CELL_M * np.arange(columns), low[1] + _CELL_M * np.arange(rows))
    share = np.zeros((rows, columns))
    for portal in tunnel.portals_m:
        distance = np.hypot(x - portal[0], y - portal[1])
        share = share + 1 - distance / np.hypot(distance, reach_m)  # the view factor of a disc
    return np.where(inside > 0, np.minimum(share, 1.0), 1.0).astype(np.float32)
