"""Metric scale from the road under a camera of known height."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.road import road_scale
from estimator.se3 import Array

HEIGHT_M = 1.4
HALF_WIDTH_M = 1.4


def road_and_facades(road: int, facades: int, seed: int = 0) -> Array:
    """Return points around a camera 1.4 m above the road: some on it, some spread over two facades."""
    rng = np.random.default_rng(seed)
    ground = np.column_stack([rng.uniform(3, 12, road), rng.uniform(-4, 4, road), np.full(road, -HEIGHT_M)])
    ground[:, 2] += 0.01 * rng.standard_normal(road)
    sides = np.where(rng.random(facades) < 0.5, -6.0, 6.0)
    walls = np.column_stack([rng.uniform(3, 15, facades), sides, rng.uniform(-HEIGHT_M, 6, facades)])
    return np.vstack([ground, walls])


def scale_of(points: Array, unit_m: float = 1.0, prior_sigma: float = np.inf) -> float | None:
    """Return the scale found for points in metres, given in another unit."""
    in_path = np.abs(points[:, 1]) < HALF_WIDTH_M
    return road_scale(points / unit_m, in_path, HEIGHT_M, prior_sigma)


@pytest.mark.parametrize("unit_m", [0.2, 1.0, 7.0])
def test_the_road_is_found_among_the_facades_whatever_the_unit(unit_m: float) -> None:
    scale = scale_of(road_and_facades(60, 200), unit_m)
    assert scale is not None and abs(scale / unit_m - 1) < 0.01


def test_without_points_below_the_camera_there_is_no_road() -> None:
    points = road_and_facades(40, 200)
    assert scale_of(points[points[:, 2] > 0]) is None
    assert scale_of(np.full((50, 3), np.nan)) is None


def test_a_handful_of_points_is_no_road() -> None:
    assert scale_of(road_and_facades(8, 0)) is None


def test_what_is_far_away_says_nothing_of_the_road() -> None:
    far = road_and_facades(40, 0) * [10.0, 10.0, 1.0]
    assert scale_of(far) is None


def test_a_known_scale_keeps_a_lower_yard_from_being_the_road() -> None:
    yard = road_and_facades(120, 0, 1) * [1.0, 1.0, 1.3]
    points = np.vstack([road_and_facades(60, 50), yard])
    fooled, kept = scale_of(points), scale_of(points, prior_sigma=0.03)
    assert fooled is not None and fooled < 0.9
    assert kept is not None and abs(kept - 1) < 0.01


def test_a_pavement_of_many_points_is_not_taken_for_the_road() -> None:
    pavement = road_and_facades(300, 0, 2)
    pavement[:, 1] = 2.0 + np.abs(pavement[:, 1]) / 2
    pavement[:, 2] += 0.15
    scale = scale_of(np.vstack([road_and_facades(100, 50), pavement]))
    assert scale is not None and abs(scale - 1) < 0.01
