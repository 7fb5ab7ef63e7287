"""Patches, upright and through a map."""

from __future__ import annotations

import numpy as np
import pytest

from estimator.patches import normalised, sample_patches
from estimator.warps import Warps
from tests.canyon import PLANES, noise_image

IMAGES = [[noise_image(60, 80, 0), None], [noise_image(60, 80, 1), noise_image(60, 80, 2)]]


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


def test_the_canyon_s_planes_are_right_angled() -> None:
    for plane in PLANES:
        np.testing.assert_allclose(np.linalg.norm(plane.normal), 1)
