"""What is to be read in a street: traffic signs, traffic lights, plates with the names of streets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas
from sim.paint.furniture_parts import REGIONS_M, SIGN_M

RED, BLUE, WHITE, BLACK, YELLOW = (196, 26, 26), (24, 70, 160), (240, 240, 236), (20, 20, 20), (236, 186, 30)
_HALF = SIGN_M / 2
_LAMPS = {
    "signal_red": ((255, 60, 44), (70, 56, 20), (22, 58, 40)),
    "signal_green": ((70, 24, 22), (70, 56, 20), (90, 255, 180)),
    "signal_walk": ((255, 60, 44), (22, 58, 40)),
}


def paint_signs(canvas: Canvas) -> None:
    """Paint every traffic sign into its place."""
    _round_signs(canvas)
    x, y = _center("crossing")
    canvas.rect(x - _HALF, y - _HALF, x + _HALF, y + _HALF, BLUE)
    canvas.fill(np.array([[x, y - 0.22], [x + 0.23, y + 0.18], [x - 0.23, y + 0.18]]), WHITE)
    canvas.stroke(np.array([[x - 0.02, y - 0.08], [x, y + 0.06], [x + 0.07, y + 0.14]]), 0.05, BLACK)
    canvas.stroke(np.array([[x, y + 0.06], [x - 0.08, y + 0.14]]), 0.05, BLACK)
    x, y = _center("warning")
    canvas.rect(x - _HALF, y - _HALF, x + _HALF, y + _HALF, RED)
    canvas.fill(np.array([[x, y - 0.17], [x + 0.2, y + 0.2], [x - 0.2, y + 0.2]]), WHITE)
    canvas.rect(x - 0.025, y - 0.05, x + 0.025, y + 0.15, BLACK)
    x, y = _center("give_way")
    canvas.rect(x - _HALF, y - _HALF, x + _HALF, y + _HALF, RED)
    canvas.fill(np.array([[x, y + 0.17], [x + 0.2, y - 0.2], [x - 0.2, y - 0.2]]), WHITE)
    x, y = _center("priority")
    for half, color in ((_HALF, WHITE), (0.21, YELLOW)):
        canvas.fill(np.array([[x, y - half], [x + half, y], [x, y + half], [x - half, y]]), color)
    x, y = _center("chevron")
    canvas.rect(x - _HALF, y - _HALF, x + _HALF, y + _HALF, WHITE)
    for k in range(2):
        left = x - _HALF + 0.3 * k
        arrow = np.array([[0.0, 0.0], [0.15, 0.0], [0.28, 0.3], [0.15, 0.6], [0.0, 0.6], [0.13, 0.3]])
        canvas.fill(arrow + np.array([left, y - _HALF]), RED)


def _round_signs(canvas: Canvas) -> None:
    for name, rim, inner in (("limit", RED, WHITE), ("no_parking", RED, BLUE), ("stop", RED, RED)):
        at = _center(name)
        canvas.ellipse(at, (_HALF, _HALF), rim)
        canvas.ellipse(at, (_HALF * 0.76, _HALF * 0.76), inner)
    x, y = _center("limit")
    canvas.text("30", x - 0.17, y + 0.11, 0.22, BLACK)
    x, y = _center("no_parking")
    canvas.stroke(np.array([[x - 0.18, y - 0.18], [x + 0.18, y + 0.18]]), 0.07, RED)
    x, y = _center("stop")
    canvas.text("STOP", x - 0.235, y + 0.07, 0.14, WHITE)
    x, y = _center("no_entry")
    canvas.ellipse((x, y), (_HALF, _HALF), RED)
    canvas.rect(x - 0.21, y - 0.06, x + 0.21, y + 0.06, WHITE)


def paint_signals(canvas: Canvas, glow: int = 0) -> None:
    """Three lamps for cars, two for people on foot, one of them lit.

    Args:
        canvas: Of a coat of furniture.
        glow: If not 0, only the lamps that are lit are painted, at this level.
    """
    lit = {"signal_red": 0, "signal_green": 2, "signal_walk": 0}
    for name, colors in _LAMPS.items():
        x, y, w, h = REGIONS_M[name]
        if not glow:
            canvas.rect(x, y, x + w, y + h, (26, 30, 28))
            canvas.frame(x, y, x + w, y + h, 0.02, (70, 72, 70))
        for k, color in enumerate(colors):
            at = (x + w / 2, y + (k + 0.5) * h / len(colors))
            if not glow:
                canvas.ellipse(at, (0.115, 0.115), (8, 8, 8))
                canvas.ellipse(at, (0.098, 0.098), color)
            elif k == lit[name]:
                canvas.ellipse(at, (0.098, 0.098), (glow, glow, glow))


def paint_plates(canvas: Canvas, names: Sequence[str]) -> None:
    """Write the names of streets on their plates."""
    for k, name in enumerate(names):
        x, y, w, h = REGIONS_M[f"plate_{k}"]
        canvas.rect(x, y, x + w, y + h, (30, 60, 140))
        canvas.frame(x + 0.01, y + 0.01, x + w - 0.01, y + h - 0.01, 0.012, WHITE)
        size = min(0.13, (w - 0.12) / (0.95 * len(name)))
        canvas.text(name, x + 0.06, y + h / 2 + size / 2, size, WHITE)


def _center(name: str) -> Array:
    return np.array(REGIONS_M[name][:2]) + _HALF
