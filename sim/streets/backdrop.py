"""Copses on the land behind the houses, wherever the driven lane has a view between them into the open."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from shapely import contains_xy, intersects, linestrings, prepare
from shapely.geometry import Polygon
from shapely.ops import unary_union

from estimator.se3 import Array
from sim.streets.lot import Lot
from sim.streets.network import Network
from sim.streets.placing import Site
from sim.streets.planting import Greenery

_BEYOND_M = 17.0  # from the carriageway: behind lots and their gardens
_SIGHT_M = 90.0
_LOOK_EVERY_M = 5.0
_RAYS = 120
_STEP_M = 3.0
_DEPTH_M = 7.0  # of a copse
_CLEARANCE_M = 0.5
_TREES = 0.3  # share of them in a copse; the rest are thickets


def plant_backdrop(
    site: Site, network: Network, lots: Sequence[Lot], driven_m: Array, green: Greenery
) -> None:
    """Close every view into the open with a copse."""
    rng, catalogue = green.rng, green.catalogue
    for spot, ahead in zip(*open_views(network, lots, driven_m), strict=True):
        things = catalogue.trees if rng.random() < _TREES else catalogue.thickets
        thing, back = things[int(rng.random() * len(things))], rng.uniform(0.0, _DEPTH_M)
        site.put_at(thing, spot + back * ahead, rng.uniform(0, 6), 0.0, _CLEARANCE_M, shown=green.grows())


def open_views(network: Network, lots: Sequence[Lot], driven_m: Array) -> tuple[Array, Array]:
    """Find where a look from the driven line, past every house, comes out behind the lots.

    Returns:
        (N, 2) world xy of these places, and (N, 2) unit vectors along the looks.
    """
    built = unary_union([Polygon(lot.outline_m) for lot in lots])
    near = network.carriageway.buffer(_BEYOND_M)
    prepare([built, near])
    step = max(1, round(_LOOK_EVERY_M / float(np.linalg.norm(driven_m[1] - driven_m[0]))))
    angles = np.linspace(0, 2 * np.pi, _RAYS, endpoint=False)
    ahead = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    reach_m = np.arange(_STEP_M, _SIGHT_M, _STEP_M)
    spots_m, looks = [], []
    for eye in driven_m[::step]:
        along = eye + reach_m[None, :, None] * ahead[:, None]  # (rays, steps, 2)
        outside = ~contains_xy(near, along[..., 0], along[..., 1])
        rays = np.flatnonzero(outside.any(axis=1))
        spots = along[rays, outside.argmax(axis=1)[rays]]
        lines = linestrings(np.stack([np.broadcast_to(eye, spots.shape), spots], axis=1))
        free = ~intersects(built, lines)
        spots_m.append(spots[free])
        looks.append(ahead[rays[free]])
    return np.vstack(spots_m), np.vstack(looks)
