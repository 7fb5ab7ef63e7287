"""Where things grow: street trees, front gardens with their borders, lots without a house."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sim.shapes.bushes import bush_mesh, hedge_mesh
from sim.shapes.furniture import board_fence, garden_wall, picket_fence
from sim.shapes.mesh import Mesh
from sim.streets.catalogue import Catalogue
from sim.streets.houses import Lot
from sim.streets.placing import Site, Thing


def line_with_trees(street: Site, catalogue: Catalogue, rng: np.random.Generator) -> None:
    for side in (1, -1):
        s = street.path.start_m + rng.uniform(2, 8)
        while s < street.path.end_m - 2:
            tree = catalogue.trees[rng.integers(len(catalogue.trees))]
            street.put(tree, s, street.section.kerb_m(side) + 0.65 * side, rng.uniform(0, 2 * np.pi))
            s += rng.uniform(9.0, 17.0)


def plant_garden(street: Site, lot: Lot, catalogue: Catalogue, rng: np.random.Generator) -> None:
    """A lot without a house: a tall fence along the street, trees and bushes behind it."""
    width = float(np.linalg.norm(lot.front_m[1] - lot.front_m[0]))
    along = lot.front_m[1] - lot.front_m[0]
    at = lot.front_m.mean(axis=0)
    yaw = float(np.arctan2(along[1], along[0])) - np.pi / 2
    fence = Thing(board_fence(width - 0.06), "furniture", (0.1, width - 0.3))
    street.put_at(fence, at, yaw)
    behind = lot.back_m.mean(axis=0)
    length = float(np.linalg.norm(lot.back_m[1] - lot.back_m[0])) - 0.2
    wall = Thing(garden_wall(length, 2.6).moved((0.0, -length / 2, 0.0)), "furniture", (0.26, length))
    street.put_at(wall, behind, yaw)
    low, high = lot.span_m
    for depth, things, count in ((1.5, catalogue.bushes, 3), (3.4, catalogue.trees, 2)):
        for share in (np.arange(count) + 0.5) / count:
            thing = things[rng.integers(len(things))]
            d = lot.front_line_m + lot.side * (lot.setback_m + depth + rng.normal(0, 0.3))
            street.put(thing, low + share * (high - low), d, rng.uniform(0, 6))


def plant_front_gardens(street: Site, lots: list[Lot], rng: np.random.Generator) -> None:
    """Front gardens get a hedge, a fence or a wall with a gap to walk through, and bushes behind."""
    for lot in (lot for lot in lots if lot.setback_m > 1.0 and lot.use != "garden"):
        left, right = lot.front_m
        width = float(np.linalg.norm(right - left))
        along = (right - left) / width
        outward = np.array([along[1], -along[0]])
        fence, depth = _border(rng)
        length = (width - 1.6) / 2
        yaw = float(np.arctan2(along[1], along[0])) - np.pi / 2
        for middle in (0.2 + length / 2, width - 0.2 - length / 2):
            skin = "plants" if depth > 0.4 else "furniture"
            at = left + along * middle + outward * (lot.setback_m - 0.4)
            street.put_at(Thing(fence(length, rng), skin, (depth, length)), at, yaw)
        for share in np.linspace(0.12, 0.88, max(2, round(width / 1.6))):
            s = lot.span_m[0] + share * (lot.span_m[1] - lot.span_m[0])
            radius = float(rng.uniform(0.4, 0.7))
            thing = Thing(bush_mesh(radius, "lime", rng), "plants", (1.5 * radius, 1.5 * radius))
            street.put(thing, s, lot.front_line_m + lot.side * rng.uniform(1.2, 1.9), rng.uniform(0, 6))


def _border(rng: np.random.Generator) -> tuple[Callable[[float, np.random.Generator], Mesh], float]:
    """A maker of one kind of border, centred on the origin and running along +y, and its thickness."""
    kind = rng.integers(3)
    if kind == 0:
        return lambda n, r: picket_fence(n).moved((0.0, -n / 2, 0.0)), 0.1
    if kind == 1:
        return lambda n, r: garden_wall(n).moved((0.0, -n / 2, 0.0)), 0.26
    return lambda n, r: hedge_mesh(n, 1.1, 0.5, "hornbeam", r), 0.6
