"""Stains on asphalt have shapes of their own."""

import numpy as np

from sim.paint.blots import blot
from sim.paint.canvas import Canvas


def spilt(seed: int) -> np.ndarray:
    canvas = Canvas(2.0, 2.0, (0.02, 0.02), (100, 100, 100))
    blot(canvas, (1.0, 1.0), (0.4, 0.4), 30.0, np.random.default_rng(seed))
    return canvas.pixels[..., 0]


def test_a_stain_is_no_disc() -> None:
    y, x = np.nonzero(spilt(0) < 99.0)
    x_m, y_m = 0.02 * (x - x.mean()), 0.02 * (y - y.mean())
    sectors = ((np.arctan2(y_m, x_m) + np.pi) / (2 * np.pi) * 12).astype(int) % 12
    reach_m = [np.hypot(x_m, y_m)[sectors == k].max() for k in range(12)]
    assert np.std(reach_m) > 0.05 * np.mean(reach_m)


def test_no_two_stains_are_the_same() -> None:
    assert not np.array_equal(spilt(0), spilt(1))
