"""Parts of a facade as panels: windows, doors, shop floors, bands; drawn by rules within a common rhythm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sim.shapes.facade import Panel


@dataclass(frozen=True)
class Rhythm:
    """Sizes that repeat over a facade.

    Attributes:
        ground_m: Height of the ground floor.
        floor_m: Height of each floor above.
        floors: Number of floors above the ground floor.
        bays: Windows side by side.
        window_w_m, window_h_m: Size of a window.
        surround_m: Width of the frame of stone around it, 0 for none.
        recess_m: How deep windows lie in the wall.
        shutters: Whether windows have them.
        balcony_bay: Bay with balconies; -1 for none.
    """

    ground_m: float
    floor_m: float
    floors: int
    bays: int
    window_w_m: float
    window_h_m: float
    surround_m: float
    recess_m: float
    shutters: bool
    balcony_bay: int

    @property
    def height_m(self) -> float:
        """From the pavement to the eaves."""
        return self.ground_m + self.floors * self.floor_m + 0.5

    def bay_m(self, width_m: float) -> float:
        """Width of a bay on a front of a given width."""
        return (width_m - 0.6) / self.bays


def draw_rhythm(width_m: float, floors: tuple[int, ...], rng: np.random.Generator) -> Rhythm:
    """Draw sizes for a front; ``floors`` lists the choices for the number of upper floors."""
    bays = max(1, round((width_m - 0.6) / rng.uniform(1.7, 2.5)))
    bay = (width_m - 0.6) / bays
    floor_m = float(rng.uniform(2.7, 3.2))
    shutters = bool(rng.random() < 0.3)
    return Rhythm(
        float(rng.uniform(3.1, 3.7)),
        floor_m,
        int(rng.choice(floors)),
        bays,
        min(float(rng.uniform(0.9, 1.3)), bay * (0.42 if shutters else 0.62)),
        min(float(rng.uniform(1.3, 1.9)), floor_m - 1.0),
        float(rng.choice([0.0, 0.1, 0.16])),
        float(rng.uniform(0.1, 0.22)),
        shutters,
        int(rng.integers(bays)) if rng.random() < 0.45 else -1,
    )


def bands(width: float, rhythm: Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Plinth, string courses, corner stones, cornice."""
    height = rhythm.height_m
    found = [Panel(0, width, 0, float(rng.uniform(0.4, 0.9)), 0.06, "plinth")]
    if rng.random() < 0.5:
        for left in (0.0, width - 0.4):
            found.append(Panel(left, left + 0.4, 0, height - 0.4, 0.05, "quoin"))
    if rng.random() < 0.7:
        for floor in range(rhythm.floors):
            z = rhythm.ground_m + floor * rhythm.floor_m
            found.append(Panel(0, width, z - 0.18, z, 0.09, "trim"))
    found.append(Panel(0, width, height - 0.5, height - 0.28, 0.12, "trim"))
    found.append(Panel(0, width, height - 0.28, height, 0.28, "cornice"))
    return found


def upper_floors(width: float, rhythm: Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Rows of windows, balconies, flower boxes."""
    panels: list[Panel] = []
    bay = rhythm.bay_m(width)
    for floor in range(rhythm.floors):
        sill = rhythm.ground_m + floor * rhythm.floor_m + 0.75
        for k in range(rhythm.bays):
            middle = 0.3 + (k + 0.5) * bay
            balcony = k == rhythm.balcony_bay
            panels += window(middle, sill - (0.6 if balcony else 0.0), rhythm, balcony)
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


def window(middle: float, sill: float, rhythm: Rhythm, tall: bool) -> list[Panel]:
    """One window with its surround, shutters and sill."""
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


def house_floor(width: float, rhythm: Rhythm, rng: np.random.Generator) -> list[Panel]:
    """Front door, ground-floor windows, perhaps a garage gate."""
    panels: list[Panel] = []
    bay = rhythm.bay_m(width)
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
            panels += window(middle, 1.05, rhythm, tall=False)
            if rng.random() < 0.4:
                half = rhythm.window_w_m / 2
                panels.append(Panel(middle - half, middle + half, 0.12, 0.42, -0.06, "vent"))
    return panels


def shop_floor(width: float, rhythm: Rhythm, rng: np.random.Generator) -> list[Panel]:
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
