"""The relief: level where the car starts, as steep, bumpy and rough as asked; the ground lies on it."""

import numpy as np
import pytest

from sim.streets.carriageways import build_carriageways
from sim.streets.kinds import Ground, draw_network
from sim.streets.pavements import build_pavements
from sim.streets.relief import BUMP_HEIGHT_M, Relief, draw_hills, draw_roughness

ALONG_M = np.column_stack([np.linspace(0.0, 120.0, 400), np.zeros(400)])


def relief(slope_percent: float = 0.0, level: float = 0.0, seed: int = 0) -> Relief:
    hills, rough = np.random.default_rng(seed).spawn(2)
    return Relief(draw_hills(slope_percent, ALONG_M, hills), draw_roughness(level, rough))


def network(ground: Ground, kind: str = "straight"):
    return draw_network(kind, 60.0, ground, np.random.default_rng(0), np.random.default_rng(1))


@pytest.mark.parametrize("seed", range(4))
def test_hills_are_level_at_the_start_and_as_steep_as_asked_on_the_way(seed: int) -> None:
    hills = relief(10.0, seed=seed)
    assert hills.height_m(np.zeros(2)) == 0.0
    np.testing.assert_allclose(hills.gradient(np.zeros(2)), 0.0, atol=1e-12)
    slopes = np.diff(hills.height_m(ALONG_M)) / np.diff(ALONG_M[:, 0])
    assert np.abs(slopes).max() == pytest.approx(0.10, rel=0.01)


def test_the_gradient_is_that_of_the_height() -> None:
    hills, at, step = relief(12.0), np.array([[31.0, -7.0], [88.0, 12.0]]), 1e-5
    for axis, shift in enumerate(np.eye(2) * step):
        change = (hills.height_m(at + shift) - hills.height_m(at - shift)) / (2 * step)
        np.testing.assert_allclose(hills.gradient(at)[:, axis], change, atol=1e-8)


def test_a_steeper_world_has_its_hills_in_the_same_places() -> None:
    np.testing.assert_allclose(relief(10.0).height_m(ALONG_M), 2 * relief(5.0).height_m(ALONG_M), atol=1e-12)


def test_each_class_of_roughness_is_twice_as_rough_as_the_one_before() -> None:
    line = np.column_stack([np.linspace(0, 400, 8000), np.zeros(8000)])
    heights = [relief(level=level).road_height_m(line) for level in (1, 2, 3, 4, 5)]
    sigmas = [float(height.std()) for height in heights]
    np.testing.assert_allclose(np.divide(sigmas[1:], sigmas[:-1]), 2.0, rtol=1e-6)
    assert 0.001 < sigmas[0] < 0.003  # ISO 8608 class A between 1.2 and 12 m


def test_without_knobs_the_world_is_flat_and_roughness_leaves_the_terrain_alone() -> None:
    assert relief().is_flat
    np.testing.assert_array_equal(relief().road_height_m(ALONG_M), 0.0)
    np.testing.assert_array_equal(relief(level=5).height_m(ALONG_M), 0.0)


def test_bumps_are_as_many_and_as_high_as_asked_and_lie_on_the_driven_lane() -> None:
    drawn = network(Ground(speed_bumps=5.0))
    heights = drawn.relief.road_height_m(drawn.route.point_m(np.arange(0.0, 60.0, 0.01)))
    peaks = (heights[1:-1] > heights[:-2]) & (heights[1:-1] >= heights[2:]) & (heights[1:-1] > 0.01)
    assert 2 <= peaks.sum() <= 3
    assert heights.max() == pytest.approx(BUMP_HEIGHT_M, abs=1e-3)
    assert drawn.relief.road_height_m(np.zeros(2)) == 0.0


@pytest.mark.parametrize(
    ("kind", "ground", "limit_m"),
    [
        ("straight", Ground(slope_percent=15.0), 0.002),
        ("t_junction", Ground(slope_percent=10.0), 0.002),
        ("straight", Ground(speed_bumps=6.0), 0.002),
        ("straight", Ground(roughness=5.0), 0.010),
    ],
)
def test_wheels_neither_float_nor_sink(kind: str, ground: Ground, limit_m: float) -> None:
    """The drawn surface lies where wheels feel it, between its vertices too."""
    drawn = network(ground, kind)
    scenery = build_carriageways(drawn, np.random.default_rng(0))
    for prop in scenery.props:
        corners = prop.mesh.vertices_m[prop.mesh.faces]
        inside = np.array([[1, 1, 1], [0, 3, 3], [3, 0, 3], [3, 3, 0]]) / np.array([[3], [6], [6], [6]])
        points = np.einsum("kc,fcx->fkx", inside, corners).reshape(-1, 3)
        away = np.abs(points[:, 2] - drawn.relief.road_height_m(points[:, :2]))
        assert np.quantile(away, 0.999) < limit_m + 0.002, prop.name


def test_ground_faces_up() -> None:
    drawn = network(Ground(slope_percent=8.0), "crossroads")
    roads = build_carriageways(drawn, np.random.default_rng(0)).props
    paved = build_pavements(drawn.kerbs, drawn.relief, np.random.default_rng(0)).props
    for prop in (*roads, *paved):
        a, b, c = (prop.mesh.vertices_m[prop.mesh.faces[:, k]] for k in range(3))
        normals = np.cross(b - a, c - a)
        assert (normals[:, 2] > -1e-4 * np.linalg.norm(normals, axis=1).max()).all(), prop.name
        given = prop.mesh.normals[prop.mesh.faces[:, 0]]
        assert (np.sum(normals * given, axis=1) >= -1e-9).all(), prop.name
