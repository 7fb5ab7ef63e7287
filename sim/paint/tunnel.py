"""The lining of a tunnel, unrolled, and the wall around its openings."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import crooked_line, fractal, scrawl

PANEL_M = 2.5  # of the wall's cladding, and of the ceiling's formwork
LAMP_EVERY_M, LAMP_M = 5.0, 1.3
_TEXEL_M = (0.02, 0.02)
_ROUGH = 0.04  # deviation of brightness within centimetres: pores, splashes


def paint_lining(
    length_m: float, wall_m: float, width_m: float, first_m: float, rng: np.random.Generator
) -> RgbImage:
    """Left wall from the walk up, ceiling from left to right, right wall down; x runs along the tunnel.

    Args:
        length_m: Of this piece.
        wall_m: Height of the walls.
        width_m: Of the ceiling.
        first_m: How far into the tunnel the piece begins; joints and lamps go on from piece to piece.
        rng: Source of randomness.
    """
    canvas = Canvas(length_m, 2 * wall_m + width_m, _TEXEL_M, (128, 126, 120))
    soot = fractal(rng, canvas.shape, canvas.cells(2.0), 4, 0.6)
    high = 2 * wall_m + width_m
    for low, up in ((0.0, 1.0), (high, -1.0)):
        _wall(canvas, low, up, wall_m, first_m, rng)
    joints = np.arange(-(first_m % PANEL_M), length_m, PANEL_M)
    for x in joints:
        canvas.rect(x, wall_m, x + 0.04, wall_m + width_m, (58, 57, 54))
        canvas.rect(x + 0.04, wall_m, x + 0.1, wall_m + width_m, (112, 110, 104), 0.5)
    for y in (wall_m + 0.5, wall_m + width_m - 0.6):
        canvas.rect(0, y, length_m, y + 0.12, (70, 72, 72))
        canvas.rect(0, y + 0.03, length_m, y + 0.06, (150, 152, 150))
    _stains(canvas, length_m, wall_m, width_m, rng)
    canvas.shade(0.09 * soot)
    canvas.shade(_ROUGH * fractal(rng.spawn(1)[0], canvas.shape, canvas.cells(0.25), 4, 0.8))
    for x in np.arange(-(first_m % LAMP_EVERY_M) + LAMP_EVERY_M / 2, length_m, LAMP_EVERY_M):
        for y in lamp_rows_m(width_m):
            canvas.rect(
                x - LAMP_M / 2 - 0.05,
                wall_m + y - 0.16,
                x + LAMP_M / 2 + 0.05,
                wall_m + y + 0.16,
                (60, 62, 62),
            )
            canvas.rect(x - LAMP_M / 2, wall_m + y - 0.1, x + LAMP_M / 2, wall_m + y + 0.1, (255, 252, 236))
    return canvas.image()


def lamp_rows_m(width_m: float) -> tuple[float, float]:
    """How far from the ceiling's left edge each row of lamps hangs."""
    return 0.25 * width_m, 0.75 * width_m


def _wall(
    canvas: Canvas, low: float, up: float, wall_m: float, first_m: float, rng: np.random.Generator
) -> None:
    """Dull tiles up to shoulder height, a stripe, concrete above; an exit sign now and then."""
    length = canvas.shape[1] * canvas.texel_m[0]
    start = int(first_m / PANEL_M)
    for k, x in enumerate(np.arange(-(first_m % PANEL_M), length, PANEL_M)):
        tone = rng.uniform(0.9, 1.04)
        _band(canvas, low, up, (0.0, 2.3), x, x + PANEL_M, np.array([186.0, 184.0, 168.0]) * tone)
        _band(
            canvas,
            low,
            up,
            (2.3, wall_m),
            x,
            x + PANEL_M,
            np.array([132.0, 130.0, 124.0]) * rng.uniform(0.94, 1.04),
        )
        for z in (0.75, 1.5, 2.3):
            _band(canvas, low, up, (z - 0.015, z + 0.015), x, x + PANEL_M, (110, 108, 100))
        _band(canvas, low, up, (0.0, wall_m), x, x + 0.035, (64, 63, 60))
        if (start + k) % 6 == 3:
            _paste(canvas, _exit_sign(25 * (start + k) + 40), x + 0.7, low + up * 1.8, up)
    _band(canvas, low, up, (2.32, 2.42), 0.0, length, (176, 148, 40))
    dirt = np.clip(rng.normal(0.6, 0.15), 0.3, 0.8)
    for z in (0.5, 0.25, 0.12):
        _band(canvas, low, up, (0.0, z), 0.0, length, (70, 67, 60), 0.45 * dirt)


