"""The models that a street is furnished with, each built once and placed many times."""

from __future__ import annotations

import numpy as np

from sim.shapes.bushes import bush_mesh
from sim.shapes.furniture import (
    advert_column,
    bench,
    bollard,
    cabinet,
    lamp_post,
    litter_bin,
    planter,
    sign_post,
    wheelie_bin,
)
from sim.shapes.trees import SPECIES, tree_mesh
from sim.streets.placing import Thing


class Catalogue:
    """Shared models, so that a hundred trees are a handful of meshes."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.trees = [Thing(tree_mesh(kind, True, rng), "plants", (0.5, 0.5)) for kind in SPECIES]
        self.bushes = [
            Thing(bush_mesh(r, kind, rng), "plants", (1.6 * r, 1.6 * r))
            for r, kind in ((0.5, "lime"), (0.7, "hornbeam"), (0.9, "copper"))
        ]
        self.lamp = Thing(lamp_post(5.6), "furniture", (0.3, 0.3))
        self.bollard = Thing(bollard(), "furniture", (0.16, 0.16))
        self.by_facade = [
            Thing(wheelie_bin(), "furniture", (0.7, 0.6)),
            Thing(wheelie_bin(), "furniture", (0.7, 0.6)),
            Thing(cabinet(), "furniture", (0.42, 1.12)),
            Thing(bench(), "furniture", (0.6, 1.6)),
            Thing(planter(), "furniture", (0.92, 0.92)),
            *self.bushes[:2],
        ]
        self.by_kerb = [
            Thing(litter_bin(), "furniture", (0.52, 0.52)),
            Thing(advert_column(), "furniture", (1.3, 1.3)),
            Thing(planter(), "furniture", (0.92, 0.92)),
            Thing(sign_post(("no_parking",)), "furniture", (0.1, 0.62)),
            Thing(sign_post(("limit", "no_parking")), "furniture", (0.1, 0.62)),
            Thing(cabinet(), "furniture", (0.42, 1.12)),
        ]
        self.signs = {
            n: Thing(sign_post(n), "furniture", (0.1, 0.62))
            for n in (("crossing",), ("warning", "limit"), ("plate",))
        }
