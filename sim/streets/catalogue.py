"""The models that a street is furnished with, each built once and placed many times."""

from __future__ import annotations

import numpy as np

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
from sim.shapes.vegetation import bush_mesh, tree_mesh
from sim.streets.placing import Thing


class Catalogue:
    """Shared models, so that a hundred trees are a handful of meshes."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.trees = [
            Thing(tree_mesh(h, c, rng), "plants", (0.5, 0.5))
            for h, c in ((6.2, 1.5), (7.4, 1.8), (5.4, 1.4), (8.2, 2.0))
        ]
        self.bushes = [
            Thing(bush_mesh(r, rng), "plants", (2 * r * 0.8, 2 * r * 0.8)) for r in (0.5, 0.7, 0.9)
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
