"""Surfaces reconstructed from depth: exact on planes, and nothing leaks over edges."""

import numpy as np

from estimator.camera import Camera
from estimator.se3 import SE3
from sim.light.surfaces import STEP, Surfaces
from sim.rendering.view import FAR_M, View

PINHOLE = Camera("pinhole", (64, 40), (45.0, 46.0), (30.0, 21.0))
POSE = SE3.exp(np.array([0.3, -0.2, 0.5, 1.0, 2.0, 3.0]))


def rays() -> np.ndarray:
    u, v = np.meshgrid(np.arange(64), np.arange(40))
    return np.stack([(u - 30) / 45, (v - 21) / 46, np.ones_like(u)], -1)


def plane(normal_cam: np.ndarray, distance_m: float) -> np.ndarray:
    nearness = np.maximum(rays() @ normal_cam / distance_m, 1 / FAR_M)
    return (1 / nearness).astype(np.float32)


def of(depth_m: np.ndarray) -> Surfaces:
    return Surfaces(View(PINHOLE, POSE), depth_m)


def test_points_and_normals_of_a_plane_are_exact() -> None:
    normal_cam = np.array([0.3, -0.2, 0.9]) / np.linalg.norm([0.3, -0.2, 0.9])
    surfaces = of(plane(normal_cam, 5.0))
    towards_camera = -(POSE.rotation @ normal_cam)
    assert np.allclose(surfaces.normals.reshape(3, -1), towards_camera[:, None], atol=1e-3)
    heights = (surfaces.points_m.reshape(3, -1).T - POSE.translation) @ towards_camera
    assert np.allclose(heights, -5.0, atol=1e-3)


def test_light_does_not_leak_over_an_edge() -> None:
    depth_m = np.full((40, 64), 20.0, np.float32)
    depth_m[:, 31:] = 4.0
    surfaces = of(depth_m)
    near = (depth_m[::STEP, ::STEP] < 10).astype(np.float32)
    assert np.array_equal(surfaces.enlarged(near), (depth_m < 10).astype(np.float32))


def test_a_crease_parts_what_faces_differently() -> None:
    wall, ground = plane(np.array([0.0, 0.0, 1.0]), 6.0), plane(np.array([0.0, 1.0, 0.0]), 1.2)
    depth_m = np.minimum(wall, ground)
    surfaces = of(depth_m)
    is_ground = (ground < wall).astype(np.float32)
    assert np.array_equal(surfaces.enlarged(is_ground[::STEP, ::STEP]), is_ground)


def test_nothing_far_away_is_sky() -> None:
    assert of(np.full((40, 64), FAR_M, np.float32)).sky.all()
    assert not of(np.full((40, 64), 100.0, np.float32)).sky.any()


def test_a_narrow_kerb_faces_the_road_to_its_very_edges() -> None:
    """Taken one by one, its slope along a row and the road's down a column would face the camera."""
    pinhole = Camera("pinhole", (200, 120), (150.0, 150.0), (20.0, 20.0))
    u, v = np.meshgrid(np.arange(200), np.arange(120))
    x, y = (u - 20) / 150, (v - 20) / 150
    road, pavement, face = y / 1.45, y / 1.3, x / 3.0  # 1/depth of each
    is_face = (face >= road) & (face <= pavement)
    nearness = np.where(is_face, face, np.where(face < road, road, pavement))
    depth_m = (1 / np.maximum(nearness, 1 / FAR_M)).astype(np.float32)
    aside = of_pinhole(pinhole, depth_m).normals[0]
    sampled = is_face[::STEP, ::STEP] & (depth_m[::STEP, ::STEP] < 25)
    assert sampled.sum() > 20
    assert np.mean(aside[sampled] < -0.9) > 0.9


def of_pinhole(pinhole: Camera, depth_m: np.ndarray) -> Surfaces:
    return Surfaces(View(pinhole, SE3()), depth_m)
