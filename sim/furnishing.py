"""The rules by which a street is furnished: what stands where, and what gives way to what."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.footprint import Ground, rectangle_m
from sim.furniture import (
    advert_column,
    bench,
    board_fence,
    bollard,
    cabinet,
    garden_wall,
    lamp_post,
    litter_bin,
    picket_fence,
    planter,
    sign_post,
    wheelie_bin,
)
from sim.ground import KERB_M
from sim.houses import Lot
from sim.parked_cars import KINDS, car, outline_m
from sim.scenery import Prop, Scenery, Skin
from sim.street_layout import Layout, Section
from sim.street_mesh import Mesh
from sim.street_path import Path
from sim.textures_furniture import paint_furniture
from sim.textures_markings import ZEBRA_M, zebra_starts_m
from sim.textures_plants import paint_plants
from sim.vegetation import bush_mesh, hedge_mesh, tree_mesh

BAY_M = 5.6
CAR_SKINS = 7


@dataclass(frozen=True, eq=False)
class _Thing:
    """A mesh ready to be placed: its skin, its size on the ground (along its yaw, across), its foot."""

    mesh: Mesh
    skin: str
    size_m: tuple[float, float]
    z_m: float = KERB_M


class _Street:
    """One street being furnished: turns street coordinates into props and keeps things apart."""

    def __init__(
        self, name: str, path: Path, section: Section, ground: Ground, keep_clear_m: list[tuple[float, float]]
    ) -> None:
        self.name, self.path, self.section = name, path, section
        self.props: list[Prop] = []
        self._ground, self._keep_clear_m = ground, keep_clear_m

    def put(self, thing: _Thing, s_m: float, d_m: float, turn_rad: float, clearance_m: float = 0.1) -> bool:
        """Place a thing unless it would stand in something else or on ground kept clear."""
        if any(low < s_m < high for low, high in self._keep_clear_m):
            return False
        at, yaw = self.path.point_m(s_m, d_m), float(self.path.heading_rad(s_m)) + turn_rad
        return self.put_at(thing, at, yaw, clearance_m)

    def put_at(self, thing: _Thing, at: Array, yaw: float, clearance_m: float = 0.0) -> bool:
        """Place a thing at a world position unless it would stand in something else."""
        outline = rectangle_m(at, yaw, *thing.size_m)
        if not self._ground.claim(outline, clearance_m):
            return False
        name = f"{self.name}_{len(self.props)}"
        self.props.append(
            Prop(name, thing.mesh, thing.skin, (float(at[0]), float(at[1]), thing.z_m), yaw, outline)
        )
        return True


def furnish(layout: Layout, lots: list[Lot], rng: np.random.Generator) -> Scenery:
    """Furnish the main street and the side street."""
    skins, cars, main_rng, side_rng, garden_rng, models = rng.spawn(6)
    ground = Ground([lot.outline_m for lot in lots if lot.use != "garden"])
    main = _Street("main", layout.path, layout.section, ground, _kept_clear(layout))
    start = abs(layout.section.kerb_m(layout.junction.side)) + layout.junction.corner_m + 3.0
    side = _Street("side", layout.junction.path, layout.junction.section, ground, [(-99.0, start)])
    catalogue = _Catalogue(models)
    _plant_front_gardens(main, lots, garden_rng)
    for lot in (lot for lot in lots if lot.use == "garden"):
        _plant_garden(main if lot.path is layout.path else side, lot, catalogue, garden_rng)
    car_skins, car_things = _draw_cars(cars)
    _park(main, layout, car_things, main_rng)
    _park_side(side, car_things, side_rng)
    _mark_junction(main, layout, catalogue)
    for street, one in ((main, main_rng), (side, side_rng)):
        _line_with_trees(street, catalogue, one)
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


class _Catalogue:
    """Shared models, so that a hundred trees are a handful of meshes."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.trees = [
            _Thing(tree_mesh(h, c, rng), "plants", (0.5, 0.5))
            for h, c in ((6.2, 1.5), (7.4, 1.8), (5.4, 1.4), (8.2, 2.0))
        ]
        self.bushes = [
            _Thing(bush_mesh(r, rng), "plants", (2 * r * 0.8, 2 * r * 0.8)) for r in (0.5, 0.7, 0.9)
        ]
        self.lamp = _Thing(lamp_post(5.6), "furniture", (0.3, 0.3))
        self.bollard = _Thing(bollard(), "furniture", (0.16, 0.16))
        self.by_facade = [
            _Thing(wheelie_bin(), "furniture", (0.7, 0.6)),
            _Thing(wheelie_bin(), "furniture", (0.7, 0.6)),
            _Thing(cabinet(), "furniture", (0.42, 1.12)),
            _Thing(bench(), "furniture", (0.6, 1.6)),
            _Thing(planter(), "furniture", (0.92, 0.92)),
            *self.bushes[:2],
        ]
        self.by_kerb = [
            _Thing(litter_bin(), "furniture", (0.52, 0.52)),
            _Thing(advert_column(), "furniture", (1.3, 1.3)),
            _Thing(planter(), "furniture", (0.92, 0.92)),
            _Thing(sign_post(("no_parking",)), "furniture", (0.1, 0.62)),
            _Thing(sign_post(("limit", "no_parking")), "furniture", (0.1, 0.62)),
            _Thing(cabinet(), "furniture", (0.42, 1.12)),
        ]
        self.signs = {
            n: _Thing(sign_post(n), "furniture", (0.1, 0.62))
            for n in (("crossing",), ("warning", "limit"), ("plate",))
        }


