"""Lots: disjoint, off the road, at corners too, whatever the kind of street."""

import itertools

import numpy as np
import pytest
from shapely.geometry import Polygon

from sim.streets.kinds import Ground, draw_network
from sim.streets.lot import MODULE_M, Lot
from sim.streets.lots import draw_lots
from sim.streets.network import Network

BUILT_UP = ("straight", "bend", "crossroads", "t_junction", "roundabout", "suburb", "canyon")


def network(kind: str, seed: int = 0) -> Network:
    plan, relief = np.random.default_rng(seed).spawn(2)
    return draw_network(kind, 70.0, Ground(), plan, relief)


def lots(kind: str, facades: str = "varied", seed: int = 0) -> list[Lot]:
    return draw_lots(network(kind, seed), facades, np.random.default_rng(seed))  # type: ignore[arg-type]


@pytest.mark.parametrize("kind", BUILT_UP)
def test_lots_neither_overlap_nor_reach_into_a_road(kind: str) -> None:
    road = network(kind).carriageway
    outlines = [Polygon(lot.outline_m) for lot in lots(kind)]
    assert len(outlines) > 12
    for outline in outlines:
        assert outline.is_valid
        assert outline.distance(road) > 0.5
    for one, other in itertools.combinations(outlines, 2):
        assert one.intersection(other).area < 0.02 * min(one.area, other.area) + 0.3


def test_a_house_stands_in_the_angle_of_every_corner() -> None:
    plan = network("crossroads")
    corners = [
        kerb.path.point_m(sum(span) / 2, kerb.pavement_m + 1.5)
        for kerb in plan.kerbs
        for span in kerb.corners_m
    ]
    built = [Polygon(lot.outline_m).buffer(1.0) for lot in lots("crossroads")]
    assert len(corners) == 4
    for at in corners:
        assert any(
            outline.contains(Polygon(at + 0.1 * np.array([[0, 0], [1, 0], [0, 1]]))) for outline in built
        )


def test_fronts_face_the_street() -> None:
    plan = network("bend")
    for lot in draw_lots(plan, "varied", np.random.default_rng(0)):
        ahead = lot.front_m.mean(axis=0) + 0.5 * lot.outward
        behind = lot.front_m.mean(axis=0) - 0.5 * lot.outward
        away = [min(float(np.abs(kerb.path.project(at)[1])) for kerb in plan.kerbs) for at in (ahead, behind)]
        assert lot.use == "closing" or away[0] < away[1]


def test_repeated_houses_are_as_wide_as_their_module() -> None:
    widths = [lot.width_m for lot in lots("canyon", "repeated") if lot.use == "house"]
    assert np.quantile(widths, 0.1) == pytest.approx(MODULE_M, rel=0.02)
    assert np.quantile(widths, 0.8) == pytest.approx(MODULE_M, rel=0.02)


def test_there_are_gaps_without_houses_but_never_two_side_by_side() -> None:
    uses = [lot.use for seed in range(3) for lot in lots("straight", seed=seed)]
    assert 0 < uses.count("garden") < 0.3 * len(uses)
    assert ("garden", "garden") not in itertools.pairwise(uses)


def test_streets_leave_the_world_through_gateways_as_wide_as_they_are() -> None:
    plan = network("crossroads")
    gates = [lot for lot in lots("crossroads") if lot.gateway_m]
    assert len(gates) >= 3
    widths = [road.width_m for road in plan.roads]
    for lot in gates:
        assert min(abs(lot.gateway_m - width) for width in widths) < 1e-9
        assert lot.gateway_m < lot.width_m
