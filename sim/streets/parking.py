"""Where cars are parked, and which."""

from __future__ import annotations

import numpy as np

from sim.shapes.parked_cars import KINDS, car, outline_m
from sim.streets.layout import BAY_M, Layout
from sim.streets.placing import Site, Thing
from sim.streets.scenery import Skin

CAR_SKINS = 7


def draw_cars(rng: np.random.Generator) -> tuple[dict[str, Skin], list[Thing]]:
    skins, things = {}, []
    for k in range(CAR_SKINS):
        kind = KINDS[rng.integers(len(KINDS))]
        mesh, skin = car(kind, rng)
        skins[f"car_{k}"] = skin
        things.append(Thing(mesh, f"car_{k}", outline_m(kind), 0.0))
    return skins, things


def park(street: Site, layout: Layout, cars: list[Thing], rng: np.random.Generator) -> None:
    """Two bays in three are taken; cars point along their side's traffic."""
    side = street.section.parking_side
    d = street.section.kerb_m(side) - side * 1.08
    clear = layout.mouth_m if side == layout.junction.side else (1e9, 1e9)
    for s in np.arange(street.path.start_m, street.path.end_m - BAY_M, BAY_M):
        if clear[0] - 6.0 < s < clear[1] + 0.5 or rng.random() > 0.6:
            continue
        thing = cars[rng.integers(len(cars))]
        turn = (np.pi if side > 0 else 0.0) + rng.normal(0, 0.02)
        street.put(thing, s + BAY_M / 2 + rng.normal(0, 0.12), d + rng.normal(0, 0.05), turn)


def park_side(street: Site, cars: list[Thing], rng: np.random.Generator) -> None:
    for s in np.arange(14.0, street.path.end_m - 5.0, 6.0):
        if rng.random() < 0.6:
            street.put(cars[rng.integers(len(cars))], s, street.section.kerb_right_m + 1.05, 0.0)
