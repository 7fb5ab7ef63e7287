"""The land around streets: yards, lawns and fields up to the horizon, a little lower than the pavements."""

from __future__ import annotations

import numpy as np
from shapely import contains_xy, prepare
from shapely.geometry import Polygon, box
from shapely.ops import unary_union

from estimator.se3 import Array
from sim.paint.paving import grassland
from sim.streets.drape import triangulated
from sim.streets.kerb import KerbLine
from sim.streets.network import Network
from sim.streets.scenery import Prop, Scenery, Skin

TILE_M = 60.0
_BELOW_PAVEMENT_M = 0.02
_BELOW_VERGE_M = 0.03
_UNDER_M = 0.15  # how far it reaches under pavements
_OVERLAP_M = 0.05  # closes the seams between what is paved
_HORIZON_M = 320.0
_RINGS_M = ((12.0, 2.0), (60.0, 6.0), (None, 40.0))  # up to how far from the streets, and the step there


def build_land(network: Network, rng: np.random.Generator) -> Scenery:
    """Whatever is neither carriageway nor pavement."""
    parts = [network.carriageway, *(_pavement(kerb) for kerb in network.kerbs)]
    paved = unary_union([part.buffer(_OVERLAP_M) for part in parts])
    hole = paved.buffer(-_UNDER_M - _OVERLAP_M)
    x0, y0, x1, y1 = network.carriageway.bounds
    around = box(x0 - _HORIZON_M, y0 - _HORIZON_M, x1 + _HORIZON_M, y1 + _HORIZON_M)
    land = around.difference(hole).buffer(0)
    height = max((kerb.height_m for kerb in network.kerbs), default=0.0)
    level = height - _BELOW_PAVEMENT_M if height > 0 else -_BELOW_VERGE_M
    mesh = triangulated(
        land,
        _vertices(around, paved),
        lambda xy: network.relief.height_m(xy) + level,
        lambda xy: xy / TILE_M * [1.0, -1.0],
        2.0,
        0.5,
    )
    return Scenery((Prop("land", mesh, "land"),), {"land": Skin(grassland(TILE_M, rng))})


def _pavement(kerb: KerbLine) -> Polygon:
    s_m = np.linspace(kerb.path.start_m, kerb.path.end_m, max(3, round(2 * kerb.path.length_m)))
    outline = [kerb.path.point_m(s_m, 0.0), kerb.path.point_m(s_m, kerb.pavement_m)[::-1]]
    if kerb.path.closed:
        rings = [Polygon(ring).buffer(0) for ring in outline]
        return rings[0].symmetric_difference(rings[1])
    return Polygon(np.vstack(outline)).buffer(0)


def _vertices(around: Polygon, paved: Polygon) -> Array:
    """Dense near the streets, sparse towards the horizon."""
    found, inner = [], paved
    for reach, step in _RINGS_M:
        outer = paved.buffer(reach, quad_segs=4) if reach else around
        x0, y0, x1, y1 = outer.bounds
        x, y = (axis.ravel() for axis in np.meshgrid(np.arange(x0, x1, step), np.arange(y0, y1, step)))
        prepare([outer, inner])
        kept = contains_xy(outer, x, y) & ~contains_xy(inner, x, y)
        found.append(np.stack([x[kept], y[kept]], axis=1))
        inner = outer
    return np.vstack(found)
