"""Intersecting rays: exact without noise, unknown where nothing can be known."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from estimator.triangulate import triangulate

POINTS = np.array([[4.0, 1.0, 0.5], [20.0, -3.0, 6.0], [8.0, 0.0, -1.4]])
CENTERS = np.array([[0.0, 0.0, 0.0], [1.0, 0.2, 0.0], [2.0, 0.3, 0.1]])


def rays(points: Array, centers: Array) -> tuple[np.ndarray, Array, Array]:
    """Return the index, unit rays and centres with which every centre sees every point."""
    landmark, center = np.divmod(np.arange(len(points) * len(centers)), len(centers))
    view = points[landmark] - centers[center]
    return landmark, view / np.linalg.norm(view, axis=1, keepdims=True), centers[center]


def test_rays_without_noise_meet_in_the_point() -> None:
    found, _ = triangulate(*rays(POINTS, CENTERS), 3)
    np.testing.assert_allclose(found, POINTS, atol=1e-9)


def test_the_order_of_the_rays_does_not_matter() -> None:
    landmark, views, centers = rays(POINTS, CENTERS)
    order = np.random.default_rng(0).permutation(len(landmark))
    found, _ = triangulate(landmark[order], views[order], centers[order], 3)
    np.testing.assert_allclose(found, POINTS, atol=1e-9)


def test_the_angle_is_the_widest_from_the_first_ray() -> None:
    landmark, views, centers = rays(POINTS[:1], CENTERS)
    _, angle = triangulate(landmark, views, centers, 1)
    np.testing.assert_allclose(angle, np.arccos(views[1:] @ views[0]).max(), atol=1e-9)


def test_parallel_rays_meet_nowhere() -> None:
    ahead = np.tile([1.0, 0.0, 0.0], (2, 1))
    found, angle = triangulate(np.zeros(2, np.int64), ahead, CENTERS[:2], 1)
    assert np.isnan(found).all() and angle[0] == 0


def test_a_point_behind_a_camera_is_unknown() -> None:
    landmark, views, centers = rays(POINTS, CENTERS)
    views[landmark == 1] *= -1
    found, _ = triangulate(landmark, views, centers, 3)
    np.testing.assert_array_equal(np.isnan(found[:, 0]), [False, True, False])


def test_a_single_ray_and_no_ray_leave_the_point_unknown() -> None:
    landmark, views, centers = rays(POINTS, CENTERS)
    chosen = (landmark == 2) | ((landmark == 0) & (np.arange(9) == 0))
    found, _ = triangulate(landmark[chosen], views[chosen], centers[chosen], 3)
    np.testing.assert_array_equal(np.isnan(found[:, 0]), [True, True, False])
    np.testing.assert_allclose(found[2], POINTS[2], atol=1e-9)


def test_noise_of_an_angle_weighs_the_near_camera_more() -> None:
    point = np.array([[10.0, 0.0, 0.0]])
    centers = np.array([[9.0, 1.0, 0.0], [9.0, -1.0, 0.0], [0.0, 3.0, 0.0]])
    landmark, views, centers = rays(point, centers)
    views[2] = (views[2] + [0.0, 0.0, 0.05]) / np.linalg.norm(views[2] + [0.0, 0.0, 0.05])
    found, _ = triangulate(landmark, views, centers, 1)
    assert np.linalg.norm(found - point) < 0.02  # the far ray passes half a metre above
