"""The paint of a parked car: its side, its front and rear, and its top, side by side in one small texture."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.car_ends import paint_end, trim_front, trim_rear
from sim.paint.car_layout import (
    BLACK_AT_M,
    FRONT_AT_M,
    REAR_AT_M,
    SIDE_AT_M,
    SIZE_M,
    TALL_M,
    TOP_AT_M,
    WHEEL_M,
    WIDE_M,
)
from sim.paint.car_wheel import paint_wheel
from sim.paint.noise import fractal

_TEXEL_M = 0.012
COLORS = (
    (172, 174, 178),
    (38, 40, 46),
    (150, 28, 30),
    (40, 66, 122),
    (226, 226, 222),
    (92, 104, 96),
    (176, 160, 130),
    (120, 124, 130),
    (62, 84, 70),
    (204, 206, 208),
    (96, 40, 44),
    (70, 98, 140),
)
_GLASS, _INSIDE = (34, 40, 46), (17, 19, 21)
_DOORS = (
    (0.02, 0.36, 0.7),
    (0.05, 0.5),
    (0.0, 0.3, 0.62, 0.9),
    (0.1, 0.42, 0.74),
)  # pillars along the windows


def paint_car(
    profile_m: Array, belt_m: float, axles_m: tuple[float, float], rng: np.random.Generator
) -> RgbImage:
    """Paint one car.

    Args:
        profile_m: (K, 2) of x from the tail and height of the upper outline, tail to nose.
        belt_m: Height at which the windows begin.
        axles_m: x of rear and front axle.
        rng: Source of randomness.
    """
    color = np.array(COLORS[rng.integers(len(COLORS))]) * rng.uniform(0.85, 1.08) + rng.uniform(-8, 8, 3)
    canvas = Canvas(*SIZE_M, (_TEXEL_M, _TEXEL_M), color)
    length = float(profile_m[-1, 0])
    _side(canvas, profile_m, belt_m, axles_m, color, rng)
    _top(canvas, profile_m, belt_m, color)
    trim = rng.spawn(1)[0]
    paint_end(canvas, FRONT_AT_M, (240, 240, 230), color, (0.1, 0.14, 0.2), rng)
    paint_end(canvas, REAR_AT_M, (176, 22, 20), color, (0.1, 0.14, 0.42), rng)
    trim_front(canvas, FRONT_AT_M, color, trim)
    trim_rear(canvas, REAR_AT_M, belt_m, float(profile_m[:, 1].max()), color, trim)
    paint_wheel(canvas, rng)
    canvas.shade(0.05 * fractal(rng, canvas.shape, canvas.cells(0.8), 5, 0.7))
    dust = np.clip(fractal(rng, canvas.shape, canvas.cells(0.2), 4, 0.8) - 1.6, 0, 1)
    canvas.pixels += (
        (dust * min(1.0, length / 4.0))[..., None] * (np.array([120.0, 112.0, 98.0]) - canvas.pixels) * 0.4
    )
    x, y = BLACK_AT_M
    canvas.rect(x, y, x + 0.7, y + 1.1, (20, 20, 21))
    return canvas.image()


def _side(
    canvas: Canvas,
    profile: Array,
    belt: float,
    axles: tuple[float, float],
    color: Array,
    rng: np.random.Generator,
) -> None:
    x0, y0 = SIDE_AT_M
    ground = y0 + TALL_M
    above = profile[profile[:, 1] > belt + 0.05]
    roof = np.array([[x0 + x, ground - z + 0.07] for x, z in above])
    ends = np.array([[roof[-1, 0] + 0.25, ground - belt], [roof[0, 0] - 0.2, ground - belt]])
    canvas.fill(np.vstack([roof, ends]), _GLASS)
    for share in (0.3, 0.62):
        seat = roof[0, 0] + share * (roof[-1, 0] - roof[0, 0])
        canvas.ellipse((seat, ground - belt - 0.13), (0.1, 0.13), _INSIDE)
        canvas.rect(seat - 0.16, ground - belt - 0.1, seat + 0.08, ground - belt, _INSIDE)
    sky = np.vstack([roof, roof[::-1] + np.array([0.0, 0.16])])
    canvas.fill(sky, (150, 164, 176), 0.45)
    low, high = roof[0, 0], roof[-1, 0]
    sill, pillar = rng.uniform(0.3, 0.42), rng.uniform(0.05, 0.12)
    handle_z, handle = rng.uniform(0.1, 0.2), rng.uniform(0.14, 0.24)
    for share in _DOORS[rng.integers(len(_DOORS))]:
        x = low + (share + rng.uniform(-0.03, 0.03)) * (high - low)
        canvas.rect(x, ground - belt - 0.6, x + pillar, ground - belt, color * 0.35)
        canvas.rect(x + 0.02, ground - belt, x + 0.035, ground - 0.3, (20, 20, 22))
        canvas.rect(
            x + 0.12,
            ground - belt + handle_z,
            x + 0.12 + handle,
            ground - belt + handle_z + 0.04,
            color * 0.4,
        )
    canvas.rect(x0, ground - sill, x0 + profile[-1, 0], ground, (26, 26, 28))
    if rng.random() < 0.6:
        strip = rng.uniform(0.5, 0.68)
        canvas.rect(
            x0, ground - strip, x0 + profile[-1, 0], ground - strip + 0.035, color * rng.choice([0.5, 1.3])
        )
    canvas.rect(
        x0,
        ground - belt - 0.01,
        x0 + profile[-1, 0],
        ground - belt + 0.03,
        np.minimum(color * 1.35, 255),
        0.8,
    )
    for axle in axles:
        canvas.ellipse((x0 + axle, ground - WHEEL_M), (WHEEL_M + 0.07, WHEEL_M + 0.07), (14, 14, 15))
    canvas.rect(x0, ground - belt + 0.08, x0 + 0.22, ground - belt + 0.24, (168, 24, 22))
    canvas.rect(
        x0 + profile[-1, 0] - 0.35, ground - 0.78, x0 + profile[-1, 0], ground - 0.62, (236, 236, 228)
    )


def _top(canvas: Canvas, profile: Array, belt: float, color: Array) -> None:
    x0, y0 = TOP_AT_M
    above = profile[profile[:, 1] > belt + 0.05]
    first, last = above[0, 0], above[-1, 0]
    peak = profile[profile[:, 1] > profile[:, 1].max() - 0.1]
    for a, b in ((first - 0.3, peak[0, 0] - 0.03), (peak[-1, 0] + 0.03, last + 0.45)):
        canvas.rect(x0 + a, y0 + 0.16, x0 + b, y0 + WIDE_M - 0.16, _GLASS)
        for across in (0.34, 0.66):
            canvas.ellipse((x0 + (a + b) / 2, y0 + across * WIDE_M), (0.3 * (b - a), 0.17), _INSIDE)
        canvas.fill(
            np.array([[a, 0.3], [b, 0.5], [b, 0.9], [a, 0.7]]) + np.array([x0, y0]), (170, 182, 190), 0.4
        )
    canvas.rect(x0 + last + 0.5, y0 + 0.25, x0 + profile[-1, 0], y0 + 0.27, color * 0.4)
    canvas.rect(x0 + last + 0.5, y0 + WIDE_M - 0.27, x0 + profile[-1, 0], y0 + WIDE_M - 0.25, color * 0.4)
