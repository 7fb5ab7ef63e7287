"""Patches, and how the view of a plane changes them."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.patches import Warps, normalised, plane_warp, sample_patches
from estimator.scene import Scene
from tests.canyon import PLANES, noise_image
from tests.mounts import BROWN, FISHEYE, PINHOLE, arc, left_side_rig

IMAGES = [[noise_image(60, 80, 0), None], [noise_image(60, 80, 1), noise_image(60, 80, 2)]]
ROAD = np.array([[6.0, 1.0, 0.0], [7.5, -0.5, 0.0], [9.0, 0.8, 0.0]])
UP = np.tile([0.0, 0.0, 1.0], (3, 1))


def at(*values: int) -> np.ndarray:
    return np.array(values, dtype=np.int64)


def test_an_upright_patch_at_a_whole_pixel_is_a_cutout() -> None:
    patch = sample_patches(IMAGES, at(1), at(1), np.array([[40.0, 30.0]]), None, 3)
    np.testing.assert_array_equal(patch[0], IMAGES[1][1][27:34, 37:44])


def test_every_row_reads_its_own_image() -> None:
    center = np.tile([40.0, 30.0], (3, 1))
    patches = sample_patches(IMAGES, at(1, 0, 1), at(1, 0, 0), center, None, 2)
    for patch, image in zip(patches, (IMAGES[1][1], IMAGES[0][0], IMAGES[1][0]), strict=True):
        np.testing.assert_array_equal(patch, image[28:33, 38:43])


def test_more_patches_than_fit_one_call_are_cut_too() -> None:
    center = np.column_stack([np.full(2500, 40.0), np.linspace(10, 50, 2500).round()])
    zeros = np.zeros(2500, np.int64)
    patches = sample_patches(IMAGES, zeros, zeros, center, None, 1)
    np.testing.assert_array_equal(patches[:, 1, 1], IMAGES[0][0][center[:, 1].astype(int), 40])


def test_a_quarter_turn_turns_the_patch() -> None:
    turn = Warps(np.array([[[0.0, -1.0], [1.0, 0.0]]]), np.zeros((1, 2)))
    upright = sample_patches(IMAGES, at(0), at(0), np.array([[40.0, 30.0]]), None, 3)[0]
    turned = sample_patches(IMAGES, at(0), at(0), np.array([[40.0, 30.0]]), turn, 3)[0]
    np.testing.assert_allclose(turned, np.rot90(upright), atol=1e-3)


def test_a_sighting_without_an_image_is_a_mistake() -> None:
    with pytest.raises(AssertionError):
        sample_patches(IMAGES, at(0), at(1), np.array([[40.0, 30.0]]), None, 3)


def test_normalised_patches_are_blind_to_brightness_and_contrast() -> None:
    patch = sample_patches(IMAGES, at(0), at(0), np.array([[40.0, 30.0]]), None, 5)
    plain, norm = normalised(patch)
    other, other_norm = normalised(0.5 * patch + 40)
    np.testing.assert_allclose(plain, other, atol=1e-5)
    np.testing.assert_allclose([(plain**2).sum(), plain.sum()], [1, 0], atol=1e-4)
    np.testing.assert_allclose(other_norm, 0.5 * norm, rtol=1e-5)


def scene(*lenses: object) -> Scene:
    return Scene(left_side_rig(*lenses), arc(1.0, 3), ROAD)


def test_the_warp_to_the_same_view_is_the_identity() -> None:
    view = (at(0, 0, 0), at(1, 1, 1))
    known = scene()
    warps = plane_warp(known, view, view, ROAD, UP, known.predict(*view, ROAD))
    np.testing.assert_allclose(warps.linear, np.tile(np.eye(2), (3, 1, 1)), atol=1e-9)
    np.testing.assert_allclose(warps.perspective, 0, atol=1e-9)


@pytest.mark.parametrize("lens", [PINHOLE, BROWN, FISHEYE])
def test_the_warp_carries_a_whole_patch_on_the_plane(lens: object) -> None:
    known = scene(lens, lens)
    anchor, target = (at(0, 0, 0), at(2, 2, 2)), (at(0, 0, 0), at(0, 0, 0))
    warps = plane_warp(known, anchor, target, ROAD, UP, known.predict(*target, ROAD))
    misses, linear_misses = [], []
    for step in np.array([[0.2, 0.0, 0.0], [-0.2, 0.06, 0.0], [0.0, -0.1, 0.0]]):
        in_anchor, in_target = (
            known.predict(*view, ROAD + step) - known.predict(*view, ROAD) for view in (anchor, target)
        )
        linear = np.einsum("nij,nj->ni", warps.linear, in_target)
        depth = 1 + (warps.perspective * in_target).sum(1)
        misses.append(np.abs(linear / depth[:, None] - in_anchor).max())
        linear_misses.append(np.abs(linear - in_anchor).max())
    assert max(misses) < 0.04
    assert max(linear_misses) > 2 * max(misses), "this is what the perspective part is for"


def test_a_plane_behind_the_camera_has_no_warp() -> None:
    known = scene()
    view = (at(0), at(0))
    behind = np.array([[-5.0, 0.0, 0.0]])
    wall = np.array([[1.0, 0.0, 0.0]])
    assert not plane_warp(known, view, view, behind, wall, np.array([[160.0, 100.0]])).finite.any()


def test_a_plane_behind_the_target_has_no_warp_though_the_anchor_sees_it() -> None:
    known = scene()
    point, facing_ahead = np.array([[-4.0, 5.0, 1.2]]), np.array([[1.0, 0.0, 0.0]])
    front = known.camera_pose(0, 0)
    mirrored = 2 * front.translation - point
    target_px = known.predict(at(0), at(0), mirrored)
    assert np.isfinite(target_px).all() and np.isfinite(known.predict(at(2), at(0), point)).all()
    assert not plane_warp(known, (at(2), at(0)), (at(0), at(0)), point, facing_ahead, target_px).finite.any()


def test_the_canyon_s_planes_are_right_angled() -> None:
    for plane in PLANES:
        np.testing.assert_allclose(np.linalg.norm(plane.normal), 1)
