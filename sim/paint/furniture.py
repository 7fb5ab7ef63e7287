"""The coat of street furniture: metal, wood, concrete, posters, traffic signs and lights in one texture.

``sim.paint.signs`` paints what is to be read. A street has several coats with their own posters and names.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.furniture_parts import REGIONS_M, SIZE_M
from sim.paint.noise import fractal, scrawl
from sim.paint.paving import lay_setts
from sim.paint.signs import paint_plates, paint_signals, paint_signs

_TEXEL_M = 0.0065
_LAMP_LEVEL, _SIGNAL_LEVEL = 250, 110


def paint_furniture(names: Sequence[str], rng: np.random.Generator) -> RgbImage:
    """Paint all parts of one coat; ``names`` are those of streets on its plates."""
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), (120, 120, 118))
    for name, color in (
        ("steel", (150, 154, 154)),
        ("green", (48, 74, 58)),
        ("cabinet", (156, 158, 150)),
        ("back", (128, 132, 134)),
        ("post_box", (206, 168, 28)),
        ("meter", (70, 78, 92)),
        ("trolley", (140, 146, 150)),
    ):
        _plain(canvas, name, color, rng)
    _plain(canvas, "lamp", (246, 244, 230), rng)
    for name, count in (("cabinet", 5), ("green", 2), ("meter", 2)):
        _scrawl(canvas, name, count, rng)
    x, y, w, h = REGIONS_M["stripes"]
    for k in range(6):
        canvas.rect(x, y + k * h / 6, x + w, y + (k + 1) * h / 6, (226, 226, 220) if k % 2 else (190, 30, 28))
    _posters(canvas, rng)
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
    """Return (H, W) the light that lamps and signals shed at night, in levels of a sunny day."""
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), (0, 0, 0))
    x, y, w, h = REGIONS_M["lamp"]
    canvas.rect(x, y, x + w, y + h, (_LAMP_LEVEL,) * 3)
    paint_signals(canvas, glow=_SIGNAL_LEVEL)
    return canvas.image()[..., 0]


def _plain(canvas: Canvas, name: str, color: tuple[float, float, float], rng: np.random.Generator) -> None:
    x, y, w, h = REGIONS_M[name]
    canvas.rect(x, y, x + w, y + h, color)
    canvas.frame(x, y, x + w, y + h, 0.02, np.array(color) * 0.5)
    for _ in range(round(24 * w * h)):
        at = (rng.uniform(x, x + w), rng.uniform(y, y + h))
        canvas.ellipse(at, rng.uniform(0.01, 0.05, 2), np.array(color) * rng.choice([0.5, 0.7, 1.3]), 0.6)


def _scrawl(canvas: Canvas, name: str, count: int, rng: np.random.Generator) -> None:
    """Stickers and tags."""
    x, y, w, h = REGIONS_M[name]
    for _ in range(count):
        a, b = rng.uniform(x + 0.1, x + max(0.12, w - 0.3)), rng.uniform(y + 0.1, y + h - 0.25)
        canvas.rect(a, b, a + 0.2, b + 0.14, rng.uniform(30, 240, 3))
        canvas.rect(a + 0.03, b + 0.03, a + 0.14, b + 0.07, rng.uniform(30, 240, 3))
        line = scrawl(rng, 0.3, 0.16) + np.array([a, b])
        canvas.stroke(line, 0.02, rng.uniform(10, 90, 3), 0.9)


def _posters(canvas: Canvas, rng: np.random.Generator) -> None:
    x0, y0, w, h = REGIONS_M["posters"]
    canvas.rect(x0, y0, x0 + w, y0 + h, (170, 160, 140))
    words = ("JAZZ", "FEST", "ZOO", "KINO", "OPER", "LIVE", "EXPO", "RUN 10", "CIRCUS", "WAHL")
    x = x0
    while x < x0 + w - 0.2:
        width = min(rng.uniform(0.4, 0.7), x0 + w - x)
        split = rng.uniform(0.45, 0.8)
        for top, bottom in ((0.03, split - 0.02), (split + 0.02, 1.32)):
            ground, ink = rng.uniform(130, 240) * rng.uniform(0.75, 1.0, 3), rng.uniform(0, 90, 3)
            canvas.rect(x + 0.02, y0 + top, x + width - 0.02, y0 + bottom, ground)
            for _ in range(int(rng.integers(1, 5))):
                at = (
                    x + width * rng.uniform(0.25, 0.75),
                    y0 + rng.uniform(top + 0.2, max(top + 0.22, bottom - 0.2)),
                )
                canvas.ellipse(at, rng.uniform(0.03, 0.14, 2), rng.uniform(20, 240, 3))
            canvas.text(str(rng.choice(words)), x + 0.05, y0 + top + 0.17, rng.uniform(0.07, 0.11), ink)
            for k in range(int(rng.integers(2, 5))):
                line = y0 + bottom - 0.12 + 0.03 * k
                canvas.rect(x + 0.06, line, x + width * rng.uniform(0.5, 0.9), line + 0.014, ink)
        x += width


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
