"""Paint of the front and the rear of a car."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.car_layout import TALL_M, WIDE_M


def paint_end(
    canvas: Canvas, at: tuple[float, float], belt: float, lamp: tuple[int, int, int], rng: np.random.Generator
) -> None:
    """Bumper, lamps, grille and plate, from the upper left corner of the end on."""
    x0, ground = at[0], at[1] + TALL_M - 0.4
    canvas.rect(x0, ground - 0.12, x0 + WIDE_M, ground + 0.4, (28, 28, 30))
    wide, tall, raised = rng.uniform(0.22, 0.42), rng.uniform(0.12, 0.26), rng.uniform(0.46, 0.56)
    for left in (0.1, WIDE_M - 0.1 - wide):
        canvas.rect(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, lamp)
        canvas.frame(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, 0.03, (30, 30, 32))
    low, high = rng.uniform(0.52, 0.68), rng.uniform(0.24, 0.32)
    for bar in np.linspace(ground - 0.44, ground - high, int(rng.integers(1, 5))):
        canvas.rect(x0 + low, bar, x0 + WIDE_M - low, bar + 0.05, (30, 30, 32))
    canvas.rect(x0 + 0.66, ground - 0.14, x0 + 1.24, ground - 0.02, (236, 234, 222))
    plate = "".join(rng.choice(list("ABCDEFHKLMNPRSTUVX"), 3)) + str(rng.integers(100, 999))
    canvas.text(plate, x0 + 0.69, ground - 0.035, 0.08, (20, 20, 20))
