"""Houses along both sides of a street: lots are cut along the facade lines, each gets its own house."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from estimator.se3 import Array
from sim.paint.facade import paint_facade
from sim.shapes.facade_plan import draw_facade
from sim.shapes.house_mesh import house_mesh
from sim.streets.layout import KERB_M, Layout
from sim.streets.path import Path
from sim.streets.scenery import NOTHING, Prop, Scenery, Skin

DEPTH_M = 5.6
SETBACKS_M = (0.0, 0.0, 0.0, 0.35, 2.6)
GARDEN_SHARE = 0.16
FAR_M = 22.0


@dataclass(frozen=True)
class Detail:
    """How finely a house is built: the flattest relief that is modelled, and the size of a texel."""

    relief_m: float
    texel_m: float


NEAR = Detail(0.03, 0.017)
FAR = Detail(0.15, 0.034)


@dataclass(frozen=True, eq=False)
class Lot:
    """Ground for one house.

    Attributes:
        front_m: (2, 2) world xy of its left and right front corner, seen from the street.
        back_m: (2, 2) the corners behind.
        setback_m: How far its front stands behind the facade line.
        side: +1 left of its street, -1 right.
        span_m: Its interval of s.
        path: The street it stands on.
        front_line_m: d of the facade line.
        use: "house", "corner" (a house whose side wall shows) or "garden" (no house).
    """

    front_m: Array
    back_m: Array
    setback_m: float
    side: int
    span_m: tuple[float, float]
    path: Path
    front_line_m: float
    use: str = "house"

    @property
    def outline_m(self) -> Array:
        """(4, 2) counter-clockwise."""
        return np.array([self.front_m[0], self.front_m[1], self.back_m[1], self.back_m[0]])


def draw_lots(layout: Layout, rng: np.random.Generator) -> list[Lot]:
    """Cut the facade lines of both streets into lots, and close the streets' ends."""
    junction, section, path = layout.junction, layout.section, layout.path
    lots: list[Lot] = []
    gap = junction.half_width_m + abs(junction.section.front_m(1)) - junction.half_width_m
    for side in (1, -1):
        spans = [(path.start_m, path.end_m)]
        if side == junction.side:
            spans = [(path.start_m, junction.s_m - gap), (junction.s_m + gap, path.end_m)]
        for low, high in spans:
            lots += _row(path, side, section.front_m(side), low, high, rng)
    start = abs(section.front_m(junction.side)) + DEPTH_M + 0.5
    for side in (1, -1):
        lots += _row(junction.path, side, junction.section.front_m(side), start, junction.path.end_m, rng)
    lots.append(_closing(path, path.end_m, 1, section.front_m(1), section.front_m(-1)))
    lots.append(_closing(path, path.start_m, -1, section.front_m(1), section.front_m(-1)))
    lots.append(
        _closing(
            junction.path, junction.path.end_m, 1, junction.section.front_m(1), junction.section.front_m(-1)
        )
    )
    return lots


def _row(
    path: Path, side: int, front_m: float, low: float, high: float, rng: np.random.Generator
) -> list[Lot]:
    """Lots of 5.5 to 11 m of front from one s to another; corner lots have no setback."""
    edges = [low]
    while high - edges[-1] > 1.0:
        stretch = _stretch(path, edges[-1], front_m)
        width = float(rng.uniform(5.5, 11.0)) / stretch
        left = high - edges[-1] - width
        edges.append(high if left < 5.0 / stretch else edges[-1] + width)
    lots: list[Lot] = []
    for k, (a, b) in enumerate(pairwise(edges)):
        inner = 0 < k < len(edges) - 2
        setback = float(rng.choice(SETBACKS_M)) if inner else 0.0
        # Never two gardens in a row: a side camera would see nothing but fence and sky.
        beside_garden = bool(lots) and lots[-1].use == "garden"
        garden = inner and bool(rng.random() < GARDEN_SHARE) and not beside_garden
        use = "garden" if garden else "house" if inner else "corner"
        lots.append(_lot(path, side, a, b, front_m, setback, use))
    return lots


def _stretch(path: Path, s_m: float, d_m: float) -> float:
    """Metres along the facade line for a metre along the lane, a few metres ahead."""
    ahead = path.point_m(np.array([s_m + 1.0, s_m + 7.0]), d_m)
    return max(float(np.linalg.norm(ahead[1] - ahead[0])) / 6.0, 0.35)


def _lot(path: Path, side: int, a: float, b: float, front_m: float, setback_m: float, use: str) -> Lot:
    near = front_m + side * setback_m
    far = front_m + side * DEPTH_M
    left, right = (a, b) if side > 0 else (b, a)
    front = path.point_m(np.array([left, right]), near)
    back = path.point_m(np.array([left, right]), far)
    return Lot(front, back, setback_m, side, (a, b), path, front_m, use)


def _closing(path: Path, s_m: float, ahead: int, left_m: float, right_m: float) -> Lot:
    """A wide house across the end of a street, facing back along it."""
    d = np.array([left_m + 4.0, right_m - 4.0])[:: 1 if ahead > 0 else -1]
    near, far = s_m + 1.0 * ahead, s_m + (1.0 + DEPTH_M) * ahead
    return Lot(path.point_m(near, d), path.point_m(far, d), 0.0, 0, (near, far), path, 0.0)


def build_houses(layout: Layout, lots: list[Lot], rng: np.random.Generator) -> Scenery:
    """One house with its own facade on every lot; what is never seen from near is built more coarsely."""
    scenery = NOTHING
    driven_m = layout.path.point_m(np.arange(0.0, layout.length_m, 2.0))
    for k, (lot, stream) in enumerate(zip(lots, rng.spawn(len(lots)), strict=True)):
        if lot.use != "garden":
            nearest_m = np.linalg.norm(driven_m - lot.front_m.mean(axis=0), axis=1).min()
            detail = NEAR if nearest_m < FAR_M else FAR
            scenery += _house(f"house_{k}", lot, detail, stream)
    return scenery


def _house(name: str, lot: Lot, detail: Detail, rng: np.random.Generator) -> Scenery:
    corner = lot.use == "corner"
    facade = draw_facade(
        float(np.linalg.norm(lot.front_m[1] - lot.front_m[0])),
        rng,
        shops=lot.setback_m < 1.0,
        corner=corner,
    )
    mesh = house_mesh(facade, lot.front_m, lot.back_m, detail.relief_m, (corner, corner))
    prop = Prop(name, mesh, name, (0.0, 0.0, KERB_M), footprint_m=lot.outline_m)
    return Scenery((prop,), {name: Skin(paint_facade(facade, detail.texel_m, rng))})
