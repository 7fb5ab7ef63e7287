"""Houses on lots: what closes a street lets its traffic through, whatever the facades."""

import numpy as np
import pytest

from sim.streets.houses import build_houses
from sim.streets.lot import Facades, Lot
from sim.streets.relief import Relief, draw_hills, draw_roughness

FRONT_M = np.array([[0.0, 0.0], [14.0, 0.0]])
BACK_M = np.array([[0.0, 6.0], [14.0, 6.0]])


@pytest.mark.parametrize("facades", ("varied", "bare", "repeated"))
@pytest.mark.parametrize("setback_m", (0.0, 6.0))
def test_there_is_a_dark_gateway_where_a_street_ends(facades: Facades, setback_m: float) -> None:
    closed = [Lot(FRONT_M, BACK_M, setback_m, 0.0, "closing", gateway_m=width) for width in (0.0, 8.0)]
    dark = [share_of_dark(lot, facades) for lot in closed]
    assert dark[1] > dark[0] + 0.1


def share_of_dark(lot: Lot, facades: Facades) -> float:
    """Share of what is painted of a house that is nearly black."""
    rng = np.random.default_rng(0)
    line_m = np.column_stack([np.arange(50.0), np.zeros(50)])
    flat = Relief(draw_hills(0.0, line_m, rng), draw_roughness(0.0, rng))
    scenery = build_houses([lot], facades, False, flat, line_m, rng)
    image = scenery.skins[scenery.props[0].skin].image
    return float((image.max(axis=2) < 40).mean())
