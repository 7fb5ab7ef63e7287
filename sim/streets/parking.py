"""Where cars are parked, and which."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sim.shapes.parked_cars import KINDS, car, outline_m, varied
from sim.streets.network import Bay
from sim.streets.placing import Site, Thing
from sim.streets.scenery import Skin

MODELS = 16


def draw_cars(rng: np.random.Generator) -> tuple[dict[str, Skin], list[Thing]]:
    """Draw the cars that are parked around here, each with its own paint and number plate."""
    skins, things = {}, []
    for k in range(MODELS):
        kind = varied(KINDS[rng.integers(len(KINDS))], rng)
        mesh, skin = car(kind, rng)
        skins[f"car_{k}"] = skin
        things.append(Thing(mesh, f"car_{k}", outline_m(kind)))
    return skins, things


def park(
    site: Site, bays: Sequence[Bay], cars: Sequence[Thing], share: float, rng: np.random.Generator
) -> None:
    """Fill a share of the bays.

    Which bay is taken first, by which car, does not depend on the share. A car comes again only after
    all others.
    """
    order = rng.random(len(bays))
    rounds = -(-len(bays) // len(cars))
    picked = np.concatenate([rng.permutation(len(cars)) for _ in range(rounds)] or [np.zeros(0, int)])
    off_m, turns = rng.normal(0, (0.12, 0.05), (len(bays), 2)), rng.normal(0, 0.02, len(bays))
    around = rng.random(len(bays)) < 0.4
    for k, bay in enumerate(bays):
        yaw = bay.yaw_rad + turns[k] + (np.pi if bay.is_across and around[k] else 0.0)
        ahead = np.array([np.cos(bay.yaw_rad), np.sin(bay.yaw_rad)])
        at = np.array(bay.center_m) + off_m[k, 0] * ahead + off_m[k, 1] * np.array([-ahead[1], ahead[0]])
        site.put_at(cars[picked[k]], at, float(yaw), shown=bool(order[k] < share))
