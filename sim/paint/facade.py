"""The painting of a house front: its wall, what hangs on it, and what years of weather did to it."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import crooked_line, fractal, scrawl, smoothstep
from sim.paint.openings import PAINTERS
from sim.paint.paving import lay_setts
from sim.shapes.facade import FLANK_M, Facade, Panel
from sim.shapes.house_mesh import atlas_width_m
from sim.shapes.roof import DORMER_M, DORMER_WIDTH_M, WALL_M

WallPainter = Callable[[Canvas, Facade, np.random.Generator], None]


def paint_facade(facade: Facade, texel_m: float, rng: np.random.Generator) -> RgbImage:
    """Front, flanks and roof of one house as an RGB image; x as in the facade, y down from the eaves."""
    canvas = Canvas(atlas_width_m(facade), facade.height_m, (texel_m, texel_m), facade.wall_color)
    _WALLS[facade.wall](canvas, facade, rng)
    if facade.wall != "render":
        _age(canvas, facade, rng)
    for panel in facade.all_panels:
        _cast_shade(canvas, facade, panel)
        PAINTERS[panel.kind](canvas, facade, _flipped(facade, panel), rng)
    if facade.wall != "render":
        _scribble(canvas, facade, rng)
    for panel in (panel for panel in facade.panels if panel.kind == "gateway"):  # nothing is stuck on air
        PAINTERS[panel.kind](canvas, facade, _flipped(facade, panel), rng)
    _roof(canvas, facade, rng)
    canvas.shade(0.02 * fractal(rng, canvas.shape, canvas.cells(0.3), 2, 0.7))
    return canvas.image()


def paint_render(rng: np.random.Generator) -> RgbImage:
    """Smooth plaster of a garden wall: next to nothing on it."""
    canvas = Canvas(6.0, 2.0, (0.03, 0.03), (208, 205, 198))
    canvas.shade(0.018 * fractal(rng, canvas.shape, canvas.cells(2.0), 3, 0.5))
    return canvas.image()


def _flipped(facade: Facade, panel: Panel) -> Panel:
    """The panel with z counted downwards from the eaves, as the canvas does."""
    return Panel(
        panel.x0, panel.x1, facade.height_m - panel.z1, facade.height_m - panel.z0, panel.depth_m, panel.kind
    )


def _courses(stone_m: tuple[float, float], tone: float) -> WallPainter:
    """Rows of stones, bricks or boards in the wall's colour."""

    def paint(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
        color = np.array(facade.wall_color)
        width = atlas_width_m(facade)
        lay_setts(canvas, 0, 0, width, facade.height_m, stone_m, float(color.mean()) * tone, rng)
        canvas.pixels *= (color / color.mean()).astype(np.float32)

    return paint


def _plaster(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
    canvas.shade(0.03 * fractal(rng, canvas.shape, canvas.cells(0.25), 4, 0.8))
    for _ in range(round((facade.walls_m - FLANK_M) * facade.height_m / 14)):
        x, y = rng.uniform(0, facade.walls_m), facade.height_m - abs(rng.normal(0, 2.0))
        outline = rng.uniform(0.2, 0.7) * (1 + 0.35 * rng.standard_normal((14, 1)))
        angles = np.linspace(0, 2 * np.pi, 14, endpoint=False)
        shape = np.stack([np.cos(angles) * 1.4, np.sin(angles)], 1) * outline + [x, y]
        tone = float(np.mean(facade.wall_color)) * rng.uniform(0.55, 1.15)
        canvas.fill(shape, (tone, tone * 0.94, tone * 0.86), 0.75)


def _render(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
    """Smooth and clean: faint clouds and a darker foot are all that can be seen."""
    canvas.shade(0.02 * fractal(rng, canvas.shape, canvas.cells(2.5), 3, 0.5))
    canvas.rect(0, facade.height_m - 0.3, atlas_width_m(facade), facade.height_m, (118, 116, 112))


_WALLS: dict[str, WallPainter] = {
    "brick": _courses((0.25, 0.085), 1.0),
    "plaster": _plaster,
    "ashlar": _courses((0.62, 0.31), 0.95),
    "boards": _courses((2.6, 0.16), 1.0),
    "render": _render,
}


def _age(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
    """Blotches, rain streaks, splashed and sooty feet, cracks."""
    shape = canvas.shape
    blotches = fractal(rng, shape, canvas.cells(1.6), 4, 0.55)
    streaks = fractal(rng, shape, (canvas.cells(2.5)[0], canvas.cells(0.16)[1]), 3, 0.7)
    height = np.linspace(facade.height_m, 0, shape[0], dtype=np.float32)[:, None]
    foot = smoothstep(0.9, 0.0, height + 0.25 * blotches)
    canvas.shade(0.075 * blotches + 0.06 * streaks * smoothstep(0.0, 1.0, streaks) - 0.3 * foot)
    for _ in range(int(rng.integers(2, 6))):
        start = np.array([rng.uniform(0, facade.walls_m), rng.uniform(0, facade.height_m)])
        line = crooked_line(rng, start, rng.uniform(0.9, 2.2), rng.uniform(0.5, 2.5), 0.5)
        canvas.stroke(line, 0.02, (60, 56, 50), 0.8)


def _cast_shade(canvas: Canvas, facade: Facade, panel: Panel) -> None:
    """The soft dark seam under what stands out, and dirt that the rain leaves there."""
    if panel.depth_m <= 0.03:
        return
    y = facade.height_m - panel.z0
    reach = min(0.1 + 0.5 * panel.depth_m, 0.5)
    for part in (1.0, 0.6, 0.3):
        canvas.rect(panel.x0, y, panel.x1, y + reach * part, (28, 26, 26), 0.2)


def _scribble(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
    """Sprayed tags, posters, a house number: what gathers on walls within reach."""
    for _ in range(rng.poisson((facade.walls_m - FLANK_M) / 6.0)):
        x, y = rng.uniform(0.2, facade.walls_m - 1), facade.height_m - rng.uniform(0.7, 1.9)
        if rng.random() < 0.5:
            line = scrawl(rng, rng.uniform(0.5, 1.4), 0.35) + np.array([x, y])
            canvas.stroke(
                line, 0.04, rng.choice([20.0, 230.0]) * np.array([1.0, rng.uniform(0.3, 1), 0.6]), 0.8
            )
        else:
            w, h = rng.uniform(0.3, 0.6), rng.uniform(0.4, 0.8)
            canvas.rect(x, y, x + w, y + h, rng.uniform(120, 240, 3))
            canvas.rect(x + 0.05, y + 0.05, x + w - 0.05, y + h * 0.55, rng.uniform(20, 200, 3))
            for k in range(3):
                canvas.rect(
                    x + 0.05,
                    y + h * (0.64 + 0.11 * k),
                    x + w * rng.uniform(0.5, 0.9),
                    y + h * (0.69 + 0.11 * k),
                    (40, 40, 44),
                )
    canvas.text(str(rng.integers(1, 99)), rng.uniform(0.3, 0.8), facade.height_m - 2.0, 0.18, (240, 240, 236))


def _roof(canvas: Canvas, facade: Facade, rng: np.random.Generator) -> None:
    """Tiles above, plain wall below them, and the front of a dormer at the foot of the last column."""
    x0, x1, height = facade.walls_m, atlas_width_m(facade), facade.height_m
    eaves = height - DORMER_M - WALL_M
    tone = rng.uniform(62, 108)
    lay_setts(canvas, x0, 0, x1, eaves, (0.26, 0.32), tone, rng)
    red = np.array([1.18, 0.9, 0.76]) if rng.random() < 0.6 else np.array([0.96, 1.0, 1.04])
    column = canvas.pixels[: round(eaves / canvas.texel_m[1]), round(x0 / canvas.texel_m[0]) :]
    moss = fractal(rng, column.shape[:2], canvas.cells(1.1), 4, 0.7)
    column *= (red * (1.0 + 0.1 * moss[..., None])).astype(np.float32)
    front = Panel(
        x0 + 0.25, x0 + DORMER_WIDTH_M - 0.25, height - DORMER_M + 0.3, height - 0.35, 0.0, "window"
    )
    canvas.rect(x0, height - DORMER_M, x0 + DORMER_WIDTH_M, height, facade.trim_color)
    PAINTERS["window"](canvas, facade, front, rng)
