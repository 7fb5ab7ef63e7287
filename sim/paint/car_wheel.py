"""Paint of a wheel of a car."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.car_layout import WHEEL_AT_M, WHEEL_M


def paint_wheel(canvas: Canvas, rng: np.random.Generator) -> None:
    """A tyre around a rim with holes, spokes, or a cap."""
    x, y = WHEEL_AT_M[0] + WHEEL_M, WHEEL_AT_M[1] + WHEEL_M
    canvas.ellipse((x, y), (WHEEL_M, WHEEL_M), (24, 24, 25))
    rim, style, count = rng.uniform(0.19, 0.25), rng.integers(3), int(rng.integers(5, 11))
    light, dark = np.full(3, rng.uniform(90, 190)), np.full(3, rng.uniform(22, 50))
    turn = rng.uniform(0, 2 * np.pi)
    angles = turn + np.linspace(0, 2 * np.pi, count, endpoint=False)
    canvas.ellipse((x, y), (rim, rim), dark if style == 1 else light)
    for angle in angles:
        ahead = np.array([np.cos(angle), np.sin(angle)])
        if style == 0:
            hole = rng.uniform(0.03, 0.05)
            canvas.ellipse((x, y) + 0.62 * rim * ahead, (hole, hole), dark)
        elif style == 1:
            canvas.stroke(np.array([[x, y], (x, y) + rim * ahead]), 0.16 / count**0.5, light)
        else:
            canvas.stroke(np.array([(x, y) + 0.4 * rim * ahead, (x, y) + 0.8 * rim * ahead]), 0.02, dark)
    canvas.ellipse((x, y), (0.3 * rim, 0.3 * rim), light * rng.uniform(0.6, 1.1))
