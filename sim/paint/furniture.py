"""The skin of street furniture: metal, wood, concrete, posters and traffic signs in one texture."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.paint.paving import lay_setts
from sim.shapes.mesh import Rect

SIZE_M = (4.0, 4.0)
_TEXEL_M = 0.0065
SIGN_M = 0.6
_REGIONS_M = {  # left, top, width, height
    "steel": (0.0, 0.0, 1.0, 1.0),
    "green": (1.0, 0.0, 1.0, 1.0),
    "cabinet": (2.0, 0.0, 1.2, 1.2),
    "stripes": (3.3, 0.0, 0.3, 1.2),
    "lamp": (3.65, 0.0, 0.3, 0.5),
    "back": (3.65, 0.55, 0.3, 0.6),
    "posters": (0.0, 1.25, 4.0, 1.35),
    "limit": (0.0, 2.65, SIGN_M, SIGN_M),
    "no_parking": (0.65, 2.65, SIGN_M, SIGN_M),
    "crossing": (1.3, 2.65, SIGN_M, SIGN_M),
    "warning": (1.95, 2.65, SIGN_M, SIGN_M),
    "plate": (2.6, 2.65, 1.3, 0.35),
    "wood": (0.0, 3.3, 1.6, 0.65),
    "concrete": (1.7, 3.3, 1.1, 0.65),
    "bin": (2.9, 3.05, 0.7, 0.9),
}


def region(name: str) -> Rect:
    """Texture coordinates of a part, a texel inside its edge."""
    x, y, w, h = _REGIONS_M[name]
    return (
        (x + 0.01) / SIZE_M[0],
        (y + 0.01) / SIZE_M[1],
        (x + w - 0.01) / SIZE_M[0],
        (y + h - 0.01) / SIZE_M[1],
    )


def paint_furniture(rng: np.random.Generator) -> RgbImage:
    """Paint all parts."""
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), (120, 120, 118))
    _plain(canvas, "steel", (150, 154, 154), rng)
    _plain(canvas, "green", (48, 74, 58), rng)
    _plain(canvas, "cabinet", (156, 158, 150), rng)
    _scrawl(canvas, "cabinet", 5, rng)
    _scrawl(canvas, "green", 2, rng)
    x, y, w, h = _REGIONS_M["stripes"]
    for k in range(6):
        canvas.rect(x, y + k * h / 6, x + w, y + (k + 1) * h / 6, (226, 226, 220) if k % 2 else (190, 30, 28))
    _plain(canvas, "lamp", (226, 224, 206), rng)
    _plain(canvas, "back", (128, 132, 134), rng)
    _posters(canvas, rng)
    _signs(canvas, rng)
    for name, tone, stone in (("wood", 120.0, (1.6, 0.12)), ("concrete", 158.0, (1.1, 0.32))):
        x, y, w, h = _REGIONS_M[name]
        lay_setts(canvas, x, y, x + w, y + h, stone, tone, rng)
    x, y, w, h = _REGIONS_M["bin"]
    canvas.rect(x, y, x + w, y + h, (58, 62, 66))
    canvas.rect(x, y, x + w, y + 0.12, rng.choice([(190, 160, 30), (40, 80, 150), (110, 70, 40)]))
    canvas.rect(x + 0.2, y + 0.35, x + 0.5, y + 0.6, (222, 220, 210))
    canvas.text(str(rng.integers(2, 80)), x + 0.24, y + 0.55, 0.14, (30, 30, 30))
    canvas.shade(0.10 * fractal(rng, canvas.shape, canvas.cells(0.4), 6, 0.75))
    return canvas.image()


def _plain(canvas: Canvas, name: str, color: tuple[float, float, float], rng: np.random.Generator) -> None:
    x, y, w, h = _REGIONS_M[name]
    canvas.rect(x, y, x + w, y + h, color)
    canvas.frame(x, y, x + w, y + h, 0.02, np.array(color) * 0.5)
    for _ in range(round(24 * w * h)):
        at = (rng.uniform(x, x + w), rng.uniform(y, y + h))
        canvas.ellipse(at, rng.uniform(0.01, 0.05, 2), np.array(color) * rng.choice([0.5, 0.7, 1.3]), 0.6)


def _scrawl(canvas: Canvas, name: str, count: int, rng: np.random.Generator) -> None:
    """Stickers and tags."""
    x, y, w, h = _REGIONS_M[name]
    for _ in range(count):
        a, b = rng.uniform(x + 0.1, x + w - 0.3), rng.uniform(y + 0.1, y + h - 0.25)
        canvas.rect(a, b, a + 0.2, b + 0.14, rng.uniform(30, 240, 3))
        canvas.rect(a + 0.03, b + 0.03, a + 0.14, b + 0.07, rng.uniform(30, 240, 3))
        line = np.column_stack([np.linspace(a, a + 0.3, 8), b + rng.normal(0, 0.08, 8)])
        canvas.stroke(line, 0.03, rng.uniform(10, 90, 3), 0.9)


def _posters(canvas: Canvas, rng: np.random.Generator) -> None:
    x0, y0, w, h = _REGIONS_M["posters"]
    canvas.rect(x0, y0, x0 + w, y0 + h, (170, 160, 140))
    words = ("JAZZ", "FEST", "ZOO", "KINO", "OPER", "LIVE", "EXPO", "RUN 10", "CIRCUS", "WAHL")
    x = x0
    while x < x0 + w - 0.2:
        width = min(rng.uniform(0.4, 0.7), x0 + w - x)
        for top, bottom in ((0.03, 0.62), (0.66, 1.32)):
            ground, ink = rng.uniform(130, 240) * rng.uniform(0.75, 1.0, 3), rng.uniform(0, 90, 3)
            canvas.rect(x + 0.02, y0 + top, x + width - 0.02, y0 + bottom, ground)
            canvas.ellipse(
                (x + width / 2, y0 + top + 0.34),
                (0.13, 0.12),
                rng.uniform(40, 140) * rng.uniform(0.6, 1.3, 3),
            )
            canvas.text(str(rng.choice(words)), x + 0.05, y0 + top + 0.17, 0.09, ink)
            for k in range(3):
                canvas.rect(
                    x + 0.06,
                    y0 + bottom - 0.12 + 0.03 * k,
                    x + width * 0.8,
                    y0 + bottom - 0.105 + 0.03 * k,
                    ink,
                )
        x += width


def _signs(canvas: Canvas, rng: np.random.Generator) -> None:
    half = SIGN_M / 2
    center = {
        name: np.array(_REGIONS_M[name][:2]) + half for name in ("limit", "no_parking", "crossing", "warning")
    }
    for name, inner in (("limit", (240, 240, 236)), ("no_parking", (30, 70, 160))):
        canvas.ellipse(center[name], (half, half), (196, 26, 26))
        canvas.ellipse(center[name], (half * 0.76, half * 0.76), inner)
    x, y = center["limit"]
    canvas.text("30", x - 0.17, y + 0.11, 0.22, (20, 20, 20))
    x, y = center["no_parking"]
    canvas.stroke(np.array([[x - 0.18, y - 0.18], [x + 0.18, y + 0.18]]), 0.07, (196, 26, 26))
    x, y = center["crossing"]
    canvas.rect(x - half, y - half, x + half, y + half, (24, 70, 160))
    canvas.fill(np.array([[x, y - 0.22], [x + 0.23, y + 0.18], [x - 0.23, y + 0.18]]), (240, 240, 236))
    canvas.stroke(np.array([[x - 0.02, y - 0.08], [x, y + 0.06], [x + 0.07, y + 0.14]]), 0.05, (20, 20, 20))
    canvas.stroke(np.array([[x, y + 0.06], [x - 0.08, y + 0.14]]), 0.05, (20, 20, 20))
    x, y = center["warning"]
    canvas.rect(x - half, y - half, x + half, y + half, (196, 26, 26))
    canvas.fill(np.array([[x, y - 0.17], [x + 0.2, y + 0.2], [x - 0.2, y + 0.2]]), (240, 240, 236))
    canvas.rect(x - 0.025, y - 0.05, x + 0.025, y + 0.15, (20, 20, 20))
    x, y, w, h = _REGIONS_M["plate"]
    canvas.rect(x, y, x + w, y + h, (30, 60, 140))
    canvas.text(
        str(rng.choice(["LINDENWEG", "MARKTGASSE", "HAFENSTR", "AM TOR"])),
        x + 0.08,
        y + 0.24,
        0.14,
        (240, 240, 236),
    )
