"""Drawing the plan of one facade by rules: floors, bays, windows, doors, shops, balconies."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sim.shapes.facade import Facade, Panel, Rgb

WALL_COLORS: tuple[Rgb, ...] = (
    (212, 204, 184), (198, 176, 138), (218, 214, 204), (176, 132, 104), (128, 136, 134),
    (222, 196, 150), (118, 84, 70), (220, 210, 182), (150, 164, 150), (210, 168, 140), (214, 210, 198),
)  # fmt: skip
BRICK_COLORS: tuple[Rgb, ...] = (
    (152, 84, 62),
    (168, 108, 76),
    (122, 72, 60),
    (178, 148, 110),
    (134, 100, 84),
)
TRIM_COLORS: tuple[Rgb, ...] = (
    (232, 228, 216),
    (204, 196, 176),
    (120, 112, 100),
    (92, 74, 60),
    (226, 220, 204),
)
ACCENT_COLORS: tuple[Rgb, ...] = (
    (44, 74, 58),
    (112, 40, 36),
    (38, 54, 92),
    (84, 60, 40),
    (60, 60, 62),
    (150, 110, 40),
)


@dataclass(frozen=True)
class _Rhythm:
    """Sizes that repeat over the facade."""

    ground_m: float
    floor_m: float
    floors: int
    bays: int
    window_w_m: float
    window_h_m: float
    surround_m: float
    recess_m: float
    shutters: bool
    balcony_bay: int  # -1: none


def draw_facade(width_m: float, rng: np.random.Generator, shops: bool = True, corner: bool = False) -> Facade:
    """Draw a facade that fills a lot of the given width."""
    rhythm = _draw_rhythm(width_m, rng)
    height = rhythm.ground_m + rhythm.floors * rhythm.floor_m + 0.5
    wall = str(rng.choice(["brick", "brick", "plaster", "plaster", "ashlar", "boards"]))
    colors = BRICK_COLORS if wall == "brick" else WALL_COLORS
    panels = [*_bands(width_m, height, rhythm, rng), *_upper_floors(width_m, rhythm, rng)]
    shop = shops and width_m > 4.5 and bool(rng.random() < 0.5)
    panels += _shop_floor(width_m, rhythm, rng) if shop else _house_floor(width_m, rhythm, rng)
    pipe = float(rng.choice([0.08, width_m - 0.2]))
    panels.append(Panel(pipe, pipe + 0.11, 0.05, height - 0.4, 0.1, "pipe"))
    return Facade(
        width_m,
        height,
        wall,
        colors[rng.integers(len(colors))],
        TRIM_COLORS[rng.integers(len(TRIM_COLORS))],
        ACCENT_COLORS[rng.integers(len(ACCENT_COLORS))],
        int(rng.integers(1, 4)),
        corner,
        tuple(panels),
    )


def _draw_rhythm(width_m: float, rng: np.random.Generator) -> _Rhythm:
    bays = max(1, round((width_m - 0.6) / rng.uniform(1.7, 2.5)))
    bay = (width_m - 0.6) / bays
    floor_m = float(rng.uniform(2.7, 3.2))
    shutters = bool(rng.random() < 0.3)
    return _Rhythm(
        float(rng.uniform(3.1, 3.7)),
        floor_m,
        int(rng.choice([0, 1, 1, 1, 1, 2])),
        bays,
        min(float(rng.uniform(0.9, 1.3)), bay * (0.42 if shutters else 0.62)),
        min(float(rng.uniform(1.3, 1.9)), floor_m - 1.0),
        float(rng.choice([0.0, 0.1, 0.16])),
        float(rng.uniform(0.1, 0.22)),
        shutters,
        int(rng.integers(bays)) if rng.random() < 0.45 else -1,
    )


def _bands(width: float, height: float, rhythm: _Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Plinth, string courses, corner stones, cornice."""
    bands = [Panel(0, width, 0, float(rng.uniform(0.4, 0.9)), 0.06, "plinth")]
    if rng.random() < 0.5:
        for left in (0.0, width - 0.4):
            bands.append(Panel(left, left + 0.4, 0, height - 0.4, 0.05, "quoin"))
    if rng.random() < 0.7:
        for floor in range(rhythm.floors):
            z = rhythm.ground_m + floor * rhythm.floor_m
            bands.append(Panel(0, width, z - 0.18, z, 0.09, "trim"))
    bands.append(Panel(0, width, height - 0.5, height - 0.28, 0.12, "trim"))
    bands.append(Panel(0, width, height - 0.28, height, 0.32, "cornice"))
    return bands


