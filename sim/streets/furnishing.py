"""The rules by which a street is furnished: what stands where, and what gives way to what."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture import paint_furniture
from sim.paint.markings import ZEBRA_M, zebra_starts_m
from sim.paint.plants import paint_plants
from sim.streets.catalogue import Catalogue
from sim.streets.footprint import Ground
from sim.streets.houses import Lot
from sim.streets.layout import Layout
from sim.streets.parking import draw_cars, park, park_side
from sim.streets.placing import Site
from sim.streets.planting import line_with_trees, plant_front_gardens, plant_garden
from sim.streets.scenery import Scenery, Skin


def furnish(layout: Layout, lots: list[Lot], rng: np.random.Generator) -> Scenery:
    """Furnish the main street and the side street."""
    skins, cars, main_rng, side_rng, garden_rng, models = rng.spawn(6)
    ground = Ground([lot.outline_m for lot in lots if lot.use != "garden"])
    main = Site("main", layout.path, layout.section, ground, _kept_clear(layout))
    start = abs(layout.section.kerb_m(layout.junction.side)) + layout.junction.corner_m + 3.0
    side = Site("side", layout.junction.path, layout.junction.section, ground, [(-99.0, start)])
    catalogue = Catalogue(models)
    for lot in (lot for lot in lots if lot.use == "garden"):
        plant_garden(main if lot.path is layout.path else side, lot, catalogue, garden_rng)
    plant_front_gardens(main, lots, garden_rng)
    car_skins, car_things = draw_cars(cars)
    park(main, layout, car_things, main_rng)
    park_side(side, car_things, side_rng)
    _mark_junction(main, layout, catalogue)
    for street, one in ((main, main_rng), (side, side_rng)):
        line_with_trees(street, catalogue, one)
        _line_with_lamps(street, catalogue)
        _scatter(street, catalogue, one)
    paint, leaves = skins.spawn(2)
    own = {"furniture": Skin(paint_furniture(paint), 0.1), "plants": Skin(paint_plants(leaves))}
    return Scenery((*main.props, *side.props), own | car_skins)


def _kept_clear(layout: Layout) -> list[tuple[float, float]]:
    """Stretches of s where nothing may stand: the mouth, and the zebra crossings."""
    zebras = [(z - 0.6, z + ZEBRA_M + 0.6) for z in zebra_starts_m(layout)]
    first, last = layout.mouth_m
    return [(first - 0.2, last + 0.2), *zebras]


def _mark_junction(street: Site, layout: Layout, catalogue: Catalogue) -> None:
    """Signs before the zebra and the bend, a name plate and bollards at the corners."""
    right, left = street.section.kerb_right_m - 0.35, street.section.kerb_left_m + 0.35
    zebra = zebra_starts_m(layout)[0]
    street.put(catalogue.signs["crossing",], zebra - 1.0, right, np.pi)
    street.put(catalogue.signs["crossing",], zebra + ZEBRA_M + 1.0, left, 0.0)
    street.put(catalogue.signs["warning", "limit"], layout.bend_start_m - 5.0, right, np.pi)
    street.put(catalogue.signs["warning", "limit"], layout.bend_end_m + 4.0, left, 0.0)
    junction = layout.junction
    edge = street.section.kerb_m(junction.side) + 0.4 * junction.side
    for s in (layout.mouth_m[0] - 0.4, layout.mouth_m[1] + 0.4):
        for k in range(3):
            street.put(catalogue.bollard, s + np.sign(s - junction.s_m) * 1.5 * k, edge, 0.0)
    street.put(catalogue.signs["plate",], layout.mouth_m[1] + 0.5, edge + 0.6 * junction.side, 0.0)


def _line_with_lamps(street: Site, catalogue: Catalogue) -> None:
    for k, s in enumerate(np.arange(street.path.start_m + 5.0, street.path.end_m, 13.0)):
        side = 1 if k % 2 else -1
        for shift in (0.0, 1.2, -1.2, 2.4):
            if street.put(
                catalogue.lamp, s + shift, street.section.kerb_m(side) + 0.4 * side, -side * np.pi / 2
            ):
                break


def _scatter(street: Site, catalogue: Catalogue, rng: np.random.Generator) -> None:
    """Smaller things along facades and kerbs, where there is room."""
    for side in (1, -1):
        inward = -side * np.pi / 2
        for s in np.arange(street.path.start_m + 1, street.path.end_m - 1, 2.6):
            if rng.random() < 0.5:
                thing = catalogue.by_facade[rng.integers(len(catalogue.by_facade))]
                d = street.section.front_m(side) - side * (thing.size_m[0] / 2 + 0.36)
                street.put(thing, s + rng.uniform(-1, 1), d, inward)
        for s in np.arange(street.path.start_m + 2, street.path.end_m - 1, 6.0):
            if rng.random() < 0.75:
                thing = catalogue.by_kerb[rng.integers(len(catalogue.by_kerb))]
                d = street.section.kerb_m(side) + side * (thing.size_m[0] / 2 + 0.25)
                street.put(thing, s + rng.uniform(-2, 2), d, np.pi if side < 0 else 0.0)
