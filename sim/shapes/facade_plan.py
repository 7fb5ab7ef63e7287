"""Drawing whole houses by rules: old town fronts, each its own, and the plain ones of a bare suburb."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from sim.shapes.facade import FLANK_M, Facade, Panel, Rgb, Roof
from sim.shapes.facade_parts import Rhythm, bands, draw_rhythm, house_floor, shop_floor, upper_floors, window

WALL_COLORS: tuple[Rgb, ...] = (
    (212, 204, 184), (198, 176, 138), (218, 214, 204), (176, 132, 104), (128, 136, 134),
    (222, 196, 150), (118, 84, 70), (220, 210, 182), (150, 164, 150), (210, 168, 140), (214, 210, 198),
)  # fmt: skip
BRICK_COLORS: tuple[Rgb, ...] = (
    (152, 84, 62), (168, 108, 76), (122, 72, 60), (178, 148, 110), (134, 100, 84),
)  # fmt: skip
TRIM_COLORS: tuple[Rgb, ...] = (
    (232, 228, 216), (204, 196, 176), (120, 112, 100), (92, 74, 60), (226, 220, 204),
)  # fmt: skip
ACCENT_COLORS: tuple[Rgb, ...] = (
    (44, 74, 58), (112, 40, 36), (38, 54, 92), (84, 60, 40), (60, 60, 62), (150, 110, 40),
)  # fmt: skip
RENDER_COLORS: tuple[Rgb, ...] = ((222, 220, 214), (214, 210, 200), (204, 204, 202), (226, 218, 204))
OLD_TOWN, CANYON = (0, 0, 1, 1, 1, 1, 2), (4, 5)


def draw_facade(
    width_m: float,
    rng: np.random.Generator,
    shops: bool = True,
    corner: bool = False,
    floors: tuple[int, ...] = OLD_TOWN,
) -> Facade:
    """Draw a house that fills a lot of the given width.

    Args:
        width_m: Of its front.
        rng: Source of randomness.
        shops: Whether the ground floor may be a shop.
        corner: Whether its side faces a street and has windows.
        floors: Choices for the number of upper floors.
    """
    rhythm = draw_rhythm(width_m, floors, rng)
    wall = str(rng.choice(["brick", "brick", "plaster", "plaster", "ashlar", "boards"]))
    colors = BRICK_COLORS if wall == "brick" else WALL_COLORS
    panels = [*bands(width_m, rhythm, rng), *upper_floors(width_m, rhythm, rng)]
    shop = shops and width_m > 4.5 and bool(rng.random() < 0.5)
    panels += shop_floor(width_m, rhythm, rng) if shop else house_floor(width_m, rhythm, rng)
    pipe = float(rng.choice([0.08, width_m - 0.2]))
    panels.append(Panel(pipe, pipe + 0.11, 0.05, rhythm.height_m - 0.4, 0.1, "pipe"))
    return Facade(
        width_m,
        rhythm.height_m,
        wall,
        colors[rng.integers(len(colors))],
        TRIM_COLORS[rng.integers(len(TRIM_COLORS))],
        ACCENT_COLORS[rng.integers(len(ACCENT_COLORS))],
        int(rng.integers(1, 4)),
        tuple(panels),
        _flanks(rhythm, corner, rng),
        _draw_roof(width_m, corner, rng),
    )


def draw_plain_house(
    width_m: float, rng: np.random.Generator, corner: bool = False, floors: tuple[int, ...] = (0, 1)
) -> Facade:
    """Draw a rendered house with few openings: hardly anything for a tracker to hold on to."""
    rhythm = replace(
        draw_rhythm(width_m, floors, rng),
        bays=max(1, round(width_m / 3.6)),
        surround_m=0.0,
        shutters=False,
        balcony_bay=-1,
        window_w_m=float(rng.uniform(1.0, 1.5)),
        window_h_m=float(rng.uniform(1.0, 1.3)),
    )
    panels = [panel for panel in upper_floors(width_m, rhythm, rng) if panel.kind in ("window", "sill")]
    floor = house_floor(width_m, rhythm, rng)
    panels += [panel for panel in floor if panel.kind not in ("vent", "trim")]
    return Facade(
        width_m,
        rhythm.height_m,
        "render",
        RENDER_COLORS[rng.integers(len(RENDER_COLORS))],
        TRIM_COLORS[rng.integers(2)],
        ACCENT_COLORS[rng.integers(len(ACCENT_COLORS))],
        0,
        tuple(panels),
        _flanks(rhythm, corner, rng),
        _draw_roof(width_m, corner, rng),
    )


def _flanks(rhythm: Rhythm, corner: bool, rng: np.random.Generator) -> tuple[tuple[Panel, ...], ...]:
    """Side walls face neighbours and are bare, but at a corner each has windows of its own on every floor."""
    if not corner:
        return ((),)
    return tuple(tuple(_flank(rhythm, stream)) for stream in rng.spawn(3))


def _flank(rhythm: Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Two columns of windows with gaps where stairs or a bathroom are, and perhaps a downpipe."""
    panels = [Panel(0, FLANK_M, rhythm.height_m - 0.28, rhythm.height_m, 0.28, "cornice")]
    columns = (float(rng.uniform(0.21, 0.29)) * FLANK_M, float(rng.uniform(0.69, 0.79)) * FLANK_M)
    for floor in range(rhythm.floors + 1):
        sill = 1.05 if floor == 0 else rhythm.ground_m + (floor - 1) * rhythm.floor_m + 0.75
        for middle in columns:
            if rng.random() < 0.88:
                panels += window(middle, sill, rhythm, tall=False)
    if rng.random() < 0.5:
        pipe = float(rng.choice([0.06, FLANK_M - 0.17]))
        panels.append(Panel(pipe, pipe + 0.11, 0.05, rhythm.height_m - 0.4, 0.1, "pipe"))
    return panels


def _draw_roof(width_m: float, corner: bool, rng: np.random.Generator) -> Roof:
    kind = str(rng.choice(["gable", "gable", "gable", "flat"]))
    ridge_m = float(rng.uniform(1.7, 2.9))
    chimneys = tuple(float(share) for share in rng.uniform(0.2, 0.8, int(rng.integers(0, 3))))
    count = int(rng.integers(0, max(1, round(width_m / 3.5)) + 1))
    dormers = tuple((k + 0.5) / count for k in range(count)) if rng.random() < 0.4 else ()
    if kind == "flat":
        return Roof("flat", 0.05)
    return Roof("hip", ridge_m, chimneys[:1]) if corner else Roof("gable", ridge_m, chimneys, dormers)
