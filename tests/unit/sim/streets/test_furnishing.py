"""What stands in a street: by rules, apart from each other, out of the way, and each knob by itself."""

import itertools
import math
from functools import cache

import numpy as np
import pytest
from shapely.geometry import LineString, Point, Polygon

from sim.paint.tagged import COUNTS, paint_tagged, tagged_part
from sim.streets.backdrop import open_views
from sim.streets.catalogue import TAGGED
from sim.streets.footprint import gap_m
from sim.streets.furnishing import furnish
from sim.streets.kinds import Ground, draw_network
from sim.streets.lamps import Lamp
from sim.streets.lots import draw_lots
from sim.streets.network import Network, driven_line_m
from sim.streets.scenery import Prop

KINDS = {
    "bend": 40.0,
    "crossroads": 40.0,
    "motorway": 60.0,
    "tunnel": 60.0,
    "car_park": 110.0,
    "suburb": 40.0,
}
CAR_HALF_M = 0.95


@cache
def network(kind: str, slope_percent: float = 0.0) -> Network:
    plan, relief = np.random.default_rng(5).spawn(2)
    return draw_network(kind, KINDS[kind], Ground(slope_percent=slope_percent), plan, relief)


@cache
def furnished(
    kind: str, parking: float = 0.6, vegetation: float = 1.0, slope_percent: float = 0.0
) -> tuple[tuple[Prop, ...], tuple[Lamp, ...]]:
    plan = network(kind, slope_percent)
    lots = draw_lots(plan, "varied", np.random.default_rng(1))
    driven = driven_line_m(plan.route, KINDS[kind])
    scenery, lamps = furnish(plan, lots, driven, parking, vegetation, np.random.default_rng(2))
    return scenery.props, lamps


def places(props: tuple[Prop, ...], skin: str) -> set[tuple[float, ...]]:
    return {prop.position_m for prop in props if prop.skin.startswith(skin)}


@pytest.mark.parametrize("kind", KINDS)
def test_nothing_stands_in_the_driven_lane(kind: str) -> None:
    lane = LineString(driven_line_m(network(kind).route, KINDS[kind])).buffer(CAR_HALF_M)
    for prop in furnished(kind)[0]:
        if prop.footprint_m is not None:
            assert not Polygon(prop.footprint_m).intersects(lane), prop.name


@pytest.mark.parametrize("kind", ("bend", "car_park"))
def test_parked_cars_and_furniture_do_not_stand_in_each_other(kind: str) -> None:
    standing = [prop for prop in furnished(kind, parking=1.0)[0] if prop.footprint_m is not None]
    for one, other in itertools.combinations(standing, 2):
        if math.dist(one.position_m, other.position_m) < 8.0:
            assert one.footprint_m is not None and other.footprint_m is not None
            assert gap_m(one.footprint_m, other.footprint_m) > -0.02, (one.name, other.name)


def test_parking_takes_a_share_of_the_bays_and_changes_nothing_else() -> None:
    empty, some, full = (furnished("bend", parking=share)[0] for share in (0.0, 0.5, 1.0))
    assert not places(empty, "car_")
    assert places(some, "car_") < places(full, "car_")
    assert len(places(full, "car_")) == len(network("bend").bays)
    assert places(empty, "furniture") == places(full, "furniture")
    assert places(empty, "plants") == places(full, "plants")


def test_less_vegetation_only_leaves_plants_out() -> None:
    bare, some, lush = (furnished("bend", vegetation=share)[0] for share in (0.0, 0.5, 1.0))
    assert not places(bare, "plants")
    assert places(some, "plants") < places(lush, "plants")
    assert places(bare, "furniture") == places(lush, "furniture")
    assert places(bare, "car_") == places(lush, "car_")


def test_lamps_come_at_a_spacing_and_shine_down_over_the_street() -> None:
    lamps = furnished("bend")[1]
    assert len(lamps) > 6
    for lamp in lamps:
        assert lamp.kind == "street"
        assert 5.0 < lamp.position_m[2] < 7.0
        assert lamp.aim[2] < -0.5
        nearest = min(
            np.linalg.norm(np.subtract(lamp.position_m, o.position_m)) for o in lamps if o is not lamp
        )
        assert 6.0 < nearest < 30.0


