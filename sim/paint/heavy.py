"""The paint of a box truck and of a bus: sides, front, rear and roof side by side in one texture."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect

SIZE_M = (12.6, 6.4)
TALL_M = 3.1
_TEXEL_M = 0.014
REGIONS = {  # left, top, width, height
    "left": (0.0, 0.0, 9.4, TALL_M),
    "right": (0.0, 3.15, 9.4, TALL_M),
    "front": (9.5, 0.0, 2.1, TALL_M),
    "rear": (9.5, 3.15, 2.1, TALL_M),
    "roof": (11.7, 0.0, 0.8, 3.0),
    "black": (11.7, 3.1, 0.8, 1.6),
    "wheel": (11.7, 4.8, 0.84, 0.84),
}
_FIRMS = ("MEIER UMZUG", "FRISCH & GUT", "NORDLOG", "BLITZ PAKET", "BAU KRAUSE", "AQUA SERVICE")
_COLORS = ((226, 226, 222), (214, 180, 40), (40, 80, 140), (176, 40, 36), (60, 120, 80), (190, 200, 206))


def region(name: str) -> Rect:
    """Part of the texture as texture coordinates."""
    x, y, w, h = REGIONS[name]
    (u0, v0), (u1, v1) = np.array([x, y]) / SIZE_M, np.array([x + w, y + h]) / SIZE_M
    inset = _TEXEL_M / SIZE_M[0] if name == "black" else 0.0
    return float(u0) + inset, float(v0) + inset, float(u1) - inset, float(v1) - inset


def paint_truck(length_m: float, cab_m: float, rng: np.random.Generator) -> RgbImage:
    """Paint a box truck; sides are read from their left, so the cab is on the right of the right side."""
    box, cab = (np.array(_COLORS[k], float) for k in rng.choice(len(_COLORS), 2, replace=False))
    ink = 245.0 - 0.85 * box
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), box)
    firm = _FIRMS[rng.integers(len(_FIRMS))]
    for name in ("left", "right"):
        x, y, _, _ = REGIONS[name]
        to_cab = length_m - cab_m
        start, cab_at = (x + cab_m, x) if name == "left" else (x, x + to_cab)
        canvas.rect(start, y + 1.6, start + to_cab, y + 1.78, ink)
        canvas.text(firm, start + 0.35, y + 1.2, 0.42, ink)
        phone = f"0{rng.integers(100, 999)} {rng.integers(10000, 99999)}"
        canvas.text(phone, start + 0.4, y + 2.08, 0.16, ink)
        for rib in np.arange(0.0, to_cab, 0.62):
            canvas.rect(start + rib, y, start + rib + 0.02, y + 2.2, box * 0.75)
        canvas.rect(cab_at, y, cab_at + cab_m, y + TALL_M, cab)
        canvas.rect(cab_at + 0.35, y + 1.05, cab_at + cab_m - 0.3, y + 1.75, (36, 42, 48))
        canvas.frame(cab_at + 0.25, y + 0.95, cab_at + cab_m - 0.2, y + 2.5, 0.02, cab * 0.5)
        _skirt(canvas, x, y, length_m)
    _front(canvas, cab)
    _rear(canvas, box, rng)
    return _finish(canvas, rng)


def paint_bus(length_m: float, rng: np.random.Generator) -> RgbImage:
    """Paint a town bus: a band of windows, doors on the right side, the number of its line."""
    body = np.array(_COLORS[rng.integers(len(_COLORS))], float)
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), body)
    for name in ("left", "right"):
        x, y, _, _ = REGIONS[name]
        canvas.rect(x, y + 0.75, x + length_m, y + 1.75, (32, 38, 44))
        for post in np.arange(0.1, length_m, 1.25):
            canvas.rect(x + post, y + 0.75, x + post + 0.07, y + 1.75, (16, 16, 18))
            glare = np.array([[0.2, 1.7], [0.5, 0.8], [0.75, 0.8], [0.45, 1.7]]) + np.array([x + post, y])
            canvas.fill(glare, (96, 108, 118), 0.5)
        canvas.rect(x, y + 1.95, x + length_m, y + 2.12, 245.0 - 0.8 * body)
        canvas.text("STADTBUS", x + 0.35 * length_m, y + 2.4, 0.26, 245.0 - 0.8 * body)
        _skirt(canvas, x, y, length_m)
    x, y, _, _ = REGIONS["right"]
    for door in (0.2 * length_m, 0.52 * length_m, 0.86 * length_m):
        canvas.rect(x + door, y + 0.7, x + door + 1.0, y + 2.72, (40, 48, 54))
        canvas.frame(x + door, y + 0.7, x + door + 1.0, y + 2.72, 0.05, (20, 20, 22))
        canvas.rect(x + door + 0.48, y + 0.7, x + door + 0.52, y + 2.72, (20, 20, 22))
    _front(canvas, body)
    x, y, w, _ = REGIONS["front"]
    canvas.rect(x + 0.3, y + 0.1, x + w - 0.3, y + 0.42, (16, 16, 14))
    canvas.text(str(rng.integers(2, 99)), x + 0.45, y + 0.37, 0.2, (240, 180, 40))
    _rear(canvas, body, rng)
    return _finish(canvas, rng)


def _skirt(canvas: Canvas, x: float, y: float, length_m: float) -> None:
    canvas.rect(x, y + 2.62, x + length_m, y + TALL_M, (34, 34, 36))
    for at in np.arange(0.5, length_m, 1.5):
        canvas.rect(x + at, y + 2.5, x + at + 0.09, y + 2.55, (236, 140, 30))


def _front(canvas: Canvas, color: Array) -> None:
    x, y, w, h = REGIONS["front"]
    canvas.rect(x, y, x + w, y + h, color)
    canvas.rect(x + 0.12, y + 0.55, x + w - 0.12, y + 1.6, (30, 36, 42))
    glare = np.array([[0.3, 1.5], [0.8, 0.6], [1.2, 0.6], [0.7, 1.5]]) + np.array([x, y])
    canvas.fill(glare, (130, 144, 154), 0.45)
    canvas.rect(x + 0.4, y + 1.95, x + w - 0.4, y + 2.3, (30, 30, 32))
    canvas.rect(x, y + 2.5, x + w, y + h, (36, 36, 38))
    for left in (0.12, w - 0.5):
        canvas.rect(x + left, y + 2.28, x + left + 0.38, y + 2.48, (242, 242, 232))
    _plate(canvas, x + w / 2, y + 2.72, "HZ 4711")


def _rear(canvas: Canvas, color: Array, rng: np.random.Generator) -> None:
    x, y, w, h = REGIONS["rear"]
    canvas.rect(x, y, x + w, y + h, color * 0.95)
    canvas.rect(x + w / 2 - 0.015, y + 0.1, x + w / 2 + 0.015, y + 2.4, color * 0.4)
    for bar in (0.3, 1.2, 2.1):
        canvas.rect(x + 0.15, y + bar, x + w - 0.15, y + bar + 0.03, color * 0.6)
    canvas.rect(x, y + 2.5, x + w, y + h, (36, 36, 38))
    for left in (0.05, w - 0.4):
        canvas.rect(x + left, y + 2.5, x + left + 0.35, y + 2.66, (190, 26, 22))
    for k in range(7):
        canvas.rect(x + 0.3 * k, y + 2.86, x + 0.3 * k + 0.15, y + 2.95, (230, 60, 40))
    letters = "".join(rng.choice(list("ABCDEFHKLM"), 2))
    _plate(canvas, x + w / 2, y + 2.68, f"{letters} {rng.integers(100, 999)}")


def _plate(canvas: Canvas, middle: float, y: float, words: str) -> None:
    canvas.rect(middle - 0.28, y, middle + 0.28, y + 0.13, (238, 236, 226))
    canvas.text(words, middle - 0.24, y + 0.11, 0.085, (20, 20, 20))


def _finish(canvas: Canvas, rng: np.random.Generator) -> RgbImage:
    canvas.shade(0.05 * fractal(rng, canvas.shape, canvas.cells(0.7), 6, 0.7))
    x, y, w, h = REGIONS["black"]
    canvas.rect(x, y, x + w, y + h, (22, 22, 23))
    x, y, w, h = REGIONS["wheel"]
    middle = (x + w / 2, y + h / 2)
    canvas.ellipse(middle, (w / 2, h / 2), (24, 24, 25))
    canvas.ellipse(middle, (0.26, 0.26), (150, 152, 154))
    canvas.ellipse(middle, (0.12, 0.12), (70, 72, 74))
    for angle in np.linspace(0, 2 * np.pi, 8, endpoint=False):
        bolt = (middle[0] + 0.19 * np.cos(angle), middle[1] + 0.19 * np.sin(angle))
        canvas.ellipse(bolt, (0.03, 0.03), (40, 40, 42))
    return canvas.image()
