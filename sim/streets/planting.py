"""Where things grow: street trees, front gardens with their borders, lots without a house, weeds at walls.

What is drawn does not depend on how much grows: each plant draws whether it grows, and less
vegetation only leaves some of them out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.shapes.bushes import hedge_mesh
from sim.shapes.fences import board_fence, garden_wall, picket_fence
from sim.shapes.mesh import Mesh, box
from sim.streets.catalogue import PLAIN, Catalogue, furniture_skin
from sim.streets.lot import Lot
from sim.streets.placing import KerbSite, Site, Thing

FINE_TREES_M = 10.0  # from the driven line
_BARE_SETBACK_M = 3.0
_BORDER_PIECE_M = 4.0  # of a fence, so that it follows the ground


@dataclass(frozen=True, eq=False)
class Greenery:
    """What there is to plant, and how much of it.

    Attributes:
        catalogue: The plants.
        share: 0 for none, 1 for all.
        rng: Source of randomness.
    """

    catalogue: Catalogue
    share: float
    rng: np.random.Generator

    def grows(self) -> bool:
        """Whether the next plant grows."""
        return bool(self.rng.random() < self.share)


def line_with_trees(street: KerbSite, green: Greenery) -> None:
    """Trees near the kerb at uneven spacings, and weeds where the pavement meets the houses.

    Where a street is bare trees are rare, and nothing grows in the paving.
    """
    rng, kerb = green.rng, street.kerb
    s = kerb.path.start_m + rng.uniform(2, 8)
    while s < kerb.path.end_m - 2:
        fine = street.site.from_route_m(kerb.path.point_m(s)) < FINE_TREES_M
        far_tree = green.catalogue.trees[int(rng.random() * len(green.catalogue.trees))]
        tree, turn = next(green.catalogue.street_trees) if fine else far_tree, rng.uniform(0, 2 * np.pi)
        street.put(tree, s, 0.65, turn, shown=green.grows())
        s += rng.uniform(13.0, 25.0) * (1.0 if kerb.lining == "houses" else 3.0)
    if kerb.lining != "houses":
        return
    for s in street.steps(1.0, 2.3):
        tuft, at = green.catalogue.tufts[rng.integers(2)], s + rng.uniform(-1.0, 1.0)
        if rng.random() < 0.5:
            street.put(tuft, at, kerb.pavement_m - 0.2, rng.uniform(0, 6), 0.0, shown=green.grows())


def plant_garden(site: Site, lot: Lot, green: Greenery) -> None:
    """A lot without a house: a tall fence along the street, a wall behind, trees and bushes between."""
    rng, catalogue = green.rng, green.catalogue
    inward = -lot.outward
    depth = float(np.linalg.norm(lot.back_m.mean(axis=0) - lot.front_m.mean(axis=0)))
    skin = furniture_skin(int(rng.integers(3)))
    _border(site, lot, 0.06, lot.width_m - 0.3, board_fence, skin, 0.1)
    _border(site, lot, depth - 0.2, lot.width_m - 0.8, lambda n: _centred(garden_wall(n, 2.6), n), skin, 0.26)
    conifers = rng.random() < 0.3
    trees: Sequence[Thing] = catalogue.conifers if conifers else catalogue.trees
    beds: tuple[tuple[float, Sequence[Thing], int], ...] = (
        (1.4, catalogue.bushes, 3),
        (0.55 * depth, trees, 2),
    )
    for back, things, count in beds:
        for share in (np.arange(count) + 0.5) / count:
            thing = things[int(rng.integers(len(things)))]
            at = lot.front_m[0] + share * lot.width_m * lot.along + (back + rng.normal(0, 0.3)) * inward
            site.put_at(thing, at, rng.uniform(0, 6), lot.curb_m, shown=green.grows())


def plant_front_garden(site: Site, lot: Lot, green: Greenery) -> None:
    """Behind a border with a gap to walk through, bushes between it and the house."""
    rng, catalogue = green.rng, green.catalogue
    bare = lot.setback_m > _BARE_SETBACK_M
    fence, depth, skin = _plain_border(rng) if bare else _kind_of_border(rng)
    plants = skin == "plants"
    length = (lot.width_m - 1.6) / 2
    out = lot.setback_m - 0.35
    for middle in (0.1 + length / 2, lot.width_m - 0.1 - length / 2):
        shown = green.grows() if plants else True
        at = lot.front_m[0] + middle * lot.along + out * lot.outward
        for piece, shift in _pieces(length):
            thing = Thing(fence(piece), skin, (depth, piece - 0.02))
            site.put_at(thing, at + shift * lot.along, _yaw(lot), lot.curb_m, shown=shown)
    for share in np.linspace(0.12, 0.88, max(2, round(lot.width_m / (5.0 if bare else 2.0)))):
        thing = catalogue.bushes[rng.integers(len(catalogue.bushes))]
        at = lot.front_m[0] + share * lot.width_m * lot.along + rng.uniform(0.9, out - 0.7) * lot.outward
        site.put_at(thing, at, rng.uniform(0, 6), lot.curb_m, shown=green.grows())


def _border(
    site: Site,
    lot: Lot,
    back_m: float,
    length_m: float,
    make: Callable[[float], Mesh],
    skin: str,
    depth: float,
) -> None:
    """A fence along the front of a lot, some way behind it."""
    at = lot.front_m.mean(axis=0) - back_m * lot.outward
    for piece, shift in _pieces(length_m):
        thing = Thing(make(piece), skin, (depth, piece - 0.02))
        site.put_at(thing, at + shift * lot.along, _yaw(lot), lot.curb_m)


def _pieces(length_m: float) -> list[tuple[float, float]]:
    """Lengths of the pieces of a fence, and where the middle of each lies."""
    count = max(1, round(length_m / _BORDER_PIECE_M))
    return [(length_m / count, ((k + 0.5) / count - 0.5) * length_m) for k in range(count)]


def _yaw(lot: Lot) -> float:
    """Heading of a thing that looks out of a lot and runs along its front."""
    outward: Array = lot.outward
    return float(np.arctan2(outward[1], outward[0]))


def _kind_of_border(rng: np.random.Generator) -> tuple[Callable[[float], Mesh], float, str]:
    """A maker of one kind of border, centred on the origin along y, with its thickness and skin."""
    kind, skin = rng.integers(3), furniture_skin(int(rng.integers(3)))
    if kind == 0:
        return lambda n: _centred(picket_fence(n), n), 0.1, skin
    if kind == 1:
        return lambda n: _centred(garden_wall(n), n), 0.26, skin
    return lambda n: hedge_mesh(n, 1.1, 0.5, "hornbeam", rng), 0.6, "plants"


def _plain_border(rng: np.random.Generator) -> tuple[Callable[[float], Mesh], float, str]:
    """A rendered wall, smooth and long, or a hedge."""
    if rng.random() < 0.6:
        height = float(rng.uniform(0.9, 1.7))
        return lambda n: box((-0.1, -n / 2, -0.5), (0.1, n / 2, height)), 0.2, PLAIN
    return lambda n: hedge_mesh(n, 1.25, 0.5, "hornbeam", rng), 0.6, "plants"


def _centred(mesh: Mesh, length_m: float) -> Mesh:
    return mesh.moved((0.0, -length_m / 2, 0.0))