def test_a_tunnel_is_lit_under_its_ceiling() -> None:
    (tunnel,) = network("tunnel").tunnels
    inside = [lamp for lamp in furnished("tunnel")[1] if lamp.kind == "tunnel"]
    outline = Polygon(tunnel.outline_m)
    assert len(inside) > 8
    assert all(
        Polygon(tunnel.outline_m).distance(LineString([lamp.position_m[:2]] * 2)) == 0 for lamp in inside
    )
    assert all(0 < tunnel.height_m - lamp.position_m[2] < 0.3 for lamp in inside)
    assert outline.area > 100.0


def test_a_motorway_has_rails_and_a_gantry_with_room_below() -> None:
    props = furnished("motorway")[0]
    names = [prop.name for prop in props]
    assert any(name.startswith("rail_") for name in names)
    boards = [prop for prop in props if prop.name.startswith("gantry_") and prop.skin == prop.name]
    assert boards
    assert all(prop.mesh.vertices_m[:, 2].min() > 5.0 for prop in boards)


def test_things_stand_on_the_ground_of_a_hill() -> None:
    plan = network("bend", 8.0)
    for prop in furnished("bend", slope_percent=8.0)[0]:
        x, y, z = prop.position_m
        if prop.footprint_m is not None:
            assert z - float(plan.relief.height_m(np.array([x, y]))) in (
                pytest.approx(0.0),
                pytest.approx(0.12),
            )


def test_lights_stand_where_streets_cross_and_signs_where_one_joins() -> None:
    assert (
        len([p for p in furnished("crossroads")[0] if p.mesh.vertices_m[:, 2].max() == pytest.approx(3.5)])
        == 4
    )


def test_marker_posts_stand_behind_the_rail_of_a_motorway_on_its_outside() -> None:
    plan = network("motorway")
    posts = [prop for prop in furnished("motorway")[0] if prop.skin == "marker"]
    outer = [kerb for kerb in plan.kerbs if kerb.lining == "barrier" and kerb.pavement_m > 5.2]
    assert len(posts) >= 2 * len(outer)
    for post in posts:
        nearest = min(
            abs(float(kerb.path.project(np.array(post.position_m[:2]))[1]) - 1.05) for kerb in outer
        )
        assert nearest < 0.02


def test_no_two_pieces_that_bear_marks_are_alike() -> None:
    tagged = [prop for prop in furnished("crossroads")[0] if prop.skin == TAGGED]
    assert len(tagged) > 5
    assert len({id(prop.mesh) for prop in tagged}) == len(tagged)


def test_no_two_trees_seen_from_near_are_alike() -> None:
    near_m, driven = 9.0, LineString(driven_line_m(network("bend").route, KINDS["bend"]))
    trees = [
        prop
        for prop in furnished("bend")[0]
        if prop.skin == "plants"
        and prop.mesh.vertices_m[:, 2].max() > 4.5
        and driven.distance(Point(prop.position_m[:2])) < near_m
    ]
    assert len(trees) > 4
    assert len({id(prop.mesh) for prop in trees}) == len(trees)


def test_every_piece_is_painted_differently() -> None:
    image = paint_tagged(np.random.default_rng(0))
    for kind, count in COUNTS.items():
        corners = [np.array(tagged_part(kind, k)).reshape(2, 2) * image.shape[1::-1] for k in range(count)]
        painted = {image[int(y0) : int(y1), int(x0) : int(x1)].tobytes() for (x0, y0), (x1, y1) in corners}
        assert len(painted) == count


def test_a_view_between_houses_ends_at_a_copse() -> None:
    plan = network("car_park")
    lots = draw_lots(plan, "varied", np.random.default_rng(1))
    views, _ = open_views(plan, lots, driven_line_m(plan.route, KINDS["car_park"]))
    plants = np.array([p.position_m[:2] for p in furnished("car_park")[0] if p.skin == "plants"])
    assert len(views) > 10
    away_m = np.linalg.norm(views[:, None] - plants[None], axis=2).min(axis=1)
    assert np.quantile(away_m, 0.9) < 7.0
