"""Projection and its inverse over the whole image, and Jacobians against finite differences."""

from __future__ import annotations

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from estimator.camera import Camera, CameraModel
from estimator.distortion import fold_radius
from estimator.se3 import Array

SIZE_PX = (640, 400)


@st.composite
def cameras(draw: st.DrawFn) -> Camera:
    """Draw lenses as cars have them, strong distortion included."""
    model: CameraModel = draw(st.sampled_from(["pinhole", "brown_conrady", "kannala_brandt"]))
    focal_px = draw(st.floats(140, 900))
    center_px = (draw(st.floats(300, 340)), draw(st.floats(180, 220)))
    ranges = {
        "pinhole": [],
        "brown_conrady": [(-0.4, 0.3), (-0.1, 0.2), (-2e-3, 2e-3), (-2e-3, 2e-3), (-0.05, 0.02)],
        "kannala_brandt": [(-0.06, 0.1), (-0.02, 0.02), (-0.02, 0.02), (-4e-3, 4e-3)],
    }[model]
    distortion = tuple(draw(st.floats(low, high)) for low, high in ranges)
    aspect = draw(st.floats(0.98, 1.02))
    return Camera(model, SIZE_PX, (focal_px, focal_px * aspect), center_px, distortion)


def image_grid(step_px: int = 13) -> Array:
    width, height = SIZE_PX
    u, v = np.meshgrid(np.arange(-0.5, width, step_px), np.arange(-0.5, height, step_px))
    return np.stack([u.ravel(), v.ravel()], -1)


@given(cameras())
@settings(deadline=None)
def test_every_pixel_that_has_a_ray_comes_back(camera: Camera) -> None:
    pixels = image_grid()
    rays = camera.unproject(pixels)
    reached = ~np.isnan(rays).any(axis=1)
    assert np.isnan(rays[~reached]).all()
    np.testing.assert_allclose(np.linalg.norm(rays[reached], axis=1), 1.0, atol=1e-12)
    np.testing.assert_allclose(camera.project(rays[reached]), pixels[reached], atol=1e-9)


@given(cameras(), st.floats(0.1, 60.0))
@settings(deadline=None)
def test_every_point_that_is_seen_comes_back(camera: Camera, depth_m: float) -> None:
    side = np.linspace(-1.0, 1.0, 17)
    points = np.stack([*np.meshgrid(side, side, [1.0])], -1).reshape(-1, 3) * depth_m
    if camera.model == "brown_conrady":  # near the fold the inverse has few digits, though its pixel is exact
        limit = 0.95 * fold_radius(np.array(camera.distortion))
        points = points[np.hypot(*(points[:, :2] / points[:, 2:]).T) < limit]
    pixels = camera.project(points)
    seen = ~np.isnan(pixels).any(axis=1)
    assert seen.any()
    rays = points[seen] / np.linalg.norm(points[seen], axis=1, keepdims=True)
    np.testing.assert_allclose(camera.unproject(pixels[seen]), rays, atol=1e-8)


@given(cameras(), st.integers(0, 2**32 - 1))
@settings(deadline=None)
def test_jacobians_are_the_slopes(camera: Camera, seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = np.column_stack([rng.uniform(-0.5, 0.5, (20, 2)), np.ones(20)]) * rng.uniform(0.5, 30.0, (20, 1))
    pixels, jacobian = camera.project_with_jacobian(points)
    step_m = 1e-5 * points[:, 2]
    for axis in range(3):
        offset = np.zeros((20, 3))
        offset[:, axis] = step_m
        change = camera.project(points + offset) - camera.project(points - offset)
        slope = change / (2 * step_m[:, None])
        good = ~np.isnan(slope).any(axis=1) & ~np.isnan(pixels).any(axis=1)
        np.testing.assert_allclose(jacobian[good][:, :, axis], slope[good], rtol=1e-5, atol=1e-4)


@given(cameras())
@settings(deadline=None)
def test_a_point_s_distance_does_not_matter(camera: Camera) -> None:
    rays = camera.unproject(image_grid(41))
    rays = rays[~np.isnan(rays).any(axis=1)]
    np.testing.assert_allclose(camera.project(rays * 7.0), camera.project(rays), atol=1e-8)
