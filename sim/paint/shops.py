"""Painters for shops: display windows, doors, fronts, name boards, awnings; and for glass wherever it is.

Panels come with z counted downwards from the eaves, as the canvas does.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sim.paint.canvas import Canvas
from sim.paint.paving import lay_setts
from sim.shapes.facade import Facade, Panel

Painter = Callable[[Canvas, Facade, Panel, np.random.Generator], None]
SHOP_NAMES = (
    "BAKERY", "CAFE LUNA", "OPTIK", "BOOKS", "PHARMACY", "SALON", "FAHRRAD", "BISTRO", "FLOWERS", "KIOSK",
    "TABAK", "PIZZERIA", "SHOES", "ATELIER", "HOTEL", "MARKT", "COPYSHOP", "MUSIK", "BAR 12", "SCHMIDT",
    "WEINGUT", "GALERIE", "SCHUHHAUS", "REISEN", "KUECHEN", "LEDER WOLF", "FOTO ERB", "JUWELIER", "TEESTUBE",
    "SPORT 2000", "BLUMEN IDA", "ZOO EICK", "ANTIK", "IMBISS", "NAILS", "BARBER", "HANDY FIX", "MODE LIV",
    "METZGEREI", "KONDITOR", "HOERGERAETE", "LOTTO", "NAEHEN", "COMIX", "VINYL", "RADIO KURZ", "BETTEN",
    "SUSHI KO", "TAPAS", "BUEROBEDARF", "UHREN", "EIS VENEZIA", "GYROS", "BANK", "POST", "YOGA", "TATTOO",
)  # fmt: skip


def paint_glass(canvas: Canvas, p: Panel, rng: np.random.Generator) -> None:
    """Dark rooms behind, a patch of mirrored sky, curtains or blinds."""
    tone = rng.uniform(34, 84)
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (tone, tone * 1.05, tone * 1.12))
    w, h = p.x1 - p.x0, p.z1 - p.z0
    slant = np.array([[0.0, 0.0], [0.75, 0.0], [0.2, 1.0], [0.0, 1.0]]) * [w, h * rng.uniform(0.3, 0.8)]
    canvas.fill(slant + np.array([p.x0, p.z0]), (150, 164, 178), rng.uniform(0.15, 0.5))
    kind = rng.random()
    if kind < 0.4:
        for left, right in ((0.0, rng.uniform(0.15, 0.4)), (rng.uniform(0.6, 0.85), 1.0)):
            canvas.rect(p.x0 + left * w, p.z0, p.x0 + right * w, p.z1, (206, 200, 188), 0.75)
            for fold in np.arange(left, right, 0.09):
                canvas.rect(p.x0 + fold * w, p.z0, p.x0 + (fold + 0.03) * w, p.z1, (120, 114, 104), 0.6)
    elif kind < 0.6:
        down = rng.uniform(0.2, 0.9) * h
        for y in np.arange(0, down, 0.07):
            canvas.rect(p.x0, p.z0 + y, p.x1, p.z0 + y + 0.045, (186, 184, 176), 0.85)


def _display(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    """A shop window: shelves with goods, stickers, a mirrored street."""
    canvas.rect(p.x0, p.z0, p.x1, p.z1, (58, 58, 60))
    for shelf in np.arange(p.z0 + 0.55, p.z1 - 0.05, rng.uniform(0.4, 0.6)):
        canvas.rect(p.x0, shelf, p.x1, shelf + 0.03, (150, 140, 120))
        x = p.x0 + 0.1
        while x < p.x1 - 0.15:
            w, h = rng.uniform(0.08, 0.26), rng.uniform(0.1, 0.38)
            canvas.rect(x, shelf - h, min(x + w, p.x1), shelf, rng.uniform(60, 150, 3))
            canvas.rect(
                x + 0.02, shelf - h * 0.6, min(x + w - 0.02, p.x1), shelf - h * 0.35, rng.uniform(85, 175, 3)
            )
            x += w + rng.uniform(0.03, 0.2)
    w, h = p.x1 - p.x0, p.z1 - p.z0
    canvas.fill(np.array([[0, 0], [0.5, 0], [0.1, 1], [0, 1]]) * [w, h] + [p.x0, p.z0], (160, 172, 184), 0.3)
    if rng.random() < 0.5:
        canvas.text(
            str(rng.choice(["SALE", "OPEN", "-30%", "NEU"])), p.x0 + 0.15, p.z0 + 0.4, 0.2, (236, 232, 220)
        )
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.06, np.array(facade.accent_color) * 0.6)


def _shopdoor(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    paint_glass(canvas, p, rng)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.09, facade.accent_color)
    canvas.rect(p.x0, p.z1 - 0.5, p.x1, p.z1, facade.accent_color)
    canvas.rect(p.x0 + 0.25, p.z0 + 0.75, p.x0 + 0.6, p.z0 + 1.0, (232, 230, 220))


def _shopfront(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    tone = np.array(facade.accent_color) * rng.uniform(0.8, 1.4)
    canvas.rect(p.x0, p.z0, p.x1, p.z1, tone, 0.9)
    lay_setts(canvas, p.x0, p.z1 - 0.5, p.x1, p.z1, (0.4, 0.25), float(rng.uniform(70, 150)), rng)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.08, tone * 0.6)


def _sign(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    dark = rng.random() < 0.5
    ground = np.array(facade.accent_color) if dark else np.array([226, 222, 208])
    ink = np.array([240, 236, 220]) if dark else np.array(facade.accent_color) * 0.8
    canvas.rect(p.x0, p.z0, p.x1, p.z1, ground)
    canvas.frame(p.x0, p.z0, p.x1, p.z1, 0.03, ink)
    name = facade.shop_name or str(rng.choice(SHOP_NAMES))
    height = min(0.34, (p.x1 - p.x0 - 0.4) / (0.95 * len(name)))
    start = p.x0 + 0.2 + rng.uniform(0, 1) * max(0.0, p.x1 - p.x0 - 0.4 - 0.9 * height * len(name))
    canvas.text(name, start, (p.z0 + p.z1) / 2 + height / 2, height, ink)


def _awning(canvas: Canvas, facade: Facade, p: Panel, rng: np.random.Generator) -> None:
    width = rng.uniform(0.18, 0.3)
    for k, x in enumerate(np.arange(p.x0, p.x1, width)):
        color = (228, 222, 206) if k % 2 else facade.accent_color
        canvas.rect(x, p.z0, min(x + width, p.x1), p.z1, color)


SHOP_PAINTERS: dict[str, Painter] = {
    "display": _display,
    "shopdoor": _shopdoor,
    "shopfront": _shopfront,
    "sign": _sign,
    "awning": _awning,
}
