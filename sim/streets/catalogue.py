"""The models that a street is furnished with, each built once and placed many times."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import cycle

import numpy as np

from sim.paint.tagged import COUNTS
from sim.shapes.bushes import bush_mesh, tuft_mesh
from sim.shapes.furniture import (
    advert_column,
    bench,
    bike_rack,
    bollard,
    cabinet,
    lamp_post,
    litter_bin,
    parking_meter,
    planter,
    post_box,
    sign_post,
    wheelie_bin,
)
from sim.shapes.mesh import Mesh
from sim.shapes.trees import SPECIES, SPRUCE, Species, tree_mesh
from sim.streets.placing import Thing

PLAIN = "plain"  # skin of rendered walls
SKINS = 3  # furniture comes in as many coats, each with its own names of streets
TAGGED = "furniture_tagged"  # skin of what bears posters, stickers and tags; each piece differs
PLATES = 4  # names of streets on each
_BUSHES = (
    (0.45, "lime"),
    (0.6, "hornbeam"),
    (0.75, "plane"),
    (0.55, "copper"),
    (0.9, "hornbeam"),
    (0.5, "birch"),
)


class Catalogue:
    """Shared models, so that a hundred trees are a handful of meshes.

    ``by_facade`` and ``by_kerb`` yield one thing after another of each model: what bears marks comes again
    only when all its pieces have been handed out. ``street_trees`` are for what is seen from near, and come
    again only after all others too.
    """

    def __init__(self, rng: np.random.Generator) -> None:
        avenue = rng.spawn(1)[0]
        grown = [_tree(kind, True, rng) for kind in (*SPECIES, *SPECIES[:4])]
        grown += [_tree(kind, True, avenue) for kind in (*SPECIES[4:], *SPECIES, *SPECIES)]
        self.street_trees = cycle([grown[k] for k in avenue.permutation(len(grown))])
        self.trees = [_tree(kind, False, rng) for kind in (*SPECIES, *SPECIES[:2])]
        self.conifers = [_tree(SPRUCE, False, rng) for _ in range(2)]
        self.bushes = [Thing(bush_mesh(r, kind, rng), "plants", (1.5 * r, 1.5 * r)) for r, kind in _BUSHES]
        self.thickets = [
            Thing(bush_mesh(r, kind, rng), "plants", (r, r)) for r, kind in ((1.7, "lime"), (2.4, "hornbeam"))
        ]
        self.tufts = [Thing(tuft_mesh(kind, rng), "plants", (0.2, 0.2)) for kind in ("lime", "birch")]
        self.lamp = _thing(lamp_post(5.6), (0.3, 0.3), 0)
        self.bollard = _thing(bollard(), (0.16, 0.16), 0)
        cabinets = _pieces(cabinet, COUNTS["cabinet"], (0.42, 1.12))
        bins = _pieces(litter_bin, COUNTS["bin"], (0.52, 0.52))
        columns = _pieces(advert_column, COUNTS["column"], (1.3, 1.3))
        self.by_facade = [cabinets] * SKINS + _coats(
            (wheelie_bin, (0.7, 0.6)),
            (bench, (0.6, 1.6)),
            (planter, (0.92, 0.92)),
            (bike_rack, (0.6, 1.9)),
        )
        self.by_kerb = [each for each in (bins, columns, cabinets) for _ in range(SKINS)] + _coats(
            (parking_meter, (0.34, 0.34)),
            (post_box, (0.44, 0.56)),
            (lambda: sign_post(("no_parking",)), (0.1, 0.62)),
            (lambda: sign_post(("limit", "no_parking")), (0.1, 0.62)),
        )
        names = (("crossing",), ("warning", "limit"), ("give_way",), ("priority",), ("stop",), ("no_entry",))
        self.signs = {
            faces: _thing(sign_post(faces), (0.1, 0.62), k % SKINS) for k, faces in enumerate(names)
        }
        self.plates = [
            _thing(sign_post((f"plate_{k}",)), (0.1, 0.9), skin)
            for skin in range(SKINS)
            for k in range(PLATES)
        ]


def furniture_skin(coat: int) -> str:
    """Name of the skin of one coat."""
    return f"furniture_{coat}"


def _thing(mesh: Mesh, size_m: tuple[float, float], coat: int) -> Thing:
    return Thing(mesh, furniture_skin(coat), size_m)


def _coats(*makers: tuple[Callable[[], Mesh], tuple[float, float]]) -> list[Iterator[Thing]]:
    """Every model once in every coat."""
    built = [(make(), size_m) for make, size_m in makers]
    return [cycle([_thing(mesh, size_m, coat)]) for mesh, size_m in built for coat in range(SKINS)]


def _pieces(make: Callable[[int], Mesh], count: int, size_m: tuple[float, float]) -> Iterator[Thing]:
    """One model with ever other marks."""
    return cycle([Thing(make(index), TAGGED, size_m) for index in range(count)])


def _tree(species: Species, fine: bool, rng: np.random.Generator) -> Thing:
    return Thing(tree_mesh(species, fine, rng), "plants", (0.5, 0.5))
