"""Networks of every kind: the driven line, kerbs, lanes and surfaces fit together."""

import numpy as np
import pytest
from pydantic import ValidationError
from shapely import contains_xy
from shapely.geometry import LineString, Point
from shapely.ops import unary_union

from sim.streets.kinds import PLANS, SHORTEST_M, Ground, draw_network
from sim.streets.network import Network, driven_line_m
from sim.streets.street import StreetConfig

LENGTHS_M = {kind: max(shortest, 70.0) for kind, (shortest, _) in SHORTEST_M.items()}
PLAIN = Ground()
CASES = [(kind, seed) for kind in PLANS for seed in range(3)]


def draw(kind: str, seed: int = 0, length_m: float | None = None, ground: Ground = PLAIN) -> Network:
    rngs = (np.random.default_rng([seed, k]) for k in range(2))
    return draw_network(kind, length_m or LENGTHS_M[kind], ground, *rngs)


@pytest.fixture(params=CASES, ids=lambda case: f"{case[0]}-{case[1]}")
def case(request: pytest.FixtureRequest) -> tuple[str, Network]:
    return request.param[0], draw(*request.param)


def test_the_driven_line_starts_at_the_origin_along_x(case: tuple[str, Network]) -> None:
    line = driven_line_m(case[1].route, LENGTHS_M[case[0]])
    np.testing.assert_allclose(line[0], 0.0, atol=1e-6)
    assert abs(np.arctan2(*(line[1] - line[0])[::-1])) < 1e-4


def test_the_driven_line_is_long_enough_and_can_be_steered(case: tuple[str, Network]) -> None:
    kind, network = case
    steps = np.diff(driven_line_m(network.route, LENGTHS_M[kind]), axis=0)
    headings = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    lengths = np.linalg.norm(steps, axis=1)
    assert lengths.sum() > LENGTHS_M[kind] - 0.5
    assert np.abs(np.diff(headings) / lengths[1:]).max() < 1 / 5.0


def test_the_car_stays_on_the_carriageway(case: tuple[str, Network]) -> None:
    line = LineString(driven_line_m(case[1].route, LENGTHS_M[case[0]]))
    assert case[1].carriageway.buffer(0.01).contains(line.buffer(1.0, cap_style="flat"))


def test_a_kerb_has_the_carriageway_on_its_right_and_none_on_its_left(case: tuple[str, Network]) -> None:
    for kerb in case[1].kerbs:
        s_m = np.linspace(kerb.path.start_m + 0.5, kerb.path.end_m - 0.5, 50)
        for d, wanted in ((-0.3, True), (0.3, False), (0.8 * kerb.pavement_m, False)):
            beside = kerb.path.point_m(s_m, d)
            share = contains_xy(case[1].carriageway, beside[:, 0], beside[:, 1]).mean()
            assert share == pytest.approx(1.0 if wanted else 0.0, abs=0.05), (kerb.road, kerb.side, d)


def test_pavements_do_not_fold(case: tuple[str, Network]) -> None:
    for kerb in case[1].kerbs:
        if case[0] == "car_park" and kerb.lining == "island":
            continue  # so narrow that its two sides meet in the middle, at square ends
        s_m = np.linspace(kerb.path.start_m, kerb.path.end_m, 400)
        outer = np.diff(kerb.path.point_m(s_m, kerb.pavement_m), axis=0)
        inner = np.diff(kerb.path.point_m(s_m), axis=0)
        assert (np.sum(outer * inner, axis=1) > 0).mean() > 0.985, (kerb.road, kerb.side)


def test_car_lanes_stay_on_the_carriageway(case: tuple[str, Network]) -> None:
    for lane in case[1].lanes:
        if lane.kind == "car":
            points = lane.path.points_m[5:-5]
            assert contains_xy(case[1].carriageway, points[:, 0], points[:, 1]).mean() > 0.98


def test_one_lane_is_driven_by_the_car(case: tuple[str, Network]) -> None:
    driven = [lane for lane in case[1].lanes if lane.is_route]
    assert len(driven) == 1
    away = driven[0].path.project(driven_line_m(case[1].route, 40.0))[:, 1]
    np.testing.assert_allclose(away, 0.0, atol=0.05)


def test_plain_strips_and_junctions_cover_the_carriageway(case: tuple[str, Network]) -> None:
    network = case[1]
    strips = [road.outline(None if road.path.closed else road.span_m) for road in network.roads]
    covered = unary_union([*strips, *(junction.outline.buffer(0.06) for junction in network.junctions)])
    assert network.carriageway.difference(covered.buffer(0.02)).area < 0.05


def test_the_same_generators_draw_the_same_network_and_others_another() -> None:
    one, same, other = draw("crossroads"), draw("crossroads"), draw("crossroads", seed=1)
    assert one.carriageway.equals(same.carriageway)
    assert not one.carriageway.equals(other.carriageway)


@pytest.mark.parametrize(
    "ground", [Ground(slope_percent=8.0), Ground(roughness=3.0), Ground(speed_bumps=4.0)]
)
def test_what_the_ground_is_like_moves_no_road_and_no_kerb(ground: Ground) -> None:
    plain, shaped = draw("bend"), draw("bend", ground=ground)
    assert plain.carriageway.equals(shaped.carriageway)
    assert plain.bays == shaped.bays
    for one, other in zip(plain.kerbs, shaped.kerbs, strict=True):
        np.testing.assert_array_equal(one.path.points_m, other.path.points_m)


def test_kerbs_of_a_tunnel_become_walls_inside_it() -> None:
    network = draw("tunnel")
    tunnel = network.tunnels[0]
    walls = [kerb for kerb in network.kerbs if kerb.lining == "wall"]
    assert len(walls) == 2
    for wall in walls:
        s = network.road("main").path.project(wall.path.points_m)[:, 0]
        np.testing.assert_allclose([s.min(), s.max()], tunnel.span_m, atol=0.1)


def test_a_loop_is_as_long_as_asked() -> None:
    for kind, length_m in (("loop", 260.0), ("car_park", 140.0)):
        assert draw(kind, length_m=length_m).route.length_m == pytest.approx(length_m, abs=1.0)


@pytest.mark.parametrize(("kind", "length_m"), [("loop", 100.0), ("roundabout", 50.0), ("bend", 900.0)])
def test_a_street_without_room_for_its_kind_is_refused_with_the_reason(kind: str, length_m: float) -> None:
    with pytest.raises(ValidationError, match=rf"got {length_m:g}, wanted .* for a street of kind {kind}"):
        StreetConfig(kind=kind, length_m=length_m)


def test_every_arm_has_its_own_give_way_line() -> None:
    for kind, arms in (("crossroads", 2), ("roundabout", 4), ("t_junction", 1)):
        network = draw(kind)
        middles = [junction.teeth_m.mean(axis=(0, 1)) for junction in network.junctions]
        assert len(middles) == arms
        for junction, middle in zip(network.junctions, middles, strict=True):
            assert junction.outline.buffer(0.5).contains(Point(middle))


@pytest.mark.parametrize("kind", ["bend", "crossroads", "t_junction", "roundabout", "loop"])
def test_bicycles_neither_appear_nor_vanish_in_the_middle_of_a_junction(kind: str) -> None:
    network = draw(kind)
    middles = unary_union([junction.outline.buffer(2.0) for junction in network.junctions])
    bikes = [lane for lane in network.lanes if lane.kind == "bike" and not lane.closed]
    assert bikes
    for lane in bikes:
        for end in (lane.path.points_m[0], lane.path.points_m[-1]):
            assert not middles.contains(Point(end))
