"""The skin of one person: face, hair, clothes, shoes and bag side by side in one small texture."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect

SIZE_M = (1.92, 2.4)
_TEXEL_M = 0.004
# Name: left, top, width, height in metres. The front of what goes round a body is at its middle.
REGIONS = {
    "torso": (0.0, 0.0, 1.12, 0.8),
    "head": (1.16, 0.0, 0.72, 0.36),
    "hair": (1.16, 0.4, 0.72, 0.36),
    "thigh": (0.0, 0.84, 0.56, 0.5),
    "shin": (0.6, 0.84, 0.5, 0.5),
    "shoe": (1.16, 0.84, 0.5, 0.3),
    "sleeve": (0.0, 1.38, 0.4, 0.4),
    "cuff": (0.44, 1.38, 0.4, 0.4),
    "hand": (0.88, 1.38, 0.2, 0.2),
    "bag": (1.16, 1.2, 0.6, 0.56),
    "coat": (0.0, 1.82, 1.2, 0.54),
    "hat": (1.24, 1.82, 0.64, 0.3),
}
SKIN_TONES = ((236, 200, 176), (222, 178, 148), (190, 140, 108), (141, 96, 70), (92, 62, 48))
HAIR = ((30, 24, 22), (62, 42, 30), (110, 78, 48), (176, 142, 92), (150, 150, 150), (96, 40, 24))
TOPS = (
    (34, 38, 46), (200, 60, 50), (226, 222, 210), (52, 84, 140), (212, 170, 60), (70, 110, 76),
    (120, 120, 126), (150, 90, 120), (236, 120, 50), (88, 62, 48), (170, 196, 210), (24, 26, 28),
)  # fmt: skip
TROUSERS = ((38, 48, 72), (70, 90, 124), (28, 28, 30), (140, 122, 96), (88, 88, 92), (196, 188, 170))
SHOES = ((230, 230, 228), (36, 34, 34), (96, 66, 44), (120, 44, 40), (60, 70, 90))


Top = Literal["shirt", "striped", "jacket", "hoodie"]
Hair = Literal["short", "long", "bald"]
_TOPS_WORN: tuple[Top, ...] = ("shirt", "striped", "jacket", "hoodie")
_HAIR_WORN: tuple[Hair, ...] = ("short", "short", "long", "long", "bald")


@dataclass(frozen=True)
class Look:
    """What a person wears; what changes the shape as well as the paint."""

    top: Top
    hair: Hair
    hat: bool
    coat: bool
    bag: bool


def draw_look(rng: np.random.Generator, rides: bool = False) -> Look:
    """Draw what somebody wears today; coats do not go with bicycles, and helmets stand in for hats."""
    tops: tuple[Literal["shirt", "striped", "jacket", "hoodie"], ...] = (
        "shirt",
        "striped",
        "jacket",
        "hoodie",
    )
    styles: tuple[Literal["short", "long", "bald"], ...] = ("short", "short", "long", "long", "bald")
    top, hair = tops[rng.integers(4)], styles[rng.integers(5)]
    hat, coat, bag = rng.random(3) < (0.6 if rides else 0.25, 0.0 if rides else 0.3, 0.45)
    return Look(top, hair, bool(hat), bool(coat), bool(bag))


def region(name: str) -> Rect:
    """Part of the texture as texture coordinates, a texel in from its borders."""
    x, y, w, h = REGIONS[name]
    low, high = np.array([x, y]) + _TEXEL_M, np.array([x + w, y + h]) - _TEXEL_M
    (u0, v0), (u1, v1) = low / SIZE_M, high / SIZE_M
    return float(u0), float(v0), float(u1), float(v1)


def paint_person(look: Look, rng: np.random.Generator) -> RgbImage:
    """Paint one person's skin and clothes."""
    skin = np.array(SKIN_TONES[rng.integers(len(SKIN_TONES))], float)
    hair, top = _pick(HAIR, rng), _pick(TOPS, rng)
    trousers, accent = _pick(TROUSERS, rng), _pick(TOPS, rng)
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), skin)
    _torso(canvas, look, top, trousers, accent)
    _legs(canvas, trousers, rng)
    _arms(canvas, look, top, accent, skin)
    _fill(canvas, "coat", top * 0.94)
    x, y, w, h = REGIONS["coat"]
    canvas.rect(x + w / 2 - 0.01, y, x + w / 2 + 0.01, y + h, top * 0.5)
    _fill(canvas, "hat", accent)
    _fill(canvas, "bag", _pick(TOPS, rng))
    _bag(canvas, accent)
    _wrinkle(canvas, rng)
    _head(canvas, skin, hair)
    _hair(canvas, hair, rng)
    canvas.shade(0.025 * fractal(rng, canvas.shape, canvas.cells(0.02), 3, 0.7))
    return canvas.image()


