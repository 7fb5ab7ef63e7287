"""The coat of street furniture: metal, wood, concrete, traffic signs and lights in one texture.

``sim.paint.signs`` paints what is to be read, ``sim.paint.tagged`` what bears posters, stickers and tags. A
street has several coats with their own names.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.furniture_parts import REGIONS_M, SIZE_M
from sim.paint.noise import fractal
from sim.paint.paving import lay_setts
from sim.paint.signs import paint_plates, paint_signals, paint_signs

_TEXEL_M = 0.0065
_SIGNAL_LEVEL = 110


def paint_furniture(names: Sequence[str], rng: np.random.Generator) -> RgbImage:
    """Paint all parts of one coat; ``names`` are those of streets on its plates."""
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), (120, 120, 118))
    for name, color in (
        ("steel", (150, 154, 154)),
        ("green", (48, 74, 58)),
        ("back", (128, 132, 134)),
        ("post_box", (206, 168, 28)),
        ("meter", (70, 78, 92)),
        ("trolley", (140, 146, 150)),
    ):
        _plain(canvas, name, color, rng)
    _plain(canvas, "lamp", (246, 244, 230), rng)
    x, y, w, h = REGIONS_M["stripes"]
    for k in range(6):
        canvas.rect(x, y + k * h / 6, x + w, y + (k + 1) * h / 6, (226, 226, 220) if k % 2 else (190, 30, 28))
    for name, tone, stone in (("wood", 120.0, (1.6, 0.12)), ("concrete", 158.0, (1.1, 0.32))):
        x, y, w, h = REGIONS_M[name]
        lay_setts(canvas, x, y, x + w, y + h, stone, tone, rng)
    _bin(canvas, rng)
    _boxes(canvas, rng)
    canvas.shade(0.10 * fractal(rng, canvas.shape, canvas.cells(0.4), 6, 0.75))
    paint_signs(canvas)
    paint_signals(canvas)
    paint_plates(canvas, names)
    return canvas.image()


def furniture_glow() -> NDArray[np.uint8]:
    """Return (H, W) the light that signals shed at night, in levels of a sunny day.

    Street lamps are none of it: which of them burn is for the light to say, and it draws their faces.
    """
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), (0, 0, 0))
    paint_signals(canvas, glow=_SIGNAL_LEVEL)
    return canvas.image()[..., 0]


def _plain(canvas: Canvas, name: str, color: tuple[float, float, float], rng: np.random.Generator) -> None:
    x, y, w, h = REGIONS_M[name]
    canvas.rect(x, y, x + w, y + h, color)
    canvas.frame(x, y, x + w, y + h, 0.02, np.array(color) * 0.5)
    for _ in range(round(24 * w * h)):
        at = (rng.uniform(x, x + w), rng.uniform(y, y + h))
        canvas.ellipse(at, rng.uniform(0.01, 0.05, 2), np.array(color) * rng.choice([0.5, 0.7, 1.3]), 0.6)


def _bin(canvas: Canvas, rng: np.random.Generator) -> None:
    x, y, w, h = REGIONS_M["bin"]
    canvas.rect(x, y, x + w, y + h, (58, 62, 66))
    canvas.rect(x, y, x + w, y + 0.12, rng.choice([(190, 160, 30), (40, 80, 150), (110, 70, 40)]))
    canvas.rect(x + 0.2, y + 0.3, x + 0.5, y + 0.52, (222, 220, 210))
    canvas.text(str(rng.integers(2, 80)), x + 0.24, y + 0.48, 0.14, (30, 30, 30))


def _boxes(canvas: Canvas, rng: np.random.Generator) -> None:
    """Ticket machine, post box with its slot, glass of a shelter, a board with a menu."""
    x, y, w, h = REGIONS_M["ticket"]
    canvas.rect(x, y, x + w, y + h, (40, 84, 150))
    canvas.rect(x + 0.1, y + 0.12, x + w - 0.1, y + 0.34, (214, 222, 214))
    canvas.rect(x + 0.15, y + 0.42, x + 0.3, y + 0.6, (30, 30, 32))
    canvas.text("P", x + 0.36, y + 0.6, 0.16, (240, 240, 240))
    x, y, w, h = REGIONS_M["post_box"]
    canvas.rect(x + 0.06, y + 0.14, x + w - 0.06, y + 0.2, (20, 20, 20))
    canvas.rect(x + 0.1, y + 0.4, x + w - 0.1, y + 0.62, (236, 234, 226))
    x, y, w, h = REGIONS_M["glass"]
    canvas.rect(x, y, x + w, y + h, (122, 136, 142))
    canvas.fill(np.array([[x, y], [x + 0.5, y], [x + 0.1, y + h], [x, y + h]]), (196, 206, 210), 0.5)
    canvas.frame(x, y, x + w, y + h, 0.04, (60, 62, 64))
    x, y, w, h = REGIONS_M["menu"]
    canvas.rect(x, y, x + w, y + h, (44, 46, 44))
    for k in range(7):
        canvas.rect(
            x + 0.06,
            y + 0.2 + 0.1 * k,
            x + w * rng.uniform(0.5, 0.92),
            y + 0.235 + 0.1 * k,
            rng.uniform(170, 240, 3),
        )
    canvas.frame(x, y, x + w, y + h, 0.04, (130, 92, 54))