def _draw_cars(rng: np.random.Generator) -> tuple[dict[str, Skin], list[_Thing]]:
    skins, things = {}, []
    for k in range(CAR_SKINS):
        kind = KINDS[rng.integers(len(KINDS))]
        mesh, skin = car(kind, rng)
        skins[f"car_{k}"] = skin
        things.append(_Thing(mesh, f"car_{k}", outline_m(kind), 0.0))
    return skins, things


def _park(street: _Street, layout: Layout, cars: list[_Thing], rng: np.random.Generator) -> None:
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


def _park_side(street: _Street, cars: list[_Thing], rng: np.random.Generator) -> None:
    for s in np.arange(14.0, street.path.end_m - 5.0, 6.0):
        if rng.random() < 0.6:
            street.put(cars[rng.integers(len(cars))], s, street.section.kerb_right_m + 1.05, 0.0)


def _mark_junction(street: _Street, layout: Layout, catalogue: _Catalogue) -> None:
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


def _line_with_trees(street: _Street, catalogue: _Catalogue, rng: np.random.Generator) -> None:
    for side in (1, -1):
        s = street.path.start_m + rng.uniform(2, 8)
        while s < street.path.end_m - 2:
            tree = catalogue.trees[rng.integers(len(catalogue.trees))]
            street.put(tree, s, street.section.kerb_m(side) + 0.65 * side, rng.uniform(0, 2 * np.pi))
            s += rng.uniform(9.0, 17.0)


def _line_with_lamps(street: _Street, catalogue: _Catalogue) -> None:
    for k, s in enumerate(np.arange(street.path.start_m + 5.0, street.path.end_m, 13.0)):
        side = 1 if k % 2 else -1
        for shift in (0.0, 1.2, -1.2, 2.4):
            if street.put(
                catalogue.lamp, s + shift, street.section.kerb_m(side) + 0.4 * side, -side * np.pi / 2
            ):
                break


def _scatter(street: _Street, catalogue: _Catalogue, rng: np.random.Generator) -> None:
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


def _plant_garden(street: _Street, lot: Lot, catalogue: _Catalogue, rng: np.random.Generator) -> None:
    """A lot without a house: a tall fence along the street, trees and bushes behind it."""
    width = float(np.linalg.norm(lot.front_m[1] - lot.front_m[0]))
    along = lot.front_m[1] - lot.front_m[0]
    at = lot.front_m.mean(axis=0)
    yaw = float(np.arctan2(along[1], along[0])) - np.pi / 2
    fence = _Thing(board_fence(width - 0.06), "furniture", (0.1, width - 0.3))
    street.put_at(fence, at, yaw)
    behind = lot.back_m.mean(axis=0)
    length = float(np.linalg.norm(lot.back_m[1] - lot.back_m[0])) - 0.2
    wall = _Thing(garden_wall(length, 2.6).moved((0.0, -length / 2, 0.0)), "furniture", (0.26, length))
    street.put_at(wall, behind, yaw)
    low, high = lot.span_m
    for depth, things, count in ((1.5, catalogue.bushes, 3), (3.4, catalogue.trees, 2)):
        for share in (np.arange(count) + 0.5) / count:
            thing = things[rng.integers(len(things))]
            d = lot.front_line_m + lot.side * (lot.setback_m + depth + rng.normal(0, 0.3))
            street.put(thing, low + share * (high - low), d, rng.uniform(0, 6))


def _plant_front_gardens(street: _Street, lots: list[Lot], rng: np.random.Generator) -> None:
    """Front gardens get a hedge, a fence or a wall with a gap to walk through, and bushes behind."""
    for lot in (lot for lot in lots if lot.setback_m > 1.0 and lot.use != "garden"):
        left, right = lot.front_m
        width = float(np.linalg.norm(right - left))
        fence, depth = _border(rng)
        length = (width - 1.4) / 2
        for low in (0.1, width - 0.1 - length):
            middle = low + length / 2
            share = middle / width
            s = lot.span_m[0] + (share if lot.side > 0 else 1 - share) * (lot.span_m[1] - lot.span_m[0])
            mesh = fence(length, rng)
            street.put(
                _Thing(mesh, "plants" if depth > 0.4 else "furniture", (depth, length)),
                s,
                lot.front_line_m + 0.35 * lot.side,
                np.pi / 2 - np.pi / 2 * lot.side,
            )
        for share in np.linspace(0.12, 0.88, max(2, round(width / 1.6))):
            s = lot.span_m[0] + share * (lot.span_m[1] - lot.span_m[0])
            radius = float(rng.uniform(0.4, 0.7))
            thing = _Thing(bush_mesh(radius, rng), "plants", (1.5 * radius, 1.5 * radius))
            street.put(thing, s, lot.front_line_m + lot.side * rng.uniform(1.2, 1.9), rng.uniform(0, 6))


def _border(rng: np.random.Generator) -> tuple[Callable[[float, np.random.Generator], Mesh], float]:
    """A maker of one kind of border, centred on the origin and running along +y, and its thickness."""
    kind = rng.integers(3)
    if kind == 0:
        return lambda n, r: picket_fence(n).moved((0.0, -n / 2, 0.0)), 0.1
    if kind == 1:
        return lambda n, r: garden_wall(n).moved((0.0, -n / 2, 0.0)), 0.26
    return lambda n, r: hedge_mesh(n, 1.1, 0.5, r).moved(yaw_rad=np.pi / 2).moved((0.0, -n / 2, 0.0)), 0.6
