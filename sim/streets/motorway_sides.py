"""What lines a motorway: guard rails, noise walls in stretches, bushes between them, gantries."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from estimator.se3 import Array
from sim.paint.roadside import DESTINATIONS, paint_boards, paint_marker, paint_noise_wall, paint_rail
from sim.shapes.mesh import Mesh
from sim.shapes.roadside import gantry_boards, gantry_frame, guard_rail, marker_post, noise_wall
from sim.streets.kerb import KerbLine
from sim.streets.network import Network
from sim.streets.placing import KerbSite, Site
from sim.streets.planting import Greenery
from sim.streets.road import Road
from sim.streets.scenery import NOTHING, Prop, Scenery, Skin

_PIECE_M, _STEP_M = 24.0, 2.0
_RAIL_FROM_EDGE_M, _WALL_FROM_EDGE_M = 0.7, 5.2
_WALLS_M, _GAPS_M = (48.0, 110.0), (36.0, 80.0)
_WALL_HEIGHT_M = 3.8
_POST_FROM_EDGE_M = 1.45  # behind the rail
_MARKER_FROM_EDGE_M, _MARKER_EVERY_M = 1.05, 50.0
_COPSE_M = (9.0, 46.0)  # from the edge: where trees stand together behind a gap
_GANTRY_FIRST_M, _GANTRY_EVERY_M = (32.0, 48.0), (120.0, 170.0)


def line_motorways(site: Site, network: Network, green: Greenery, rng: np.random.Generator) -> Scenery:
    """Line every kerb that carries a crash barrier; plants stand on the site."""
    kerbs = [kerb for kerb in network.kerbs if kerb.lining == "barrier"]
    if not kerbs:
        return NOTHING
    rail_rng, wall_rng, gantry_rng, plant_rng, marker_rng = rng.spawn(5)
    scenery = Scenery((), {"rail": Skin(paint_rail(rail_rng), 0.3), "marker": Skin(paint_marker(marker_rng))})
    marker = marker_post()
    for k, (kerb, walls) in enumerate(zip(kerbs, wall_rng.spawn(len(kerbs)), strict=True)):
        scenery += _rails(f"rail_{k}", kerb, network)
        if kerb.pavement_m > _WALL_FROM_EDGE_M:
            scenery += _markers(f"marker_{k}", kerb, network, marker)
            stretches = _stretches(kerb, walls)
            scenery += _walls(f"noise_wall_{k}", kerb, stretches, network, walls)
            street = KerbSite(site, kerb)
            _bushes(street, stretches, Greenery(green.catalogue, green.share, plant_rng))
            _copses(street, stretches, Greenery(green.catalogue, green.share, plant_rng))
    roads = [road for road in network.roads if road.style == "motorway"]
    for road, stream in zip(roads, gantry_rng.spawn(len(roads)), strict=True):
        scenery += _gantries(road, network, stream)
    return scenery


def _line(kerb: KerbLine, low: float, high: float, d_m: float, network: Network) -> Array:
    xy = kerb.path.point_m(np.linspace(low, high, max(2, round((high - low) / _STEP_M) + 1)), d_m)
    return np.column_stack([xy, network.relief.height_m(xy)])


def _pieces(low: float, high: float) -> Sequence[tuple[float, float]]:
    return list(pairwise(np.linspace(low, high, max(1, round((high - low) / _PIECE_M)) + 1)))


def _rails(name: str, kerb: KerbLine, network: Network) -> Scenery:
    start = kerb.path.start_m
    props = []
    for k, (low, high) in enumerate(_pieces(start, kerb.path.end_m)):
        line = _line(kerb, low, high, _RAIL_FROM_EDGE_M, network)
        props.append(Prop(f"{name}_{k}", guard_rail(line, low - start, both_sides=False), "rail"))
    return Scenery(tuple(props), {})


def _markers(name: str, kerb: KerbLine, network: Network, marker: Mesh) -> Scenery:
    """Posts behind the rail, as far apart as everywhere, so that drivers can judge distances by them."""
    places = np.arange(kerb.path.start_m + _MARKER_EVERY_M / 2, kerb.path.end_m, _MARKER_EVERY_M)
    props = []
    for k, s in enumerate(places):
        x, y = kerb.path.point_m(s, _MARKER_FROM_EDGE_M)
        place = (float(x), float(y), float(network.relief.height_m(np.array([x, y]))))
        props.append(Prop(f"{name}_{k}", marker, "marker", place, float(kerb.path.heading_rad(s))))
    return Scenery(tuple(props), {})


def _stretches(kerb: KerbLine, rng: np.random.Generator) -> list[tuple[float, float]]:
    """Where noise walls stand."""
    found, at = [], kerb.path.start_m + float(rng.uniform(0.0, 60.0))
    while at < kerb.path.end_m - 20.0:
        end = min(at + float(rng.uniform(*_WALLS_M)), kerb.path.end_m)
        found.append((at, end))
        at = end + float(rng.uniform(*_GAPS_M))
    return found


def _walls(
    name: str,
    kerb: KerbLine,
    stretches: list[tuple[float, float]],
    network: Network,
    rng: np.random.Generator,
) -> Scenery:
    scenery = NOTHING
    for j, stretch in enumerate(stretches):
        kind = int(rng.integers(3))
        for k, (low, high) in enumerate(_pieces(*stretch)):
            skin = f"{name}_{j}_{k}"
            mesh = noise_wall(_line(kerb, low, high, _WALL_FROM_EDGE_M, network), _WALL_HEIGHT_M)
            image = paint_noise_wall(high - low, _WALL_HEIGHT_M, kind, rng)
            scenery += Scenery((Prop(skin, mesh, skin),), {skin: Skin(image)})
    return scenery


def _bushes(street: KerbSite, walls: list[tuple[float, float]], green: Greenery) -> None:
    """Bushes and trees on the verge: before walls a few, in the gaps between them a thicket."""
    rng = green.rng
    for s in street.steps(1.0, 2.6):
        walled = any(low - 2.0 < s < high + 2.0 for low, high in walls)
        is_tree = bool(rng.random() < 0.3) and not walled
        far = _WALL_FROM_EDGE_M + rng.uniform(0.6, 1.6) if not walled else rng.uniform(2.6, 4.0)
        things = green.catalogue.trees if is_tree else green.catalogue.bushes
        thing, turn = things[int(rng.integers(len(things)))], rng.uniform(0, 6)
        if rng.random() < (0.3 if walled else 0.9):
            street.put(thing, s + rng.uniform(-1, 1), far, turn, 0.0, shown=green.grows())


def _copses(street: KerbSite, walls: list[tuple[float, float]], green: Greenery) -> None:
    """Trees and thickets on the land beyond, seen over the gaps between the walls."""
    rng, catalogue = green.rng, green.catalogue
    for s in street.steps(6.0, 15.0):
        at = s + rng.uniform(-5.0, 5.0)
        walled = any(low < at < high for low, high in walls)
        for _ in range(int(rng.integers(1, 5))):
            things = catalogue.thickets if rng.random() < 0.5 else catalogue.trees
            thing, d = things[int(rng.integers(len(things)))], rng.uniform(*_COPSE_M)
            spot = street.kerb.path.point_m(at + rng.normal(0, 3.0), d)
            street.site.put_at(thing, spot, rng.uniform(0, 6), shown=green.grows() and not walled)


def _gantries(road: Road, network: Network, rng: np.random.Generator) -> Scenery:
    scenery, at = NOTHING, float(rng.uniform(*_GANTRY_FIRST_M))
    names = [str(name) for name in rng.permutation(DESTINATIONS)]
    middles = np.array([strip.d_m for strip in road.strips])[::-1]
    count = 0
    while at < road.path.end_m:
        skin = f"gantry_{road.name}_{count}"
        picked = [names[(2 * len(middles) * count + k) % len(names)] for k in range(2 * len(middles))]
        routes = [(picked[2 * k], picked[2 * k + 1], int(rng.integers(2, 99))) for k in range(len(middles))]
        x, y = road.path.point_m(at)
        yaw = float(road.path.heading_rad(at))
        z = float(network.relief.height_m(np.array([x, y])))
        place = ((float(x), float(y), z), yaw)
        frame = gantry_frame(road.right_m - _POST_FROM_EDGE_M, road.left_m + _POST_FROM_EDGE_M, middles)
        scenery += Scenery(
            (Prop(f"{skin}_frame", frame, "rail", *place), Prop(skin, gantry_boards(middles), skin, *place)),
            {skin: Skin(paint_boards(routes))},
        )
        at, count = at + float(rng.uniform(*_GANTRY_EVERY_M)), count + 1
    return scenery
