"""Corners: where they are found, and who gets the places."""

from __future__ import annotations

import cv2
import numpy as np

from estimator.detect import DetectConfig, detect_corners
from tests.canyon import noise_image

CONFIG = DetectConfig()
NOWHERE = np.zeros((0, 2))
NOISE = noise_image(240, 320, 0)
CELL_PX = 16


def test_a_corner_is_found_where_it_is() -> None:
    image = np.full((240, 320), 60, np.uint8)
    image[100:180, 140:220] = 200
    found = detect_corners(image, NOWHERE, 100, CONFIG)
    for corner in ((140, 100), (219, 100), (140, 179), (219, 179)):
        assert np.linalg.norm(found - corner, axis=1).min() < 5.0  # the corner is in the window


def test_a_blank_image_has_no_corners() -> None:
    assert detect_corners(np.full((240, 320), 90, np.uint8), NOWHERE, 100, CONFIG).shape == (0, 2)


def test_no_more_are_returned_than_there_is_room_for() -> None:
    assert len(detect_corners(NOISE, NOWHERE, 37, CONFIG)) == 37


def test_a_faint_road_gets_as_many_places_as_a_vivid_facade() -> None:
    faint = cv2.addWeighted(NOISE, 0.25, np.full_like(NOISE, 128), 0.75, 0)
    image = np.vstack([NOISE[:120], faint[120:]])
    rows = detect_corners(image, NOWHERE, 60, CONFIG)[:, 1]
    assert np.sum(rows > 144) >= 20


def test_bands_that_hold_points_already_wait() -> None:
    taken = np.column_stack([np.linspace(5, 315, 20), np.full(20, 40.0)])
    rows = detect_corners(NOISE, taken, 40, CONFIG)[:, 1]
    assert not np.any(rows < 3 * CELL_PX)


def test_a_cell_that_holds_a_point_gets_no_second() -> None:
    first = detect_corners(NOISE, NOWHERE, 1000, CONFIG)
    kept, given_up = first[:-10], first[-10:]
    again = detect_corners(NOISE, kept, 1000, CONFIG)
    np.testing.assert_array_equal(np.sort(again, axis=0), np.sort(given_up, axis=0))


def test_points_beyond_the_border_occupy_nothing() -> None:
    outside = np.array([[-30.0, 50.0], [400.0, 50.0], [50.0, 500.0]])
    found = detect_corners(NOISE, outside, 1000, CONFIG)
    np.testing.assert_array_equal(found, detect_corners(NOISE, NOWHERE, 1000, CONFIG))


def test_the_border_is_left_alone() -> None:
    found = detect_corners(NOISE, NOWHERE, 1000, CONFIG)
    assert len(found) > 50 and found.min() >= CONFIG.border_px
    assert found[:, 0].max() <= 320 - CONFIG.border_px


def test_no_corner_is_taken_where_none_may_be() -> None:
    usable = np.ones((240, 320), bool)
    usable[160:, 80:240] = False
    found = detect_corners(NOISE, NOWHERE, 1000, CONFIG, usable).astype(int)
    assert len(found) > 50 and usable[found[:, 1], found[:, 0]].all()
