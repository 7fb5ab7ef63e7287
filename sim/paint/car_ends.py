"""Paint of the front and the rear of a car: bumper, lamps, grille, plate, shut lines, and a window behind."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas
from sim.paint.car_layout import TALL_M, WIDE_M

_DARK, _GAP = (28, 28, 30), (20, 20, 22)
_GLASS, _INSIDE, _SKY = (34, 40, 46), (17, 19, 21), (146, 158, 168)


def paint_end(
    canvas: Canvas,
    at: tuple[float, float],
    lamp: tuple[int, int, int],
    color: Array,
    plates_m: tuple[float, ...],
    rng: np.random.Generator,
) -> None:
    """Bumper, lamps, grille and plate, from the upper left corner of the end on.

    Args:
        canvas: Texture of the car.
        at: Upper left corner of the end.
        lamp: Colour of its lamps.
        color: Of the car.
        plates_m: Choices for the height of the plate's upper edge, from 0.4 m above the road.
        rng: Source of randomness.
    """
    x0, ground = at[0], at[1] + TALL_M - 0.4
    make = rng.spawn(1)[0]
    canvas.rect(x0, ground - 0.12, x0 + WIDE_M, ground + 0.4, _DARK)
    if make.random() < 0.5:  # a bumper in the colour of the car over a dark apron
        canvas.rect(x0, ground - 0.12, x0 + WIDE_M, ground + make.uniform(0.0, 0.12), color * 0.92)
    wide, tall, raised = rng.uniform(0.22, 0.42), rng.uniform(0.12, 0.26), rng.uniform(0.46, 0.56)
    for left in (0.1, WIDE_M - 0.1 - wide):
        canvas.rect(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, lamp)
        canvas.frame(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, 0.03, (30, 30, 32))
    low, high = rng.uniform(0.52, 0.68), rng.uniform(0.24, 0.32)
    for bar in np.linspace(ground - 0.44, ground - high, int(rng.integers(1, 5))):
        canvas.rect(x0 + low, bar, x0 + WIDE_M - low, bar + 0.05, (30, 30, 32))
    letters = "".join(rng.choice(list("ABCDEFHKLMNPRSTUVX"), 3)) + str(rng.integers(100, 999))
    _plate(canvas, (x0, ground - make.choice(plates_m)), letters, make)


def _plate(canvas: Canvas, at: tuple[float, float], letters: str, rng: np.random.Generator) -> None:
    """A plate in a dark frame, perhaps with the blue strip of a country, not always quite in the middle."""
    x, y = at[0] + 0.66 + rng.uniform(-0.05, 0.05), at[1]
    canvas.rect(x - 0.025, y - 0.02, x + 0.605, y + rng.uniform(0.14, 0.17), (24, 24, 26))
    canvas.rect(x, y, x + 0.58, y + 0.12, (236, 234, 222))
    strip = 0.05 if rng.random() < 0.6 else 0.0
    canvas.rect(x, y, x + strip, y + 0.12, (30, 60, 150))
    cut = int(rng.integers(1, 4))
    canvas.text(letters[:cut] + " " + letters[cut:], x + 0.02 + strip, y + 0.1, 0.065, (20, 20, 20))


def trim_front(canvas: Canvas, at: tuple[float, float], color: Array, rng: np.random.Generator) -> None:
    """Edge of the bonnet, badge, air intake and fog lamps."""
    middle, ground = at[0] + WIDE_M / 2, at[1] + TALL_M
    bonnet = ground - rng.uniform(0.98, 1.06)
    canvas.rect(at[0] + 0.16, bonnet, at[0] + WIDE_M - 0.16, bonnet + 0.015, color * 0.35)
    canvas.ellipse((middle, ground - 0.78), (0.05, 0.04), (196, 198, 202))
    canvas.ellipse((middle, ground - 0.78), (0.032, 0.024), color * 0.5)
    intake = rng.uniform(0.45, 0.7)
    canvas.rect(middle - intake, ground - 0.36, middle + intake, ground - 0.24, (9, 9, 10))
    for y in np.arange(ground - 0.345, ground - 0.25, 0.035):
        canvas.rect(middle - intake, y, middle + intake, y + 0.012, (52, 52, 54))
    for side in (-1, 1):
        canvas.ellipse((middle + side * 0.76, ground - 0.33), (0.06, 0.045), (150, 152, 150))
    _bumper(canvas, at, rng)


def trim_rear(
    canvas: Canvas,
    at: tuple[float, float],
    belt_m: float,
    top_m: float,
    color: Array,
    rng: np.random.Generator,
) -> None:
    """A window with what is seen through it, shut lines of the tailgate, a handle, a badge, the exhaust.

    Args:
        canvas: Texture of the car.
        at: Upper left corner of its rear.
        belt_m: Height at which windows begin.
        top_m: Height of the roof.
        color: Of the car.
        rng: Source of randomness.
    """
    middle, ground = at[0] + WIDE_M / 2, at[1] + TALL_M
    _window(canvas, middle, ground - belt_m - 0.05, ground - top_m + 0.13, rng)
    gate = rng.uniform(0.66, 0.78)
    for side in (-1, 1):
        x = middle + side * gate
        canvas.rect(x - 0.008, ground - belt_m, x + 0.008, ground - 0.5, color * 0.35)
        canvas.rect(
            middle + side * 0.72 - 0.08,
            ground - 0.4,
            middle + side * 0.72 + 0.08,
            ground - 0.36,
            (140, 20, 18),
        )
    canvas.rect(middle - gate, ground - 0.6, middle + gate, ground - 0.585, color * 0.35)
    handle = ground - rng.uniform(0.64, 0.7)
    canvas.rect(middle - 0.2, handle, middle + 0.2, handle + 0.03, color * rng.choice([0.3, 1.4]))
    canvas.ellipse((middle, ground - 0.86), (0.045, 0.035), (196, 198, 202))
    canvas.rect(
        middle + 0.36, ground - 0.57, middle + rng.uniform(0.48, 0.62), ground - 0.54, (188, 190, 194)
    )
    canvas.ellipse((middle - 0.55, ground - 0.24), (0.045, 0.035), (92, 92, 94))
    canvas.ellipse((middle - 0.55, ground - 0.24), (0.032, 0.024), (8, 8, 8))
    _bumper(canvas, at, rng)


def _window(canvas: Canvas, middle: float, low: float, high: float, rng: np.random.Generator) -> None:
    """A rear window: seats inside, the sky on the glass, heating wires, a wiper."""
    tall = low - high
    if tall < 0.15:
        return
    half = np.array([0.68, 0.56])  # below and above
    outline = np.array([[-half[0], low], [half[0], low], [half[1], high], [-half[1], high]])
    outline += np.array([middle, 0.0])
    canvas.fill(outline, _GLASS)
    for side in (-1, 1):
        canvas.ellipse((middle + side * 0.34, low - 0.3 * tall), (0.13, 0.24 * tall), _INSIDE)
        canvas.rect(middle + side * 0.34 - 0.22, low - 0.16 * tall, middle + side * 0.34 + 0.22, low, _INSIDE)
    sheen = np.array([[-0.4, low], [-0.12, low], [0.08, high], [-0.24, high]])
    sheen += np.array([middle + rng.uniform(-0.3, 0.3), 0.0])
    canvas.fill(sheen, _SKY, 0.28)
    canvas.rect(middle - half[1], high, middle + half[1], high + 0.12 * tall, _SKY, 0.35)
    for y in np.arange(high + 0.16 * tall, low - 0.05, 0.06):
        canvas.rect(middle - 0.54, y, middle + 0.54, y + 0.006, (96, 74, 56), 0.5)
    canvas.stroke(outline, 0.03, _GAP, closed=True)
    arm = np.array([[middle, low], [middle + rng.uniform(0.3, 0.44), low - 0.06]])
    canvas.stroke(arm, 0.025, _GAP)


def _bumper(canvas: Canvas, at: tuple[float, float], rng: np.random.Generator) -> None:
    """On both sides of the plate an edge that catches light, and the wear of parking."""
    y, plate = at[1] + TALL_M - 0.53, (0.64, 1.26)
    for left, right in ((0.0, plate[0]), (plate[1], WIDE_M)):
        canvas.rect(at[0] + left, y, at[0] + right, y + 0.018, (92, 92, 94))
        for _ in range(int(rng.integers(0, 3))):
            x, length = at[0] + rng.uniform(left + 0.05, right - 0.35), rng.uniform(0.06, 0.3)
            low, high = y + rng.uniform(0.03, 0.1, 2)
            canvas.stroke(np.array([[x, low], [x + length, high]]), 0.012, (122, 120, 116), 0.7)
