"""The paint of a parked car: its side, its front and rear, and its top, side by side in one small texture."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect

SIZE_M = (8.0, 4.2)  # of the texture
SIDE_AT_M = (0.1, 0.05)  # where parts begin; x runs from tail to nose, y down from 2.2 m above the road
TOP_AT_M = (0.1, 2.3)
FRONT_AT_M, REAR_AT_M, WHEEL_AT_M, BLACK_AT_M = (5.3, 0.05), (5.3, 2.3), (7.25, 0.1), (7.25, 3.0)
TALL_M, WIDE_M, WHEEL_M = 2.2, 1.9, 0.33
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
_GLASS = (34, 40, 46)
_DOORS = (
    (0.02, 0.36, 0.7),
    (0.05, 0.5),
    (0.0, 0.3, 0.62, 0.9),
    (0.1, 0.42, 0.74),
)  # pillars along the windows


def rect(at_m: tuple[float, float], size_m: tuple[float, float]) -> Rect:
    """Part of the texture as texture coordinates."""
    return (
        at_m[0] / SIZE_M[0],
        at_m[1] / SIZE_M[1],
        (at_m[0] + size_m[0]) / SIZE_M[0],
        (at_m[1] + size_m[1]) / SIZE_M[1],
    )


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
    for at, lamp in ((FRONT_AT_M, (240, 240, 230)), (REAR_AT_M, (176, 22, 20))):
        _end(canvas, at, belt_m, lamp, rng)
    _wheel(canvas, rng)
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
        canvas.fill(
            np.array([[a, 0.3], [b, 0.5], [b, 0.9], [a, 0.7]]) + np.array([x0, y0]), (170, 182, 190), 0.4
        )
    canvas.rect(x0 + last + 0.5, y0 + 0.25, x0 + profile[-1, 0], y0 + 0.27, color * 0.4)
    canvas.rect(x0 + last + 0.5, y0 + WIDE_M - 0.27, x0 + profile[-1, 0], y0 + WIDE_M - 0.25, color * 0.4)


def _end(
    canvas: Canvas, at: tuple[float, float], belt: float, lamp: tuple[int, int, int], rng: np.random.Generator
) -> None:
    x0, ground = at[0], at[1] + TALL_M - 0.4
    canvas.rect(x0, ground - 0.12, x0 + WIDE_M, ground + 0.4, (28, 28, 30))
    wide, tall, raised = rng.uniform(0.22, 0.42), rng.uniform(0.12, 0.26), rng.uniform(0.46, 0.56)
    for left in (0.1, WIDE_M - 0.1 - wide):
        canvas.rect(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, lamp)
        canvas.frame(x0 + left, ground - raised, x0 + left + wide, ground - raised + tall, 0.03, (30, 30, 32))
    low, high = rng.uniform(0.52, 0.68), rng.uniform(0.24, 0.32)
    for bar in np.linspace(ground - 0.44, ground - high, int(rng.integers(1, 5))):
        canvas.rect(x0 + low, bar, x0 + WIDE_M - low, bar + 0.05, (30, 30, 32))
    canvas.rect(x0 + 0.66, ground - 0.14, x0 + 1.24, ground - 0.02, (236, 234, 222))
    plate = "".join(rng.choice(list("ABCDEFHKLMNPRSTUVX"), 3)) + str(rng.integers(100, 999))
    canvas.text(plate, x0 + 0.69, ground - 0.035, 0.08, (20, 20, 20))


def _wheel(canvas: Canvas, rng: np.random.Generator) -> None:
    """A tyre around a rim with holes, spokes, or a cap."""
    x, y = WHEEL_AT_M[0] + WHEEL_M, WHEEL_AT_M[1] + WHEEL_M
    canvas.ellipse((x, y), (WHEEL_M, WHEEL_M), (24, 24, 25))
    rim, style, count = rng.uniform(0.19, 0.25), rng.integers(3), int(rng.integers(5, 11))
    light, dark = np.full(3, rng.uniform(90, 190)), np.full(3, rng.uniform(22, 50))
    turn = rng.uniform(0, 2 * np.pi)
    angles = turn + np.linspace(0, 2 * np.pi, count, endpoint=False)
    canvas.ellipse((x, y), (rim, rim), dark if style == 1 else light)
    for angle in angles:
        ahead = np.array([np.cos(angle), np.sin(angle)])
        if style == 0:
            hole = rng.uniform(0.03, 0.05)
            canvas.ellipse((x, y) + 0.62 * rim * ahead, (hole, hole), dark)
        elif style == 1:
            canvas.stroke(np.array([[x, y], (x, y) + rim * ahead]), 0.16 / count**0.5, light)
        else:
            canvas.stroke(np.array([(x, y) + 0.4 * rim * ahead, (x, y) + 0.8 * rim * ahead]), 0.02, dark)
    canvas.ellipse((x, y), (0.3 * rim, 0.3 * rim), light * rng.uniform(0.6, 1.1))