def _exit_sign(distance_m: int) -> Array:
    """Pixels of a green sign with the way to the next exit, upright."""
    sign = Canvas(1.0, 0.5, _TEXEL_M, (24, 120, 74))
    sign.rect(0.1, 0.1, 0.35, 0.4, (236, 240, 236))
    sign.text(str(distance_m), 0.42, 0.34, 0.18, (236, 240, 236))
    return sign.pixels


def _paste(canvas: Canvas, pixels: Array, x_m: float, middle_m: float, up: float) -> None:
    """Put a picture on a wall; the left one is painted upside down, the right one is seen in a mirror."""
    turned = pixels[::-1] if up > 0 else pixels[:, ::-1]
    row = round(middle_m / canvas.texel_m[1]) - len(pixels) // 2
    column = max(0, round(x_m / canvas.texel_m[0]))
    area = canvas.pixels[row : row + len(pixels), column : column + pixels.shape[1]]
    area[:] = turned[:, : area.shape[1]]


def _band(
    canvas: Canvas,
    low: float,
    up: float,
    z: tuple[float, float],
    x0: float,
    x1: float,
    color: object,
    alpha: float = 1.0,
) -> None:
    """A rectangle between two heights of a wall that begins at ``low`` and rises along ``up`` times y."""
    a, b = sorted((low + up * z[0], low + up * z[1]))
    canvas.rect(x0, a, x1, b, np.asarray(color, float), alpha)


def _stains(canvas: Canvas, length: float, wall: float, width: float, rng: np.random.Generator) -> None:
    """Seeping water, patched concrete, cracks, an occasional tag."""
    for _ in range(round(0.5 * length)):
        x, y = rng.uniform(0, length), wall + rng.uniform(0, width)
        w, h, tone = rng.uniform(0.2, 1.6), rng.uniform(0.1, 0.8), rng.uniform(84, 160)
        canvas.rect(x, y, x + w, y + h, (tone, tone, 0.95 * tone), 0.5)
    for _ in range(round(0.35 * length)):
        start = np.array([rng.uniform(0, length), wall + rng.uniform(0, width)])
        canvas.stroke(
            crooked_line(rng, start, rng.uniform(0, 6.3), rng.uniform(0.6, 3.0), 0.4), 0.03, (70, 68, 64), 0.8
        )
    for _ in range(rng.poisson(length / 14.0)):
        x, side = rng.uniform(0, length), rng.random() < 0.5
        y = rng.uniform(0.7, 1.9)
        at = np.array([x, y if side else 2 * wall + width - y])
        canvas.stroke(scrawl(rng, rng.uniform(0.8, 2.0), 0.5) + at, 0.05, rng.uniform(20, 200, 3), 0.85)


def paint_portal(width_m: float, height_m: float, clear_m: float, rng: np.random.Generator) -> RgbImage:
    """The wall over an opening and beside it: concrete cast board by board, and a sign with the clearance."""
    canvas = Canvas(width_m, height_m, (0.02, 0.02), (146, 143, 135))
    for y in np.arange(0, height_m, 0.6):
        for x in np.arange(-rng.uniform(0, 2.4), width_m, 2.4):
            canvas.rect(x, y, x + 2.4, y + 0.6, np.array([146.0, 143.0, 135.0]) * rng.uniform(0.9, 1.08))
            canvas.rect(x, y, x + 0.025, y + 0.6, (92, 90, 86))
            canvas.ellipse((x + 0.6, y + 0.3), (0.03, 0.03), (60, 58, 56))
        canvas.rect(0, y, width_m, y + 0.02, (96, 94, 90))
    streaks = fractal(rng, canvas.shape, (canvas.cells(2.5)[0], canvas.cells(0.2)[1]), 4, 0.7)
    canvas.shade(0.12 * streaks - 0.06)
    canvas.rect(0, 0, width_m, 0.3, (98, 96, 92))
    middle = width_m / 2
    canvas.ellipse((middle - 2.2, height_m - 1.1), (0.46, 0.46), (196, 26, 26))
    canvas.ellipse((middle - 2.2, height_m - 1.1), (0.36, 0.36), (240, 240, 236))
    canvas.text(f"{clear_m:.1f}m", middle - 2.5, height_m - 1.02, 0.2, (20, 20, 20))
    for x in np.arange(middle - 4.5, middle + 4.5, 0.6):
        canvas.fill(
            np.array(
                [[x, height_m], [x + 0.3, height_m], [x + 0.55, height_m - 0.3], [x + 0.25, height_m - 0.3]]
            ),
            (196, 160, 30),
        )
    return canvas.image()