def _upper_floors(width: float, rhythm: _Rhythm, rng: np.random.Generator) -> list[Panel]:
    panels: list[Panel] = []
    bay = (width - 0.6) / rhythm.bays
    for floor in range(rhythm.floors):
        sill = rhythm.ground_m + floor * rhythm.floor_m + 0.75
        for k in range(rhythm.bays):
            middle = 0.3 + (k + 0.5) * bay
            balcony = k == rhythm.balcony_bay
            panels += _window(middle, sill - (0.6 if balcony else 0.0), rhythm, balcony)
            if balcony:
                half = min(bay / 2, 1.2)
                floor_z = sill - 0.72
                panels.append(Panel(middle - half, middle + half, floor_z, floor_z + 0.14, 0.85, "slab"))
                panels.append(
                    Panel(middle - half, middle + half, floor_z + 0.14, floor_z + 1.05, 0.8, "railing")
                )
            elif rng.random() < 0.2:
                w = rhythm.window_w_m / 2
                panels.append(Panel(middle - w, middle + w, sill, sill + 0.2, 0.22, "flowers"))
    return panels


def _window(middle: float, sill: float, rhythm: _Rhythm, tall: bool) -> list[Panel]:
    half, top, s = rhythm.window_w_m / 2, sill + rhythm.window_h_m + (0.6 if tall else 0.0), rhythm.surround_m
    panels: list[Panel] = []
    if s:
        panels.append(Panel(middle - half - s, middle + half + s, sill - s, top + s, 0.05, "trim"))
    if rhythm.shutters:
        for left in (middle - half - s - 0.48, middle + half + s):
            panels.append(Panel(left, left + 0.48, sill, top, 0.07, "shutter"))
    panels.append(Panel(middle - half, middle + half, sill, top, -rhythm.recess_m, "window"))
    panels.append(Panel(middle - half - 0.1, middle + half + 0.1, sill - 0.09, sill, 0.13, "sill"))
    return panels


def _house_floor(width: float, rhythm: _Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Front door, ground-floor windows, perhaps a garage gate."""
    panels: list[Panel] = []
    bay = (width - 0.6) / rhythm.bays
    door = int(rng.integers(rhythm.bays))
    gate = rhythm.bays >= 4 and rng.random() < 0.4
    for k in range(rhythm.bays):
        middle = 0.3 + (k + 0.5) * bay
        if k == door:
            panels.append(Panel(middle - 0.72, middle + 0.72, 0, 2.62, 0.07, "trim"))
            panels.append(Panel(middle - 0.52, middle + 0.52, 0.16, 2.45, -0.26, "door"))
            panels.append(Panel(middle - 0.8, middle + 0.8, 0, 0.16, 0.3, "step"))
        elif gate and k == (door + 2) % rhythm.bays:
            half = min(1.3, bay / 2)
            panels.append(Panel(middle - half, middle + half, 0, 2.4, -0.2, "gate"))
        else:
            panels += _window(middle, 1.05, rhythm, tall=False)
            if rng.random() < 0.4:
                half = rhythm.window_w_m / 2
                panels.append(Panel(middle - half, middle + half, 0.12, 0.42, -0.06, "vent"))
    return panels


def _shop_floor(width: float, rhythm: _Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Display windows between piers, a door, a sign board above."""
    top = rhythm.ground_m - 0.75
    panels = [Panel(0.15, width - 0.15, 0.0, top, 0.04, "shopfront")]
    count = max(2, round((width - 0.8) / 1.9))
    bay = (width - 0.8) / count
    door = int(rng.integers(count))
    for k in range(count):
        x0, x1 = 0.4 + k * bay + 0.12, 0.4 + (k + 1) * bay - 0.12
        if k == door:
            middle = (x0 + x1) / 2
            panels.append(Panel(middle - 0.5, middle + 0.5, 0.05, top - 0.15, -0.45, "shopdoor"))
        else:
            panels.append(Panel(x0, x1, 0.55, top - 0.15, -0.18, "display"))
    panels.append(Panel(0.2, width - 0.2, top + 0.05, rhythm.ground_m - 0.12, 0.14, "sign"))
    if rng.random() < 0.45:
        panels.append(Panel(0.3, width - 0.3, top - 0.4, top + 0.04, 1.1, "awning"))
    return panels
