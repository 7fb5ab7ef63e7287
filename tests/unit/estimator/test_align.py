"""Measuring a patch again in another picture: to a small part of a pixel, or not at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from estimator.align import AlignConfig, Aligned, align
from estimator.anchors import choose_anchors
from estimator.observations import Observations
from estimator.se3 import Array
from tests.canyon_window import look
from tests.mounts import arc, left_side_rig

CONFIG = AlignConfig()
WINDOW = look(left_side_rig(), arc(0.6, 3), ("front", "left_front"), 80)
NOT_ROAD = np.zeros(len(WINDOW.normals_world), bool)
ANCHORS = choose_anchors(WINDOW.scene, WINDOW.observations, WINDOW.images, NOT_ROAD)
SEEN = WINDOW.observations.select(WINDOW.observations.keyframe != 1)


def aligned(start_px: Array, seen: Observations = SEEN, images: object = WINDOW.images) -> Aligned:
    return align(WINDOW.scene, images, ANCHORS, seen.landmark, seen.camera, seen.keyframe, start_px, CONFIG)


def offsets(length_px: float) -> Array:
    """Return (N, 2) shifts of one length in all directions."""
    angle = np.arange(len(SEEN)) * 2.4
    return length_px * np.column_stack([np.cos(angle), np.sin(angle)])


def test_a_shift_of_a_pixel_and_a_half_is_undone_to_a_twentieth() -> None:
    found = aligned(SEEN.pixels + offsets(1.5))
    good = np.isfinite(found.pixels[:, 0])
    assert good.mean() > 0.6
    assert np.median(np.linalg.norm(found.pixels[good] - SEEN.pixels[good], axis=1)) < 0.05


def test_brightness_and_contrast_do_not_matter() -> None:
    images = [[(0.6 * image + 30).astype(np.uint8) for image in row] for row in WINDOW.images]
    images[1] = WINDOW.images[1]
    found = aligned(SEEN.pixels, images=images)
    good = np.isfinite(found.pixels[:, 0])
    assert good.mean() > 0.6
    assert np.median(np.linalg.norm(found.pixels[good] - SEEN.pixels[good], axis=1)) < 0.05


def test_a_wrong_place_is_unlike_and_not_believed() -> None:
    found = aligned(SEEN.pixels + offsets(25.0))
    assert np.isnan(found.pixels[:, 0]).mean() > 0.97
    assert np.nanmedian(found.likeness) < 0.6


def test_what_is_believed_looks_alike_and_is_near_the_start() -> None:
    start_px = SEEN.pixels + offsets(2.5)
    found = aligned(start_px)
    good = np.isfinite(found.pixels[:, 0])
    assert 10 < good.sum() < len(good)
    assert (found.likeness[good] > CONFIG.min_likeness).all()
    assert np.linalg.norm(found.pixels[good] - start_px[good], axis=1).max() < CONFIG.max_shift_px


def test_the_anchor_itself_stays_where_it_is() -> None:
    own = WINDOW.observations.select(WINDOW.observations.keyframe == 1)
    found = aligned(own.pixels, own)
    good = np.isfinite(found.pixels[:, 0])
    assert good.mean() > 0.9
    np.testing.assert_allclose(found.pixels[good], own.pixels[good], atol=0.01)
    assert found.likeness[good].min() > 0.999


def test_noise_in_the_picture_is_told_from_the_patch_itself() -> None:
    """The stated sigma is the scatter that the noise makes, give or take what planes and resampling add."""
    rng = np.random.default_rng(0)
    clean = aligned(SEEN.pixels)
    for noise in (4.0, 12.0):
        images = [
            [np.clip(image + rng.normal(0, noise, image.shape), 0, 255).astype(np.uint8) for image in row]
            for row in WINDOW.images
        ]
        images[1] = WINDOW.images[1]
        found = aligned(SEEN.pixels, images=images)
        good = np.isfinite(found.pixels[:, 0]) & np.isfinite(clean.pixels[:, 0])
        scatter_px = 1.4826 * np.median(np.abs(found.pixels[good] - clean.pixels[good]))
        assert good.sum() > 30 and 0.5 < np.median(found.sigma_px[good]) / scatter_px < 2.0


def test_without_an_anchor_there_is_no_answer() -> None:
    none = replace(ANCHORS, valid=np.zeros_like(ANCHORS.valid))
    found = align(
        WINDOW.scene, WINDOW.images, none, SEEN.landmark, SEEN.camera, SEEN.keyframe, SEEN.pixels, CONFIG
    )
    assert np.isnan(found.pixels).all() and np.isnan(found.likeness).all()
