"""Street furniture that people leave their marks on: each piece of a street has its own place in one texture.

Whoever matches by appearance would else take one switch cabinet for another with the same tags.
"""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal, scrawl
from sim.shapes.mesh import Rect

COUNTS = {"cabinet": 32, "bin": 20, "column": 12}
_CELLS_M = {"cabinet": (1.5, 1.2), "bin": (1.5, 0.9), "column": (3.0, 1.35)}
_SIZE_M = (6.0, 22.5)
_TEXEL_M = 0.009
_TOPS_M = {"cabinet": 0.0, "bin": 9.6, "column": 14.1}
_LACQUER_M = (0.0, 22.2, 6.0, 0.3)  # plain, for roofs and lids
_SIDE_M = 0.4  # of a cabinet's cell: its narrow walls
_GREEN = (48.0, 74.0, 58.0)
_CABINETS = ((156, 158, 150), (120, 128, 118), (176, 168, 146), (98, 112, 104), (140, 148, 158))
_BINS = (_GREEN, (72, 76, 80), (44, 60, 84), (96, 92, 84))
_WORDS = ("JAZZ", "FEST", "ZOO", "KINO", "OPER", "LIVE", "EXPO", "RUN 10", "CIRCUS", "WAHL")


def tagged_part(kind: str, index: int, share: tuple[float, float] = (0.0, 1.0)) -> Rect:
    """Texture coordinates of a piece, a texel inside its edge; ``share`` is an interval of its width."""
    x, y, w, h = _cell_m(kind, index)
    return _rect(x + share[0] * w, y, (share[1] - share[0]) * w, h)


def cabinet_parts(index: int) -> tuple[Rect, Rect]:
    """The door of a cabinet, and its narrow walls."""
    split = 1.0 - _SIDE_M / _CELLS_M["cabinet"][0]
    return tagged_part("cabinet", index, (0.0, split)), tagged_part("cabinet", index, (split, 1.0))


def lacquer() -> Rect:
    """Texture coordinates of plain lacquer."""
    return _rect(*_LACQUER_M)


def paint_tagged(rng: np.random.Generator) -> RgbImage:
    """Paint every piece of a street, all different."""
    canvas = Canvas(*_SIZE_M, (_TEXEL_M, _TEXEL_M), _GREEN)
    paint = {"cabinet": _cabinet, "bin": _bin, "column": _posters}
    for (kind, count), stream in zip(COUNTS.items(), rng.spawn(len(COUNTS)), strict=True):
        for index in range(count):
            paint[kind](canvas, _cell_m(kind, index), stream)
    canvas.shade(0.10 * fractal(rng, canvas.shape, canvas.cells(0.4), 6, 0.75))
    return canvas.image()


def _cell_m(kind: str, index: int) -> tuple[float, float, float, float]:
    """Left, top, width and height."""
    w, h = _CELLS_M[kind]
    row, column = divmod(index % COUNTS[kind], round(_SIZE_M[0] / w))
    return column * w, _TOPS_M[kind] + row * h, w, h


def _rect(x: float, y: float, w: float, h: float) -> Rect:
    (width, height), inset = _SIZE_M, 0.01
    return (x + inset) / width, (y + inset) / height, (x + w - inset) / width, (y + h - inset) / height


def _cabinet(canvas: Canvas, cell_m: tuple[float, float, float, float], rng: np.random.Generator) -> None:
    """Doors of one or two leaves with vents, and what was stuck and sprayed on them."""
    x, y, w, h = cell_m
    color = np.array(_CABINETS[rng.integers(len(_CABINETS))]) * rng.uniform(0.85, 1.1)
    canvas.rect(x, y, x + w, y + h, color)
    door = w - _SIDE_M
    seams = rng.choice([0.5, 0.62, 1.0]) * door
    canvas.frame(x, y, x + door, y + h, 0.025, color * 0.55)
    canvas.rect(x + seams - 0.008, y, x + seams + 0.008, y + h, color * 0.45)
    vent = rng.uniform(0.08, 0.85) * h
    for k in range(int(rng.integers(0, 6))):
        canvas.rect(x + 0.12, y + vent + 0.035 * k, x + 0.4, y + vent + 0.035 * k + 0.014, color * 0.4)
    _weather(canvas, (x, y, w, h), color, rng)
    _marks(canvas, (x, y, door, h), int(rng.integers(2, 8)), rng)
    _marks(canvas, (x + door, y, _SIDE_M, h), int(rng.integers(0, 3)), rng)


