"""Ways round what stands on a pavement: bins, benches, trees, signs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.ndimage import uniform_filter1d
from shapely import contains_xy, prepare
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from estimator.se3 import Array
from sim.streets.path import Path, path_through

_STEP_M = 0.25
_OFFSETS_M = np.round(np.arange(-1.5, 1.501, 0.1), 3)
_BLOCKED = 50.0  # cost of a step through something, against that of an offset of one metre
_BODY_M = 0.3  # kept from the middle of a walker
_DOOR_M = 3.0  # at the ends of a path, where people go into houses
_ABREAST_M = 0.64  # between the middles of two who meet
_SOFT_M = 1.0  # over which a swerve is smoothed


def obstacles_of(outlines_m: Sequence[Array], carriageway: BaseGeometry) -> BaseGeometry:
    """Where the middle of a walker cannot be: near an outline on the ground, or on the road."""
    return unary_union([carriageway, *(Polygon(outline) for outline in outlines_m)]).buffer(_BODY_M)


def round_obstacles(paths: Sequence[Path], obstacles: BaseGeometry) -> list[Path]:
    """Lead paths round obstacles, and, where there is room, round each other; the last ones choose first."""
    taken, chosen = obstacles, []
    for path in reversed(paths):
        chosen.append(_round(path, taken))
        taken = taken.union(LineString(chosen[-1].points_m[::5]).buffer(_ABREAST_M))
    return chosen[::-1]


def _round(path: Path, obstacles: BaseGeometry) -> Path:
    """Return the path, moved aside just as far and as early as it takes to pass what stands in it.

    Where there is no way through, it goes straight on.
    """
    count = max(2, round(path.length_m / _STEP_M))
    s_m = np.linspace(path.start_m, path.end_m, count + 1)
    grid_m = path.point_m(s_m[:, None], _OFFSETS_M[None])
    prepare(obstacles)
    blocked = contains_xy(obstacles, grid_m[..., 0], grid_m[..., 1])
    if not path.closed:
        blocked[s_m < path.start_m + _DOOR_M] = blocked[s_m > path.end_m - _DOOR_M] = False
    if not blocked[:, len(_OFFSETS_M) // 2].any():
        return path
    chosen = _OFFSETS_M[_cheapest(_BLOCKED * blocked + np.abs(_OFFSETS_M)[None])]
    width = round(_SOFT_M / _STEP_M)
    offset_m: Array = uniform_filter1d(chosen, width, mode="wrap" if path.closed else "nearest")
    return path_through(path.point_m(s_m, offset_m), path.closed)


def _cheapest(cost: Array) -> Array:
    """The cheapest way through (N, M) costs that moves by at most one column a row; (N,) columns."""
    total, came = cost.copy(), np.zeros(cost.shape, int)
    columns = np.arange(cost.shape[1])
    for row in range(1, len(cost)):
        padded = np.pad(total[row - 1], 1, constant_values=np.inf)
        # Straight on comes first, so that ties are not broken by swerving.
        options = np.stack([padded[1:-1], padded[:-2] + 0.01, padded[2:] + 0.01])
        best = np.argmin(options, axis=0)
        came[row] = columns + np.array([0, -1, 1])[best]
        total[row] += options[best, columns]
    way = np.empty(len(cost), int)
    way[-1] = int(np.argmin(total[-1]))
    for row in range(len(cost) - 1, 0, -1):
        way[row - 1] = came[row, way[row]]
    return way
