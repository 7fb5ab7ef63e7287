"""The path of a street: where it runs, how smoothly, and its street coordinates."""

import numpy as np
import pytest

from sim.streets.layout import Layout, draw_layout, lane_centerline_m
from sim.streets.path import STEP_M, bend_curvature, bend_length_m, path_from_curvature

SEEDS = range(8)


def layout_of(seed: int, length_m: float = 70.0) -> Layout:
    return draw_layout(length_m, np.random.default_rng(seed))


def test_a_bend_turns_by_its_angle_over_its_length() -> None:
    s_m = np.arange(0.0, 60.0, STEP_M)
    path = path_from_curvature(0.0, bend_curvature(s_m, 10.0, np.deg2rad(-55), 20.0))
    end = 10.0 + bend_length_m(np.deg2rad(-55), 20.0)
    assert path.heading_rad(9.9) == pytest.approx(0.0, abs=1e-9)
    assert np.rad2deg(path.heading_rad(end + 0.2)) == pytest.approx(-55.0, abs=0.1)


def test_street_coordinates_keep_their_distance_from_the_path() -> None:
    path = layout_of(3).path
    s_m = np.linspace(0.0, 60.0, 200)
    apart = np.linalg.norm(path.point_m(s_m, 5.0) - path.point_m(s_m), axis=1)
    np.testing.assert_allclose(apart, 5.0, atol=1e-9)


def test_beyond_its_ends_a_path_goes_on_straight() -> None:
    path = layout_of(0).path
    beyond = path.point_m(path.start_m - np.array([0.0, 7.0]))
    np.testing.assert_allclose(beyond[0] - beyond[1], [7.0, 0.0], atol=1e-9)


@pytest.mark.parametrize("seed", SEEDS)
def test_the_centerline_starts_at_the_origin_along_x(seed: int) -> None:
    line = lane_centerline_m(layout_of(seed))
    np.testing.assert_allclose(line[0], 0.0, atol=1e-12)
    assert abs(np.arctan2(*(line[1] - line[0])[::-1])) < 1e-9


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("length_m", [40.0, 70.0, 250.0])
def test_the_centerline_is_dense_long_enough_and_smooth(seed: int, length_m: float) -> None:
    line = lane_centerline_m(layout_of(seed, length_m))
    steps = np.diff(line, axis=0)
    lengths = np.linalg.norm(steps, axis=1)
    headings = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    curvature = np.diff(headings) / lengths[1:]
    assert lengths.max() <= 0.5
    assert lengths.sum() >= length_m
    assert np.abs(curvature).max() < 1 / 12.0
    assert np.abs(np.diff(curvature)).max() < 0.01


@pytest.mark.parametrize("seed", SEEDS)
def test_bend_and_junction_lie_within_the_first_sixty_metres(seed: int) -> None:
    layout = layout_of(seed)
    turned_deg = abs(np.rad2deg(layout.path.heading_rad(60.0)))
    assert 45.0 <= turned_deg <= 90.0
    assert layout.mouth_m[0] > 0.0
    assert layout.mouth_m[1] < 60.0


@pytest.mark.parametrize("seed", SEEDS)
def test_the_side_street_leaves_on_the_outside_of_the_bend(seed: int) -> None:
    layout = layout_of(seed)
    assert layout.junction.side * float(layout.path.heading_rad(60.0)) < 0


@pytest.mark.parametrize("seed", SEEDS)
def test_facades_stand_five_to_ten_metres_from_the_lane(seed: int) -> None:
    section = layout_of(seed).section
    assert 5.0 <= -section.front_right_m <= 10.0
    assert 5.0 <= section.front_left_m <= 10.0


def test_seeds_draw_left_and_right_bends_and_both_orders() -> None:
    layouts = [layout_of(seed) for seed in range(20)]
    assert {layout.junction.side for layout in layouts} == {-1, 1}
    assert {layout.junction.s_m < layout.bend_start_m for layout in layouts} == {True, False}