def _pick(colors: tuple[tuple[int, int, int], ...], rng: np.random.Generator) -> Array:
    color: Array = np.clip(np.array(colors[rng.integers(len(colors))]) + rng.normal(0, 9, 3), 8, 245)
    return color


def _fill(canvas: Canvas, name: str, color: Array) -> None:
    x, y, w, h = REGIONS[name]
    canvas.rect(x, y, x + w, y + h, color)


def _torso(canvas: Canvas, look: Look, top: Array, trousers: Array, accent: Array) -> None:
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


def _legs(canvas: Canvas, trousers: Array, rng: np.random.Generator) -> None:
    for name in ("thigh", "shin"):
        _fill(canvas, name, trousers)
        x, y, w, h = REGIONS[name]
        for seam in (0.25, 0.75):
            canvas.rect(x + w * seam - 0.004, y, x + w * seam + 0.004, y + h, trousers * 0.6)
        canvas.ellipse(
            (x + w / 2, y + (0.9 if name == "thigh" else 0.1) * h), (0.09, 0.1), trousers * 1.15, 0.6
        )
    x, y, w, h = REGIONS["shin"]
    canvas.rect(x, y + 0.9 * h, x + w, y + h, trousers * 0.75)
    shoe = _pick(SHOES, rng)
    _fill(canvas, "shoe", shoe)
    x, y, w, h = REGIONS["shoe"]
    # Around a shoe, which is lofted ahead, u begins on the right and comes by sole, left side and laces.
    canvas.rect(
        x + 0.09 * w, y, x + 0.41 * w, y + h, np.clip(0.45 * shoe + 110.0 * (shoe.mean() < 90), 0, 255)
    )
    for lace in np.arange(0.3, 0.6, 0.07):
        canvas.rect(x + 0.68 * w, y + lace * h, x + 0.84 * w, y + (lace + 0.025) * h, 255.0 - 0.6 * shoe)


def _arms(canvas: Canvas, look: Look, top: Array, accent: Array, skin: Array) -> None:
    _fill(canvas, "sleeve", top)
    _fill(canvas, "cuff", skin if look.top == "shirt" else top)
    _fill(canvas, "hand", skin * 0.96)
    x, y, w, h = REGIONS["sleeve"]
    if look.top == "striped":
        for row in np.arange(y, y + h, 0.07):
            canvas.rect(x, row, x + w, row + 0.03, accent)
    canvas.rect(x, y + 0.93 * h, x + w, y + h, top * 0.7)
    if look.top != "shirt":
        x, y, w, h = REGIONS["cuff"]
        canvas.rect(x, y + 0.88 * h, x + w, y + 0.9 * h, top * 0.5)


def _bag(canvas: Canvas, accent: Array) -> None:
    x, y, w, h = REGIONS["bag"]
    for row, tall in ((0.12, 0.015), (0.5, 0.02)):
        canvas.rect(x, y + row * h, x + w, y + row * h + tall, (24, 24, 26))
    canvas.frame(x + 0.1, y + 0.55 * h, x + w - 0.1, y + 0.9 * h, 0.01, (30, 30, 32))
    canvas.rect(x, y + 0.3 * h, x + w, y + 0.34 * h, accent)


def _wrinkle(canvas: Canvas, rng: np.random.Generator) -> None:
    """Folds of cloth: slanting streaks, and the soft shade of larger ones."""
    small, large = canvas.cells(0.05), canvas.cells(0.16)
    folds = fractal(rng, canvas.shape, (small[0] * 0.6, small[1] * 3.0), 3, 0.6)
    canvas.shade(0.075 * folds + 0.06 * fractal(rng, canvas.shape, large, 3, 0.6))


def _head(canvas: Canvas, skin: Array, hair: Array) -> None:
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


def _hair(canvas: Canvas, hair: Array, rng: np.random.Generator) -> None:
    x, y, w, h = REGIONS["hair"]
    canvas.rect(x, y, x + w, y + h, hair)
    for left in np.linspace(x, x + w, 90):
        tone = hair * rng.uniform(0.6, 1.5)
        canvas.rect(left, y, left + 0.006, y + h, np.minimum(tone, 250), 0.6)
