"""Painters for the parts of a facade: windows, doors, railings, trims; one function a kind.

Panels come with z counted downwards from the eaves, as the canvas does.
"""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.paving import lay_setts
from sim.paint.shops import SHOP_PAINTERS, Painter, paint_glass
from sim.shapes.facade import Facade, Panel


def _window(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    paint_glass(canvas, p, rng)
    frame = (204, 202, 196) if sum(facade.trim_color) > 450 else (74, 60, 50)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.07, frame)
    middle = (p.x0 + p.x1) / 2
    canvas.rect(middle - 0.035, p.z0, middle + 0.035, p.z1, frame)
    for k in range(1, facade.muntins + 1):
        y = p.z0 + (p.z1 - p.z0) * k / (facade.muntins + 1)
        canvas.rect(p.x0, y - 0.022, p.x1, y + 0.022, frame)
    canvas.rect(p.x0, p.z0, p.x1, p.z0 + 0.06, (20, 20, 22), 0.5)


def _door(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    color = np.array(facade.accent_color) * rng.uniform(0.7, 1.3)
    canvas.rect(p.x0, p.z0, p.x1, p.z1, color)
    pane = Panel(p.x0 + 0.08, p.x1 - 0.08, p.z0 + 0.06, p.z0 + 0.42, 0.0, "")
    paint_glass(canvas, pane, rng)
    for low, high in ((0.5, 1.2), (1.35, 2.15)):
        for left, right in ((0.1, 0.47), (0.57, 0.94)):
            canvas.rect(p.x0 + left, p.z0 + low, p.x0 + right, p.z0 + high, color * 0.62)
            canvas.frame(
                p.x0 + left, p.z0 + low, p.x0 + right, p.z0 + high, 0.03, np.minimum(color * 1.7, 255)
            )
    canvas.rect(p.x1 - 0.14, p.z0 + 1.2, p.x1 - 0.08, p.z0 + 1.34, (226, 206, 130))


def _gate(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    lay_setts(canvas, p.x0, p.z0, p.x1, p.z1, (0.6, 0.2), float(np.mean(facade.accent_color)) + 60, rng)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.1, facade.trim_color)


def _gateway(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    """The dark of a passage; its lower part gets some light from the street."""
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (24, 23, 23))
    for share in (0.5, 0.3, 0.12):
        canvas.rect(p.x0, p.z1 - share * (p.z1 - p.z0), p.x1, p.z1, (52, 50, 47), 0.3)


def _railing(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (120, 116, 108))
    bar = np.array(facade.accent_color) * 0.5
    for x in np.arange(p.x0, p.x1, rng.uniform(0.11, 0.16)):
        canvas.rect(x, p.z0, x + 0.04, p.z1, bar)
    canvas.rect(p.x0, p.z0, p.x1, p.z0 + 0.07, bar)
    canvas.rect(p.x0, p.z1 - 0.06, p.x1, p.z1, bar)


def _flowers(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (96, 62, 44))
    for _ in range(int(60 * (p.x1 - p.x0))):
        at = (rng.uniform(p.x0, p.x1), p.z0 + abs(rng.normal(0, 0.06)))
        color = (60, 100, 44) if rng.random() < 0.6 else rng.uniform([180, 30, 60], [250, 180, 220])
        canvas.ellipse(at, (0.03, 0.03), color)


def _slats(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    color = np.array(facade.accent_color) * 1.1
    canvas.rect(p.x0, p.z0, p.x1, p.z1, color * 0.55)
    for y in np.arange(p.z0 + 0.06, p.z1 - 0.06, 0.085):
        canvas.rect(p.x0 + 0.05, y, p.x1 - 0.05, y + 0.05, np.minimum(color * rng.uniform(1.1, 1.5), 255))
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.05, color)


def _trim(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    tone = np.array(facade.trim_color) * rng.uniform(0.88, 1.02)
    canvas.rect(p.x0, p.z0, p.x1, p.z1, tone)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.025, tone * 0.6, 0.7)


def _cornice(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    _trim(canvas, facade, p, rng)
    for x in np.arange(p.x0 + 0.1, p.x1 - 0.1, 0.32):
        canvas.rect(x, p.z0 + 0.1, x + 0.16, p.z1, np.array(facade.trim_color) * 0.55)


def _stones(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    tone = float(np.mean(facade.trim_color)) * 0.75
    lay_setts(canvas, p.x0, p.z0, p.x1, p.z1, (0.5, 0.3), tone, rng)


def _pipe(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (88, 92, 90))
    canvas.rect(p.x0 + 0.02, p.z0, p.x0 + 0.05, p.z1, (170, 174, 170))
    for y in np.arange(p.z0, p.z1, 1.8):
        canvas.rect(p.x0, y, p.x1, y + 0.08, (44, 46, 46))


PAINTERS: dict[str, Painter] = {
    "window": _window,
    "door": _door,
    "gate": _gate,
    "gateway": _gateway,
    **SHOP_PAINTERS,
    "railing": _railing,
    "flowers": _flowers,
    "shutter": _slats,
    "vent": _slats,
    "trim": _trim,
    "sill": _trim,
    "slab": _trim,
    "step": _trim,
    "cornice": _cornice,
    "plinth": _stones,
    "quoin": _stones,
    "pipe": _pipe,
}
