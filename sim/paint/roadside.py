"""What lines a motorway: the steel of guard rails, the panels of noise walls, the boards of gantries."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal, scrawl
from sim.paint.plants import leaves_color

RAIL_M = 24.0  # length of the painted piece of guard rail
BAY_M = 4.0  # between the posts of rails and walls
BOARD_M = (3.4, 2.6)
_TEXEL_M = (0.025, 0.02)
# Lobes of an ivy leaf from its stalk to its tip: along it, across it.
_IVY_LEAF = np.column_stack(
    [
        (-0.5, -0.7, 0.0, 0.1, 0.4, 1.1, 0.4, 0.1, 0.0, -0.7),
        (0.0, 0.7, 0.45, 1.0, 0.4, 0.0, -0.4, -1.0, -0.45, -0.7),
    ]
)
DESTINATIONS = (
    "HAFEN", "ZENTRUM", "NORDSTADT", "FLUGHAFEN", "MESSE", "ALTENAU", "SEEBURG", "WEST", "BERGHEIM",
    "RINGEN", "MARIENTAL", "OSTTOR", "STEINACH", "NEUMARKT",
)  # fmt: skip


def paint_rail(rng: np.random.Generator) -> RgbImage:
    """Galvanised steel: overlaps at every post, dents, rust, dirt; y from the upper to the lower edge."""
    canvas = Canvas(RAIL_M, 0.6, _TEXEL_M, (158, 162, 164))
    canvas.shade(0.05 * fractal(rng, canvas.shape, canvas.cells(1.5), 4, 0.6))
    for y, tone in ((0.0, 196), (0.16, 120), (0.3, 186), (0.44, 112)):
        canvas.rect(0, y, RAIL_M, y + 0.07, (tone, tone, tone), 0.55)
    for x in np.arange(0, RAIL_M, BAY_M):
        canvas.rect(x, 0, x + 0.05, 0.6, (88, 90, 92))
        for dx, y in ((0.1, 0.12), (0.1, 0.42), (0.24, 0.12), (0.24, 0.42)):
            canvas.ellipse((x + dx, y), (0.025, 0.025), (70, 70, 70))
        if rng.random() < 0.5:
            canvas.rect(
                x + 0.3, 0.2, x + 0.42, 0.36, (236, 120, 40) if rng.random() < 0.5 else (236, 236, 230)
            )
    for _ in range(26):
        at, size = (rng.uniform(0, RAIL_M), rng.uniform(0, 0.6)), rng.uniform(0.02, 0.16, 2)
        canvas.ellipse(at, size * [1.8, 0.6], rng.choice([[120, 82, 56], [96, 92, 86], [200, 202, 204]]), 0.6)
    return canvas.image()


def paint_noise_wall(length_m: float, height_m: float, kind: int, rng: np.random.Generator) -> RgbImage:
    """Panels between posts: timber, ribbed concrete or plain metal, with ivy and tags; y downwards."""
    base = ((126, 104, 78), (152, 148, 138), (112, 128, 122))[kind]
    canvas = Canvas(length_m, height_m, (0.03, 0.03), base)
    step = (0.16, 0.12, 0.5)[kind]
    for y in np.arange(0, height_m, step):
        canvas.rect(0, y, length_m, y + step, np.array(base) * rng.uniform(0.86, 1.12))
        canvas.rect(0, y, length_m, y + 0.03, np.array(base) * 0.6)
    streaks = fractal(rng, canvas.shape, (canvas.cells(2.0)[0], canvas.cells(0.3)[1]), 4, 0.7)
    canvas.shade(0.1 * streaks + 0.06 * fractal(rng, canvas.shape, canvas.cells(3.0), 3, 0.5))
    for x in np.arange(0, length_m, BAY_M):
        canvas.rect(x, 0, x + BAY_M, height_m, np.array(base) * rng.uniform(0.5, 1.4), 0.16)
        canvas.rect(x - 0.09, 0, x + 0.09, height_m, (96, 98, 98))
        canvas.rect(x - 0.03, 0, x + 0.03, height_m, (150, 152, 152))
        if rng.random() < 0.22:
            _tag(canvas, x + rng.uniform(0.3, 1.5), height_m - rng.uniform(0.8, 1.8), rng)
    for _ in range(rng.poisson(length_m / 9.0)):
        _ivy(canvas, rng.uniform(0, length_m), height_m, rng)
    return canvas.image()


def paint_marker(rng: np.random.Generator) -> RgbImage:
    """The face of a marker post: white, a slanting black band with its reflector, splashed below."""
    canvas = Canvas(0.12, 1.2, (0.01, 0.01), (232, 232, 226))
    canvas.fill(np.array([[0.0, 0.16], [0.12, 0.1], [0.12, 0.34], [0.0, 0.4]]), (26, 26, 28))
    canvas.rect(0.035, 0.17, 0.085, 0.33, (214, 206, 190))
    dirt = np.linspace(0.0, 1.0, canvas.shape[0])[:, None] ** 3 * np.ones(canvas.shape)
    canvas.shade(-0.45 * dirt + 0.03 * fractal(rng, canvas.shape, canvas.cells(0.2), 2, 0.7))
    return canvas.image()


def _tag(canvas: Canvas, x: float, y: float, rng: np.random.Generator) -> None:
    line = scrawl(rng, rng.uniform(0.9, 2.2), 0.6) + np.array([x, y])
    canvas.stroke(line, 0.08, rng.uniform(20, 200, 3), 0.9)


def _ivy(canvas: Canvas, x: float, height_m: float, rng: np.random.Generator) -> None:
    reach = rng.uniform(0.8, height_m)
    turns = rng.spawn(1)[0]
    for _ in range(round(160 * reach)):
        up = rng.uniform(0, 1) ** 1.3
        at = (x + rng.normal(0, 0.7 * (1.1 - 0.6 * up)), height_m - reach * up)
        color = np.array(leaves_color("hornbeam")) * rng.uniform(0.5, 1.2)
        width, length = rng.uniform(0.03, 0.08, 2)
        hanging = np.pi / 2 + turns.normal(0, 0.5)
        ahead = np.array([np.cos(hanging), np.sin(hanging)])
        canvas.fill(at + _IVY_LEAF @ [1.6 * length * ahead, 1.3 * width * ahead[::-1] * [-1, 1]], color)


def paint_boards(routes: Sequence[tuple[str, str, int]]) -> RgbImage:
    """Boards of a gantry side by side: two destinations, a road number, an arrow to the lane below."""
    canvas = Canvas(BOARD_M[0] * len(routes), BOARD_M[1], (0.02, 0.02), (24, 70, 160))
    ink = (240, 240, 236)
    for k, (first, second, number) in enumerate(routes):
        x = k * BOARD_M[0]
        canvas.frame(x + 0.04, 0.04, x + BOARD_M[0] - 0.04, BOARD_M[1] - 0.04, 0.05, ink)
        canvas.rect(x + 0.25, 0.22, x + 1.15, 0.62, ink)
        canvas.text(f"A {number}", x + 0.32, 0.55, 0.26, (24, 70, 160))
        for row, name in enumerate((first, second)):
            size = min(0.36, (BOARD_M[0] - 0.5) / (0.95 * len(name)))
            canvas.text(name, x + 0.25, 1.16 + 0.55 * row, size, ink)
        middle = x + BOARD_M[0] / 2
        canvas.rect(middle - 0.07, 1.9, middle + 0.07, 2.25, ink)
        canvas.fill(np.array([[middle - 0.25, 2.2], [middle + 0.25, 2.2], [middle, 2.5]]), ink)
    return canvas.image()
