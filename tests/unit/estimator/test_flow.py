"""Following points: exact to a small part of a pixel, and honest about those that got lost."""

from __future__ import annotations

import cv2
import numpy as np

from estimator.flow import FlowConfig, follow
from tests.canyon import noise_image

CONFIG = FlowConfig()
BEFORE = noise_image(200, 320, 0)
GRID = np.stack(np.meshgrid(np.arange(40.0, 290, 20), np.arange(40.0, 170, 20)), -1).reshape(-1, 2)


def shifted(dx: float, dy: float) -> np.ndarray:
    matrix = np.array([[1.0, 0.0, dx], [0.0, 1.0, dy]])
    return cv2.warpAffine(BEFORE, matrix, (320, 200), flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REFLECT)


def test_a_known_shift_is_recovered() -> None:
    moved, good = follow(BEFORE, shifted(5.3, -2.6), GRID, GRID, CONFIG)
    assert good.mean() > 0.95
    assert np.median(np.linalg.norm(moved[good] - GRID[good] - [5.3, -2.6], axis=1)) < 0.05


def test_a_guess_reaches_further_than_the_pyramid() -> None:
    guess = GRID + np.array([58.0, 1.0])
    inside = GRID[:, 0] < 240
    moved, good = follow(BEFORE, shifted(60.0, 0.0), GRID[inside], guess[inside], CONFIG)
    assert good.mean() > 0.9
    assert np.abs(moved[good] - GRID[inside][good] - [60.0, 0.0]).max() < 0.3


def test_a_true_guess_on_another_picture_is_not_believed() -> None:
    _, good = follow(BEFORE, noise_image(200, 320, 9), GRID, GRID, CONFIG)
    assert good.mean() < 0.1


def test_points_that_get_covered_are_lost() -> None:
    after = shifted(2.0, 0.0)
    after[:, 160:] = noise_image(200, 160, 7)
    _, good = follow(BEFORE, after, GRID, GRID, CONFIG)
    assert good[GRID[:, 0] < 140].all()
    assert good[GRID[:, 0] > 175].mean() < 0.1


def test_points_that_leave_the_image_are_lost() -> None:
    edge = np.array([[314.0, 100.0], [160.0, 100.0]])
    _, good = follow(BEFORE, shifted(8.0, 0.0), edge, edge + np.array([8.0, 0.0]), CONFIG)
    assert good.tolist() == [False, True]


def test_points_too_near_the_border_to_compare_are_lost() -> None:
    edge = np.array([[300.0, 100.0], [314.0, 100.0]])
    _, good = follow(BEFORE, shifted(3.0, 0.0), edge, edge + np.array([3.0, 0.0]), CONFIG)
    assert good.tolist() == [True, False]


def test_no_points_is_no_error() -> None:
    moved, good = follow(BEFORE, BEFORE, np.zeros((0, 2)), np.zeros((0, 2)), CONFIG)
    assert moved.shape == (0, 2) and good.shape == (0,)
