"""Bark and foliage: the one skin that all trees, bushes and hedges wear."""

from __future__ import annotations

import cv2
import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect

BARK: Rect = (0.01, 0.01, 0.17, 0.99)
LEAVES: Rect = (0.2, 0.0, 1.0, 1.0)
_SIZE_M = (5.0, 4.0)
_TEXEL_M = 0.0065


def paint_plants(rng: np.random.Generator) -> RgbImage:
    """Bark on the left fifth, leaves of many greens before dark gaps on the rest."""
    canvas = Canvas(*_SIZE_M, (_TEXEL_M, _TEXEL_M), (40, 52, 24))
    clumps = fractal(rng, canvas.shape, canvas.cells(0.5), 3)
    count = 26000
    x, y = rng.uniform(0.85, _SIZE_M[0], count), rng.uniform(0, _SIZE_M[1], count)
    light = rng.beta(2.0, 2.6, count)
    turn, length = rng.uniform(0, np.pi, count), rng.uniform(0.025, 0.065, count)
    leaf = np.array([[-1.0, 0.0], [-0.2, 0.42], [1.0, 0.0], [-0.2, -0.42]])
    for k in np.argsort(light + rng.normal(0, 0.15, count)):
        c, s = np.cos(turn[k]), np.sin(turn[k])
        row, column = int(y[k] / _TEXEL_M) % canvas.shape[0], int(x[k] / _TEXEL_M) % canvas.shape[1]
        tone = 0.5 + 0.8 * light[k] + 0.15 * clumps[row, column]
        color = np.array([96.0, 128.0, 52.0]) * tone
        outline = (leaf @ np.array([[c, s], [-s, c]]) * length[k] + [x[k], y[k]]) / _TEXEL_M
        cv2.fillConvexPoly(canvas.pixels, np.round(outline).astype(np.int32), color.tolist())
    _bark(canvas, rng)
    return canvas.image()


def _bark(canvas: Canvas, rng: np.random.Generator) -> None:
    width = round(0.18 * canvas.shape[1])
    shape = (canvas.shape[0], width)
    ridges = fractal(rng, shape, (canvas.cells(0.35)[0], canvas.cells(0.05)[1]), 4, 0.8)
    patches = fractal(rng, shape, canvas.cells(0.4), 4, 0.7)
    tone = 98.0 * (1.0 + 0.3 * ridges + 0.25 * np.sign(patches) * np.abs(patches) ** 0.5)
    canvas.pixels[:, :width] = tone[..., None] * np.array([1.02, 0.94, 0.82], np.float32)
