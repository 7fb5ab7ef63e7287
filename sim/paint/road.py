"""The road surface as one long unique painting: asphalt with its history, gutters, and worn markings.

Coordinates of a road canvas: x = s - s of the left edge, y = d of the upper edge - d; so seen from above with
the driving direction to the right. Roads keep decimetre-to-metre structure: finer grain fades at a distance.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.paint.blots import blot
from sim.paint.canvas import Canvas
from sim.paint.noise import crooked_line, fractal, grain, smoothstep

# Finer across than along: at a flat angle mipmaps blur along the road anyway, and this keeps it sharp across.
ROAD_TEXEL_M = (0.025, 0.014)
PAINT = (214, 213, 205)
_GRAIN = 0.06  # deviation of a texel's brightness; larger texels even out more stones


@dataclass(frozen=True, eq=False)
class RoadCanvas:
    """A canvas in street coordinates.

    Attributes:
        canvas: The painting.
        start_m: s of its left edge.
        top_m: d of its upper edge.
        worn: (H, W) how much of any paint is left.
    """

    canvas: Canvas
    start_m: float
    top_m: float
    worn: Array

    @property
    def end_m(self) -> float:
        """s of its right edge."""
        return self.start_m + self.canvas.shape[1] * self.canvas.texel_m[0]

    def quad(self, s0: float, d0: float, s1: float, d1: float) -> Array:
        """Canvas polygon of a rectangle in street coordinates."""
        x0, x1, y0, y1 = s0 - self.start_m, s1 - self.start_m, self.top_m - d1, self.top_m - d0
        return np.array([[x0, y0], [x1, y0], [x1, y1], [x0, y1]])

    def mark(self, s0: float, d0: float, s1: float, d1: float) -> None:
        """A painted rectangle, worn."""
        self.canvas.fill(self.quad(s0, d0, s1, d1), PAINT, 0.92, self.worn)

    def at(self, s_m: float, d_m: float) -> Array:
        """Canvas point of street coordinates."""
        return np.array([s_m - self.start_m, self.top_m - d_m])


def asphalt(
    start_m: float,
    end_m: float,
    right_m: float,
    left_m: float,
    rng: np.random.Generator,
    texel_m: tuple[float, float] = ROAD_TEXEL_M,
    wear: float = 1.0,
) -> RoadCanvas:
    """Lay asphalt of several ages between two s and two d, with repairs, cracks, stains and covers.

    Args:
        start_m: s of the left edge.
        end_m: s of the right edge.
        right_m: d of the lower edge.
        left_m: d of the upper edge.
        rng: Source of randomness.
        texel_m: Size of a texel along and across.
        wear: 1 for an old town street, 0 for a plain new surface.
    """
    canvas = Canvas(end_m - start_m, left_m - right_m, texel_m, (98, 97, 96))
    shape = canvas.shape
    worn = smoothstep(-1.5, 0.3, fractal(rng, shape, canvas.cells(0.5), 6, 0.8))
    road = RoadCanvas(canvas, start_m, left_m, 0.25 + 0.75 * worn)
    # Polished stretches between rough ones: a road is not equally busy everywhere.
    rough = 0.014 + 0.056 * smoothstep(-0.3, 1.2, fractal(rng, shape, canvas.cells(2.2), 2))
    canvas.shade(
        (0.03 + 0.05 * wear) * fractal(rng, shape, canvas.cells(3.0), 3)
        + (0.4 + 0.6 * wear) * rough * fractal(rng, shape, canvas.cells(0.45), 4, 0.6)
    )
    area = wear * (end_m - start_m) * (left_m - right_m)
    _lay_repairs(road, area, right_m, left_m, rng)
    _crack(road, area, right_m, left_m, rng)
    _spill(road, area, right_m, left_m, rng)
    _set_covers(road, wear, end_m - start_m, right_m, left_m, rng)
    canvas.shade(_GRAIN * ROAD_TEXEL_M[0] / texel_m[0] * grain(rng.spawn(1)[0], shape))
    return road


def _lay_repairs(
    road: RoadCanvas, area_m2: float, right_m: float, left_m: float, rng: np.random.Generator
) -> None:
    """Patches and trenches: other tone, other grain, a sealed seam around."""
    canvas = road.canvas
    grain = np.clip(0.85 + 0.12 * fractal(rng, canvas.shape, canvas.cells(0.2), 4, 0.9), 0, 1)
    for _ in range(round(area_m2 / 18.0)):
        x, y = rng.uniform(0, canvas.shape[1] * canvas.texel_m[0]), rng.uniform(0, left_m - right_m)
        length, width = rng.choice([(0.8, 0.6), (1.6, 1.1), (2.6, 0.8), (5.5, 0.7), (0.6, 3.4)])
        length, width = length * rng.uniform(0.7, 1.4), width * rng.uniform(0.7, 1.3)
        corners = np.array([[0, 0], [length, 0], [length, width], [0, width]]) + np.array([x, y])
        corners += rng.normal(0, 0.04, (4, 2))
        tone = rng.uniform(66, 124)
        canvas.fill(corners, (tone, tone, tone * 0.98), 0.85, grain)
        canvas.stroke(corners, rng.uniform(0.03, 0.08), (48, 48, 50), 0.7, closed=True)


def _crack(road: RoadCanvas, area_m2: float, right_m: float, left_m: float, rng: np.random.Generator) -> None:
    """Open cracks, and wider bands of bitumen where they were sealed."""
    canvas = road.canvas
    length_m = canvas.shape[1] * canvas.texel_m[0]
    sealing = rng.spawn(1)[0]
    sealed = sealing.uniform(0.05, 0.4)  # some streets are looked after more than others
    for _ in range(round(area_m2 / 9.0)):
        start = np.array([rng.uniform(0, length_m), rng.uniform(0, left_m - right_m)])
        along = rng.random() < 0.5
        heading = rng.normal(0, 0.25) if along else np.pi / 2 + rng.normal(0, 0.3)
        line = crooked_line(rng, start, heading, rng.uniform(0.8, 5.0 if along else 3.0), 0.35)
        if rng.random() < sealed:
            _seal(canvas, line, sealing)
        else:
            canvas.stroke(line, rng.uniform(0.02, 0.05), (36, 35, 34), 0.9)
            canvas.stroke(line + 0.05, 0.05, (150, 148, 142), 0.35)


def _seal(canvas: Canvas, line_m: Array, rng: np.random.Generator) -> None:
    """Pour bitumen along a crack, 3 to 6 cm once blurred by a texel: jagged, uneven, partly worn off."""
    steps = np.arange(len(line_m))
    finer = np.arange(0.0, len(line_m) - 1, 0.25)
    path = np.column_stack([np.interp(finer, steps, line_m[:, k]) for k in (0, 1)])
    path += rng.normal(0.0, 0.012, path.shape)
    for k in range(0, len(path) - 1, 2):
        canvas.stroke(path[k : k + 3], rng.uniform(0.02, 0.045), (34, 34, 37), rng.uniform(0.35, 0.9))


def _spill(road: RoadCanvas, area_m2: float, right_m: float, left_m: float, rng: np.random.Generator) -> None:
    """Oil, gum and dust: soft and hard blots, dark and light."""
    canvas, shapes = road.canvas, rng.spawn(1)[0]
    length_m = canvas.shape[1] * canvas.texel_m[0]
    for _ in range(round(area_m2 / 1.8)):
        at = (rng.uniform(0, length_m), rng.uniform(0, left_m - right_m))
        radius = 0.04 * rng.pareto(2.0) + 0.03
        radii = np.minimum(radius * rng.uniform(0.6, 1.6, 2), 0.6)
        dark = rng.random() < 0.68
        tone = rng.uniform(30, 60) if dark else rng.uniform(140, 185)
        blot(canvas, at, (float(radii[0]), float(radii[1])), float(tone), shapes)


def _set_covers(
    road: RoadCanvas, wear: float, length_m: float, right_m: float, left_m: float, rng: np.random.Generator
) -> None:
    """Manhole covers, valve caps and gully grates."""
    canvas = road.canvas
    if wear < 0.5:
        return  # plain roads have their drains beside them
    for _ in range(round(wear * length_m / 7.0)):
        x, y = rng.uniform(1, length_m - 1), rng.uniform(0.8, left_m - right_m - 0.8)
        if rng.random() < 0.6:
            _cover(canvas, x, y, 0.36)
        else:
            canvas.rect(x - 0.16, y - 0.12, x + 0.16, y + 0.12, (52, 50, 48))
            canvas.frame(x - 0.16, y - 0.12, x + 0.16, y + 0.12, 0.04, (122, 118, 110))


def _cover(canvas: Canvas, x: float, y: float, radius_m: float) -> None:
    canvas.ellipse((x, y), (radius_m + 0.14, radius_m + 0.14), (126, 124, 118), 0.8)
    canvas.ellipse((x, y), (radius_m, radius_m), (46, 44, 43))
    canvas.ellipse((x, y), (radius_m - 0.05, radius_m - 0.05), (96, 93, 88))
    for k in np.arange(-radius_m + 0.1, radius_m, 0.12):
        half = np.sqrt(max(radius_m**2 - k**2, 0.0)) - 0.06
        canvas.rect(x - half, y + k - 0.025, x + half, y + k + 0.025, (52, 50, 49), 0.9)
        canvas.rect(x + k - 0.02, y - half, x + k + 0.02, y + half, (60, 58, 56), 0.6)
