"""The rules by which a street is furnished: what stands where, and what gives way to what."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from estimator.se3 import Array
from sim.paint.facade import paint_render
from sim.paint.furniture import furniture_glow, paint_furniture
from sim.paint.plants import paint_plants
from sim.paint.tagged import paint_tagged
from sim.streets.backdrop import plant_backdrop
from sim.streets.catalogue import PLAIN, SKINS, TAGGED, Catalogue, furniture_skin
from sim.streets.footprint import Ground, rectangle_m
from sim.streets.islands import furnish_islands
from sim.streets.lamps import Lamp, line_with_lamps
from sim.streets.lot import Lot
from sim.streets.motorway_sides import line_motorways
from sim.streets.network import Network
from sim.streets.parking import draw_cars, paint_cars, park
from sim.streets.placing import TO_STREET, KerbSite, Site, Thing
from sim.streets.planting import Greenery, line_with_trees, plant_front_garden, plant_garden
from sim.streets.scenery import Scenery, Skin
from sim.streets.signing import draw_names, sign_crossings, sign_junctions
from sim.streets.tunnels import build_tunnels

CAR_M = (4.8, 1.95)  # ground kept for a parked car


def furnish(
    network: Network,
    lots: Sequence[Lot],
    driven_m: Array,
    parking: float,
    vegetation: float,
    rng: np.random.Generator,
) -> tuple[Scenery, tuple[Lamp, ...]]:
    """Furnish every kerb, garden and bay of a network.

    Args:
        network: The plan.
        lots: What is built up.
        driven_m: (N, 2) polyline of the driven lane.
        parking: Share of bays taken.
        vegetation: Share of plants that grow.
        rng: Source of randomness.

    Returns:
        What stands there, and what of it shines at night.
    """
    paint, cars, bays, plants, trees, gardens, things, middles, *beyond = rng.spawn(12)
    verges, barriers, tunnels, copses = beyond
    catalogue = Catalogue(plants)
    built = [lot.outline_m for lot in lots if lot.use != "garden"]
    behind = Site("garden", Ground(list(built)), network.relief, driven_m)
    for lot, stream in zip(lots, gardens.spawn(len(lots)), strict=True):
        green = Greenery(catalogue, vegetation, stream)
        if lot.use == "garden":
            plant_garden(behind, lot, green)
        elif lot.use == "house" and lot.setback_m > 1.0:
            plant_front_garden(behind, lot, green)
    if any(kerb.lining == "houses" for kerb in network.kerbs):
        plant_backdrop(behind, network, lots, driven_m, Greenery(catalogue, vegetation, copses))
    models = draw_cars(cars)
    parked = Site("parked", Ground([]), network.relief, driven_m)
    park(parked, network.bays, models, parking, bays)
    car_skins = paint_cars(models, parked.props)
    street = Site("street", _without_bays(network, behind.ground.taken_m), network.relief, driven_m)
    lamps = _furnish_kerbs(street, network, catalogue, Greenery(catalogue, vegetation, trees), things)
    lamps += furnish_islands(street, network, Greenery(catalogue, vegetation, middles))
    sides = line_motorways(street, network, Greenery(catalogue, vegetation, verges), barriers)
    covered, ceiling = build_tunnels(network, tunnels)
    standing = Scenery((*behind.props, *parked.props, *street.props), _skins(paint) | car_skins)
    return standing + sides + covered, (*lamps, *ceiling)


def _without_bays(network: Network, built: list[Array]) -> Ground:
    bays = [rectangle_m(np.array(bay.center_m), bay.yaw_rad, *CAR_M) for bay in network.bays]
    return Ground([*built, *bays])


def _furnish_kerbs(
    site: Site, network: Network, catalogue: Catalogue, green: Greenery, rng: np.random.Generator
) -> list[Lamp]:
    """Signs first, since they must be seen; then lamps, trees, and smaller things where there is room."""
    streets = [KerbSite(site, kerb) for kerb in network.kerbs if kerb.lining in ("houses", "bare")]
    sign_junctions(streets, network, catalogue)
    sign_crossings(streets, catalogue)
    lamps: list[Lamp] = []
    for street in streets:
        lamps += line_with_lamps(street, catalogue, lamps)
    for street in streets:
        line_with_trees(street, green)
        if street.kerb.lining == "houses":
            _scatter(street, catalogue, rng)
    return lamps


def _scatter(street: KerbSite, catalogue: Catalogue, rng: np.random.Generator) -> None:
    """Smaller things along facades and kerbs, where there is room; no model comes twice in a row."""
    by_facade, by_kerb = _turns(catalogue.by_facade, rng), _turns(catalogue.by_kerb, rng)
    for k, s in enumerate(street.steps(1.0, 2.6)):
        at, here = s + rng.uniform(-1, 1), rng.random() < 0.45
        if here:
            thing = next(by_facade[k % len(by_facade)])
            street.put(thing, at, street.kerb.pavement_m - thing.size_m[0] / 2 - 0.36, TO_STREET)
    for k, s in enumerate(street.steps(2.0, 6.0)):
        at, here = s + rng.uniform(-2, 2), rng.random() < 0.75
        if here:
            thing = next(by_kerb[k % len(by_kerb)])
            street.put(thing, at, thing.size_m[0] / 2 + 0.25, 0.0)


def _turns(models: Sequence[Iterator[Thing]], rng: np.random.Generator) -> list[Iterator[Thing]]:
    return [models[k] for k in rng.permutation(len(models))]


def _skins(rng: np.random.Generator) -> dict[str, Skin]:
    names, leaves, render, marks, *coats = rng.spawn(4 + SKINS)
    plates, glow = draw_names(names), furniture_glow()
    skins = {
        furniture_skin(k): Skin(paint_furniture(plates[k], coat), 0.1, glow) for k, coat in enumerate(coats)
    }
    skins[TAGGED] = Skin(paint_tagged(marks), 0.1)
    return skins | {"plants": Skin(paint_plants(leaves)), PLAIN: Skin(paint_render(render))}
