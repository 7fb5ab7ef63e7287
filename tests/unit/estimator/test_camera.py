"""Projection: OpenCV's conventions, what cannot be seen, and speed of whole images."""

from __future__ import annotations

import time

import cv2
import gtsam
import numpy as np
import pytest

from estimator.camera import Camera
from estimator.se3 import SE3, Array

PINHOLE = Camera("pinhole", (640, 400), (457.0, 455.0), (319.5, 199.5))
BROWN = Camera(
    "brown_conrady", (640, 400), (457.0, 455.0), (322.1, 197.3), (-0.31, 0.11, 1e-3, -8e-4, -0.018)
)
FISHEYE = Camera("kannala_brandt", (640, 400), (200.0, 201.0), (319.5, 199.5), (0.02, -0.01, 0.003, -0.0005))
CAMERAS = [PINHOLE, BROWN, FISHEYE]
POINTS = np.array([[0.3, -0.2, 1.0], [-1.2, 0.4, 3.0], [0.0, 0.0, 2.0], [1.0, 1.0, 4.0]])


def every_pixel(camera: Camera) -> Array:
    width, height = camera.size_px
    return np.stack(np.meshgrid(np.arange(width), np.arange(height)), -1).reshape(-1, 2).astype(float)


def test_brown_conrady_is_opencv_s_plumb_bob() -> None:
    matrix = np.array([[457.0, 0, 322.1], [0, 455.0, 197.3], [0, 0, 1]])
    wanted, _ = cv2.projectPoints(POINTS, np.zeros(3), np.zeros(3), matrix, np.array(BROWN.distortion))
    np.testing.assert_allclose(BROWN.project(POINTS), wanted[:, 0], atol=1e-9)


def test_kannala_brandt_is_opencv_s_fisheye() -> None:
    matrix = np.array([[200.0, 0, 319.5], [0, 201.0, 199.5], [0, 0, 1]])
    wanted, _ = cv2.fisheye.projectPoints(
        POINTS[:, None], np.zeros(3), np.zeros(3), matrix, np.array(FISHEYE.distortion)
    )
    np.testing.assert_allclose(FISHEYE.project(POINTS), wanted[:, 0], atol=1e-9)


def test_the_optical_axis_meets_the_centre() -> None:
    for camera in CAMERAS:
        np.testing.assert_allclose(
            camera.project(np.array([[0.0, 0.0, 5.0]])), [camera.center_px], atol=1e-12
        )
        np.testing.assert_allclose(camera.unproject(np.array([camera.center_px])), [[0, 0, 1]], atol=1e-12)


def test_right_and_down_are_positive() -> None:
    for camera in CAMERAS:
        (u, v), (cx, cy) = camera.project(np.array([[0.1, 0.1, 1.0]]))[0], camera.center_px
        assert u > cx and v > cy


def test_a_projection_factor_of_gtsam_predicts_the_same_pixel() -> None:
    from gtsam import symbol_shorthand as key
    from gtsam_unstable import ProjectionFactorPPPCal3_S2 as Factor

    world_from_ego = SE3.exp(np.array([0.1, -0.2, 0.3, 4.0, 5.0, 0.1]))
    ego_from_cam = SE3.from_quaternion_xyzw(np.array([-0.5, 0.5, -0.5, 0.5]), np.array([1.8, 0.1, 1.45]))
    point_world = (world_from_ego @ ego_from_cam).apply(POINTS[0])
    noise = gtsam.noiseModel.Isotropic.Sigma(2, 1.0)
    calibration = gtsam.Cal3_S2(457.0, 455.0, 0.0, 319.5, 199.5)
    measured = PINHOLE.project(POINTS[:1])[0]
    factor = Factor(measured, noise, key.X(0), key.T(0), key.L(0), calibration)
    values = gtsam.Values()
    for name, pose in ((key.X(0), world_from_ego), (key.T(0), ego_from_cam)):
        values.insert(name, gtsam.Pose3(pose.matrix))
    values.insert(key.L(0), gtsam.Point3(point_world))
    assert factor.error(values) < 1e-18


@pytest.mark.parametrize("camera", [PINHOLE, BROWN])
def test_points_behind_are_not_seen(camera: Camera) -> None:
    assert np.isnan(camera.project(np.array([[0.1, 0.1, -1.0], [0.1, 0.1, 0.0]]))).all()


