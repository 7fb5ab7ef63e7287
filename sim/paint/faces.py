"""Paint of a face and of the hair around it."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas
from sim.paint.person_layout import REGIONS


def paint_head(canvas: Canvas, skin: Array, hair: Array) -> None:
    """The face, from the neck (bottom) to the crown; 0.1 m above the bottom is the chin."""
    x, y, w, h = REGIONS["head"]
    canvas.rect(x, y, x + w, y + h, skin)
    middle = x + w / 2
    canvas.rect(x, y + 0.8 * h, x + w, y + h, skin * 0.8)
    canvas.rect(x, y, x + 0.3 * w, y + 0.78 * h, skin * 0.93)
    for side in (-1, 1):
        eye = (middle + side * 0.042, y + 0.44 * h)
        canvas.ellipse((eye[0], eye[1] - 0.002), (0.026, 0.018), skin * 0.72, 0.7)
        canvas.ellipse(eye, (0.016, 0.009), (236, 234, 230))
        canvas.ellipse(eye, (0.0075, 0.0085), (40, 30, 26))
        canvas.rect(eye[0] - 0.022, eye[1] - 0.034, eye[0] + 0.022, eye[1] - 0.025, hair * 0.9)
        canvas.ellipse((middle + side * 0.055, y + 0.58 * h), (0.03, 0.024), skin * [1.06, 0.93, 0.9], 0.6)
    canvas.ellipse((middle, y + 0.565 * h), (0.022, 0.01), skin * 0.74, 0.8)
    canvas.ellipse((middle, y + 0.665 * h), (0.032, 0.010), skin * [0.86, 0.6, 0.58])
    canvas.rect(middle - 0.03, y + 0.664 * h, middle + 0.03, y + 0.670 * h, skin * 0.45)


def paint_hair(canvas: Canvas, hair: Array, rng: np.random.Generator) -> None:
    """Strands of several tones."""
    x, y, w, h = REGIONS["hair"]
    canvas.rect(x, y, x + w, y + h, hair)
    for left in np.linspace(x, x + w, 90):
        tone = hair * rng.uniform(0.6, 1.5)
        canvas.rect(left, y, left + 0.006, y + h, np.minimum(tone, 250), 0.6)