def _bin(canvas: Canvas, cell_m: tuple[float, float, float, float], rng: np.random.Generator) -> None:
    x, y, w, h = cell_m
    color = np.array(_BINS[rng.integers(len(_BINS))], float)
    canvas.rect(x, y, x + w, y + h, color)
    canvas.rect(x, y + 0.1, x + w, y + 0.2, color * 0.5)
    _weather(canvas, cell_m, color, rng)
    _marks(canvas, cell_m, int(rng.integers(1, 5)), rng)


def _weather(
    canvas: Canvas, cell_m: tuple[float, float, float, float], color: np.ndarray, rng: np.random.Generator
) -> None:
    """Spots, and streaks of rain."""
    x, y, w, h = cell_m
    for _ in range(round(10 * w * h)):
        at = (rng.uniform(x + 0.05, x + w - 0.05), rng.uniform(y + 0.05, y + h - 0.05))
        canvas.ellipse(at, rng.uniform(0.01, 0.05, 2), color * rng.choice([0.5, 0.7, 1.3]), 0.6)


def _marks(
    canvas: Canvas, cell_m: tuple[float, float, float, float], count: int, rng: np.random.Generator
) -> None:
    """Stickers, bills and tags of all sizes."""
    x, y, w, h = cell_m
    for _ in range(count):
        wide, tall = rng.uniform(0.06, 0.28), rng.uniform(0.05, 0.3)
        a, b = rng.uniform(x + 0.02, x + max(0.03, w - wide)), rng.uniform(y + 0.05, y + h - tall)
        if rng.random() < 0.6:
            wide = min(wide, x + w - a)
            canvas.rect(a, b, a + wide, b + tall, rng.uniform(30, 240, 3))
            canvas.rect(
                a + 0.1 * wide, b + 0.2 * tall, a + 0.7 * wide, b + 0.5 * tall, rng.uniform(30, 240, 3)
            )
        else:
            line = scrawl(rng, min(wide + 0.2, w - 0.1), rng.uniform(0.08, 0.24))
            at = np.array([min(a, x + max(0.05, w - wide - 0.25)), b + 0.1])
            canvas.stroke(line + at, rng.uniform(0.012, 0.03), rng.uniform(10, 200, 3) * 0.6, 0.9)


def _posters(canvas: Canvas, cell_m: tuple[float, float, float, float], rng: np.random.Generator) -> None:
    """Bills side by side around a column, two rows of them."""
    x0, y0, w, h = cell_m
    canvas.rect(x0, y0, x0 + w, y0 + h, (170, 160, 140))
    x = x0
    while x < x0 + w - 0.2:
        width = min(rng.uniform(0.4, 0.7), x0 + w - x)
        split = rng.uniform(0.45, 0.8)
        for top, bottom in ((0.03, split - 0.02), (split + 0.02, 1.32)):
            _poster(canvas, (x, y0 + top, width, bottom - top), rng)
        x += width


def _poster(canvas: Canvas, cell_m: tuple[float, float, float, float], rng: np.random.Generator) -> None:
    x, y, w, h = cell_m
    ground, ink = rng.uniform(130, 240) * rng.uniform(0.75, 1.0, 3), rng.uniform(0, 90, 3)
    canvas.rect(x + 0.02, y, x + w, y + h, ground)
    for _ in range(int(rng.integers(1, 5))):
        at = (x + w * rng.uniform(0.25, 0.75), y + rng.uniform(0.2, max(0.22, h - 0.2)))
        canvas.ellipse(at, rng.uniform(0.03, 0.14, 2), rng.uniform(20, 240, 3))
    canvas.text(str(rng.choice(_WORDS)), x + 0.05, y + 0.17, rng.uniform(0.07, 0.11), ink)
    for k in range(int(rng.integers(2, 5))):
        line = y + h - 0.12 + 0.03 * k
        canvas.rect(x + 0.06, line, x + w * rng.uniform(0.5, 0.9), line + 0.014, ink)
