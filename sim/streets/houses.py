"""Houses on lots: each its own, all plain, or all the same, as the street's facades are chosen."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from estimator.se3 import Array
from sim.paint.facade import paint_facade
from sim.paint.lit_windows import light_windows
from sim.paint.shops import SHOP_NAMES
from sim.shapes.facade import Facade
from sim.shapes.facade_plan import CANYON, OLD_TOWN, draw_facade, draw_plain_house
from sim.shapes.gateway import GATE_FLOORS, with_gateway
from sim.shapes.house_mesh import house_mesh
from sim.streets.lot import MODULE_M, Facades, Lot
from sim.streets.relief import Relief
from sim.streets.scenery import Prop, Scenery, Skin

FAR_M = 22.0
_SINK_M = 0.03  # lets a house reach into uneven ground


@dataclass(frozen=True)
class Detail:
    """How finely a house is built: the flattest relief that is modelled, and the size of a texel."""

    relief_m: float
    texel_m: float


NEAR = Detail(0.03, 0.017)
FAR = Detail(0.15, 0.034)


def build_houses(
    lots: Sequence[Lot],
    facades: Facades,
    tall: bool,
    relief: Relief,
    driven_m: Array,
    rng: np.random.Generator,
) -> Scenery:
    """One house on every lot; what is never seen from near is built more coarsely.

    Args:
        lots: Those that are gardens stay empty.
        facades: varied, bare or repeated.
        tall: Whether houses are twice as high as in a small town.
        relief: Houses stand on it.
        driven_m: (N, 2) polyline of the driven lane.
        rng: Source of randomness.
    """
    floors = CANYON if tall else OLD_TOWN
    near = cKDTree(driven_m)
    props: list[Prop] = []
    skins: dict[str, Skin] = {}
    module_rng, names_rng, *streams = rng.spawn(2 + len(lots))
    names = [str(name) for name in names_rng.permutation(SHOP_NAMES)]
    module = draw_facade(MODULE_M, module_rng, corner=True, floors=floors) if facades == "repeated" else None
    if module:
        skins["house_module"] = _skin(module, NEAR.texel_m, module_rng)
    for k, (lot, stream) in enumerate(zip(lots, streams, strict=True)):
        if lot.use == "garden":
            continue
        detail = NEAR if near.query(lot.front_m.mean(axis=0))[0] < FAR_M else FAR
        facade, skin = module, "house_module"
        if facade is None or lot.gateway_m:
            drawn = _drawn(lot, facades, floors, stream)
            facade, skin = replace(drawn, shop_name=names[k % len(names)]), f"house_{k}"
            skins[skin] = _skin(facade, detail.texel_m, stream)
        mesh = house_mesh(facade, lot.front_m, lot.back_m, detail.relief_m, lot.seen)
        z = float(relief.height_m(lot.front_m).mean()) + lot.curb_m - _SINK_M
        props.append(Prop(f"house_{k}", mesh, skin, (0.0, 0.0, z), footprint_m=lot.outline_m))
    return Scenery(tuple(props), skins)


def _skin(facade: Facade, texel_m: float, rng: np.random.Generator) -> Skin:
    image = paint_facade(facade, texel_m, rng)
    return Skin(image, glow=light_windows(facade, image, texel_m, rng))


def _drawn(lot: Lot, facades: Facades, floors: tuple[int, ...], rng: np.random.Generator) -> Facade:
    seen = any(lot.seen)
    if facades == "bare" or lot.setback_m > 3.0:  # a gateway needs a floor above it
        if lot.gateway_m:
            return with_gateway(draw_plain_house(lot.width_m, rng, seen, (1,)), lot.gateway_m)
        return draw_plain_house(lot.width_m, rng, seen)
    if lot.gateway_m:
        high = floors if floors == CANYON else GATE_FLOORS
        return with_gateway(draw_facade(lot.width_m, rng, False, seen, high), lot.gateway_m)
    return draw_facade(lot.width_m, rng, shops=lot.setback_m < 1.0, corner=seen, floors=floors)
