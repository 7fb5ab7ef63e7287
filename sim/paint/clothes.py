"""Paint of clothes, shoes and bags."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas
from sim.paint.looks import Look
from sim.paint.noise import fractal
from sim.paint.person_layout import REGIONS, fill_region

SHOES = ((230, 230, 228), (36, 34, 34), (96, 66, 44), (120, 44, 40), (60, 70, 90))


def pick(colors: tuple[tuple[int, int, int], ...], rng: np.random.Generator) -> Array:
    """One of some colors, dyed or faded a little."""
    color: Array = np.clip(np.array(colors[rng.integers(len(colors))]) + rng.normal(0, 9, 3), 8, 245)
    return color


def paint_torso(canvas: Canvas, look: Look, top: Array, trousers: Array, accent: Array) -> None:
    """What is worn above the hips, front in the middle."""
    x, y, w, h = REGIONS["torso"]
    canvas.rect(x, y, x + w, y + h, top)
    middle, hem = x + w / 2, y + h * 0.8
    if look.top == "striped":
        for row in np.arange(y + 0.14, hem, 0.07):
            canvas.rect(x, row, x + w, row + 0.03, accent)
    if look.top in ("jacket", "hoodie"):
        canvas.rect(middle - 0.006, y + 0.1, middle + 0.006, y + h, top * 0.35)
        for side in (-1, 1):
            pocket = np.array([[0.07, 0.5], [0.16, 0.46], [0.165, 0.6], [0.07, 0.62]]) * [side, 1]
            canvas.stroke(pocket + np.array([middle, y]), 0.008, top * 0.45, closed=True)
        canvas.rect(x, y + 0.235, x + w, y + 0.25, top * 0.7)
    else:
        canvas.rect(x, hem, x + w, y + h, trousers)
        canvas.rect(x, hem - 0.012, x + w, hem, top * 0.6)
    if look.top == "hoodie":
        canvas.ellipse((middle, y + 0.17), (0.13, 0.05), top * 0.6)
    if look.top == "shirt":
        canvas.ellipse((middle, y + 0.33), (0.07, 0.06), accent)
        canvas.ellipse((middle, y + 0.33), (0.045, 0.035), top)
    collar = np.array([[-0.12, 0.08], [0.12, 0.08], [0.0, 0.2]]) + np.array([middle, y])
    canvas.fill(collar, accent * 0.9 if look.top != "shirt" else top * 0.8)


def paint_legs(canvas: Canvas, trousers: Array, rng: np.random.Generator) -> None:
    """Trousers and shoes."""
    for name in ("thigh", "shin"):
        fill_region(canvas, name, trousers)
        x, y, w, h = REGIONS[name]
        for seam in (0.25, 0.75):
            canvas.rect(x + w * seam - 0.004, y, x + w * seam + 0.004, y + h, trousers * 0.6)
        canvas.ellipse(
            (x + w / 2, y + (0.9 if name == "thigh" else 0.1) * h), (0.09, 0.1), trousers * 1.15, 0.6
        )
    x, y, w, h = REGIONS["shin"]
    canvas.rect(x, y + 0.9 * h, x + w, y + h, trousers * 0.75)
    shoe = pick(SHOES, rng)
    fill_region(canvas, "shoe", shoe)
    x, y, w, h = REGIONS["shoe"]
    # Around a shoe, which is lofted ahead, u begins on the right and comes by sole, left side and laces.
    canvas.rect(
        x + 0.09 * w, y, x + 0.41 * w, y + h, np.clip(0.45 * shoe + 110.0 * (shoe.mean() < 90), 0, 255)
    )
    for lace in np.arange(0.3, 0.6, 0.07):
        canvas.rect(x + 0.68 * w, y + lace * h, x + 0.84 * w, y + (lace + 0.025) * h, 255.0 - 0.6 * shoe)


def paint_arms(canvas: Canvas, look: Look, top: Array, accent: Array, skin: Array) -> None:
    """Sleeves, cuffs and hands."""
    fill_region(canvas, "sleeve", top)
    fill_region(canvas, "cuff", skin if look.top == "shirt" else top)
    fill_region(canvas, "hand", skin * 0.96)
    x, y, w, h = REGIONS["sleeve"]
    if look.top == "striped":
        for row in np.arange(y, y + h, 0.07):
            canvas.rect(x, row, x + w, row + 0.03, accent)
    canvas.rect(x, y + 0.93 * h, x + w, y + h, top * 0.7)
    if look.top != "shirt":
        x, y, w, h = REGIONS["cuff"]
        canvas.rect(x, y + 0.88 * h, x + w, y + 0.9 * h, top * 0.5)


def paint_bag(canvas: Canvas, accent: Array) -> None:
    """A backpack with its straps and pocket."""
    x, y, w, h = REGIONS["bag"]
    for row, tall in ((0.12, 0.015), (0.5, 0.02)):
        canvas.rect(x, y + row * h, x + w, y + row * h + tall, (24, 24, 26))
    canvas.frame(x + 0.1, y + 0.55 * h, x + w - 0.1, y + 0.9 * h, 0.01, (30, 30, 32))
    canvas.rect(x, y + 0.3 * h, x + w, y + 0.34 * h, accent)


def wrinkle(canvas: Canvas, rng: np.random.Generator) -> None:
    """Folds of cloth: slanting streaks, and the soft shade of larger ones."""
    small, large = canvas.cells(0.05), canvas.cells(0.16)
    folds = fractal(rng, canvas.shape, (small[0] * 0.6, small[1] * 3.0), 3, 0.6)
    canvas.shade(0.075 * folds + 0.06 * fractal(rng, canvas.shape, large, 3, 0.6))