def test_a_fisheye_sees_sideways_but_not_straight_back() -> None:
    wide = Camera("kannala_brandt", (640, 640), (100.0, 100.0), (319.5, 319.5), (0.0, 0.0, 0.0, 0.0))
    pixels = wide.project(np.array([[1.0, 0.0, 0.0], [1.0, 0.0, -0.5], [0.0, 0.0, -1.0]]))
    np.testing.assert_allclose(pixels[0], [319.5 + 100.0 * np.pi / 2, 319.5], atol=1e-9)
    assert pixels[1, 0] > pixels[0, 0]
    assert np.isnan(pixels[2]).all()


STRONG_BARREL = Camera(
    "brown_conrady", (640, 400), (250.0, 250.0), (319.5, 199.5), (-0.35, 0.05, 0.0, 0.0, 0.0)
)
TIGHT_FISHEYE = Camera("kannala_brandt", (640, 400), (120.0, 120.0), (319.5, 199.5), (-0.1, 0.0, 0.0, 0.0))


@pytest.mark.parametrize("camera", [STRONG_BARREL, TIGHT_FISHEYE])
def test_a_pixel_that_no_ray_reaches_has_no_ray(camera: Camera) -> None:
    pixels = every_pixel(camera)
    rays = camera.unproject(pixels)
    reached = ~np.isnan(rays).any(axis=1)
    assert np.isnan(rays[~reached]).all()
    assert not reached[0] and reached[200 * 640 + 320]
    np.testing.assert_allclose(camera.project(rays[reached]), pixels[reached], atol=1e-9)


def test_a_point_beyond_the_fold_is_not_projected_back_into_the_image() -> None:
    radii = np.linspace(0.0, 20.0, 400)
    pixels = STRONG_BARREL.project(np.column_stack([radii, 0 * radii, 1 + 0 * radii]))
    seen = ~np.isnan(pixels).any(axis=1)
    assert seen[0] and not seen[-1]
    assert not (np.diff(seen.astype(int)) > 0).any()
    assert (np.diff(pixels[seen, 0]) > 0).all()


@pytest.mark.parametrize("camera", CAMERAS)
def test_no_number_in_is_no_number_out(camera: Camera) -> None:
    assert np.isnan(camera.unproject(np.array([[np.nan, 3.0], [np.inf, 0.0]]))[0]).all()
    assert np.isnan(camera.project(np.full((1, 3), np.nan))).all()


@pytest.mark.parametrize("camera", CAMERAS)
def test_nothing_in_is_nothing_out(camera: Camera) -> None:
    assert camera.project(np.zeros((0, 3))).shape == (0, 2)
    assert camera.unproject(np.zeros((0, 2))).shape == (0, 3)
    assert camera.project_with_jacobian(np.zeros((0, 3)))[1].shape == (0, 2, 3)


@pytest.mark.parametrize("camera", CAMERAS)
def test_a_whole_image_is_unprojected_quickly(camera: Camera) -> None:
    pixels = every_pixel(camera)
    best_s = float("inf")
    for _ in range(3):  # the best of three: another process may have had the core
        start_s = time.process_time()
        camera.unproject(pixels)
        best_s = min(best_s, time.process_time() - start_s)
    assert best_s < 2.0


def test_the_image_ends_half_a_pixel_beyond_the_last_centre() -> None:
    pixels = np.array([[-0.4, 0.0], [-0.6, 0.0], [639.4, 399.4], [639.6, 0.0], [np.nan, 0.0]])
    np.testing.assert_array_equal(PINHOLE.contains(pixels), [True, False, True, False, False])
    np.testing.assert_array_equal(PINHOLE.contains(pixels, 1.0), [False] * 5)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"model": "ideal"}, "there are: pinhole"),
        ({"distortion": (0.1,)}, "takes 0"),
        ({"size_px": (0, 400)}, "positive"),
        ({"focal_px": (-1.0, 1.0)}, "positive"),
        ({"focal_px": (1.0, float("nan"))}, "finite"),
        ({"center_px": (float("inf"), 1.0)}, "finite"),
    ],
)
def test_impossible_cameras_are_refused(change: dict[str, object], message: str) -> None:
    values = {"model": "pinhole", "size_px": (640, 400), "focal_px": (1.0, 1.0), "center_px": (0.0, 0.0)}
    with pytest.raises(ValueError, match=message):
        Camera(**(values | change))  # type: ignore[arg-type]
