"""What the rear of a car shows."""

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.car_ends import paint_end, trim_rear
from sim.paint.car_layout import REAR_AT_M, SIZE_M, TALL_M, WIDE_M

BELT_M, TOP_M = 1.15, 1.95


def test_a_van_has_a_dark_rear_window_above_its_belt_and_paint_below() -> None:
    color = np.array([200.0, 200.0, 200.0])
    canvas = Canvas(*SIZE_M, (0.02, 0.02), color)
    trim_rear(canvas, REAR_AT_M, BELT_M, TOP_M, color, np.random.default_rng(0))

    def level(z_m: float) -> float:
        rows = round((REAR_AT_M[1] + TALL_M - z_m) / 0.02)
        columns = slice(round((REAR_AT_M[0] + 0.5) / 0.02), round((REAR_AT_M[0] + WIDE_M - 0.5) / 0.02))
        return float(np.median(canvas.pixels[rows, columns]))

    assert level(0.5 * (BELT_M + TOP_M)) < 100 < level(BELT_M - 0.1)


def test_no_two_cars_of_one_coat_bear_the_same_plate() -> None:
    color = np.array([200.0, 200.0, 200.0])
    ends = set()
    for stream in np.random.default_rng(0).spawn(12):
        canvas = Canvas(*SIZE_M, (0.02, 0.02), color)
        paint_end(canvas, REAR_AT_M, (176, 22, 20), color, (0.14,), stream)
        middle = slice(round((REAR_AT_M[0] + 0.6) / 0.02), round((REAR_AT_M[0] + 1.3) / 0.02))
        ends.add(canvas.image()[:, middle].tobytes())
    assert len(ends) == 12
