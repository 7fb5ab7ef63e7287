"""The grain of asphalt: seen from close by, gone a few metres on."""

import cv2
import numpy as np

from sim.paint.road import asphalt


def test_neighbouring_texels_of_asphalt_differ_and_a_few_together_do_not() -> None:
    road = asphalt(0.0, 12.0, -3.0, 3.0, np.random.default_rng(4), wear=0.0)
    levels = road.canvas.pixels[..., 0]
    grain = levels - cv2.blur(levels, (3, 3))
    assert np.median(np.abs(grain)) > 2.0
    together = cv2.resize(grain, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    assert np.median(np.abs(together)) < 0.25 * np.median(np.abs(grain))
