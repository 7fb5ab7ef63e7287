"""Bark and foliage: the one skin that all trees, bushes, hedges and lawns wear.

The right part of the texture is a field of painted leaves, one column a species; from top to bottom each
column goes from leaves in deep shade to leaves in the open, so that a mesh darkens the inside of a crown by
its texture coordinates alone.
"""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect

_SIZE_M = (7.0, 4.0)
_TEXEL_M = 0.0065
_BARK_SHARE, _BARK_COLORS = 0.06, ((104.0, 96.0, 82.0), (150.0, 146.0, 128.0), (196.0, 194.0, 188.0))
_LEAF_LIGHT = 22000
_GREENS = {  # RGB of a leaf in the open
    "lime": (96, 116, 50),
    "plane": (116, 124, 62),
    "hornbeam": (70, 98, 42),
    "birch": (128, 134, 68),
    "spruce": (56, 82, 60),
    "copper": (112, 62, 58),
}
SPECIES = tuple(_GREENS)


def bark(kind: int) -> Rect:
    """Bark of one of three kinds: furrowed brown, mottled, white."""
    return (kind * _BARK_SHARE + 0.004, 0.01, (kind + 1) * _BARK_SHARE - 0.004, 0.99)


def leaves(species: str) -> Rect:
    """Column of a species' leaves: shade at the top, light at the bottom."""
    first = len(_BARK_COLORS) * _BARK_SHARE
    width = (1.0 - first) / len(SPECIES)
    left = first + width * SPECIES.index(species)
    return (left + 0.006, 0.02, left + width - 0.006, 0.98)


def leaves_color(species: str) -> tuple[int, int, int]:
    """RGB of a species' leaf in the open."""
    return _GREENS[species]


def paint_plants(rng: np.random.Generator) -> RgbImage:
    """Paint three barks and a column of leaves for every species."""
    canvas = Canvas(*_SIZE_M, (_TEXEL_M, _TEXEL_M), (30, 38, 20))
    _ground_of_columns(canvas)
    clumps = fractal(rng, canvas.shape, canvas.cells(0.5), 3)
    first_m = len(_BARK_COLORS) * _BARK_SHARE * _SIZE_M[0]
    x, y = rng.uniform(first_m, _SIZE_M[0], _LEAF_LIGHT), rng.uniform(0, _SIZE_M[1], _LEAF_LIGHT)
    light = rng.beta(2.0, 2.6, _LEAF_LIGHT)
    turn, length_m = rng.uniform(0, np.pi, _LEAF_LIGHT), rng.uniform(0.025, 0.06, _LEAF_LIGHT)
    colors = _leaf_colors(x, y, light)
    leaf = np.array([[-1.0, 0.0], [-0.2, 0.42], [1.0, 0.0], [-0.2, -0.42]])
    for k in np.argsort(light + rng.normal(0, 0.15, _LEAF_LIGHT)):
        c, s = np.cos(turn[k]), np.sin(turn[k])
        row, column = int(y[k] / _TEXEL_M) % canvas.shape[0], int(x[k] / _TEXEL_M) % canvas.shape[1]
        color = colors[k] * (1.0 + 0.15 * clumps[row, column])
        outline = (leaf @ np.array([[c, s], [-s, c]]) * length_m[k] + [x[k], y[k]]) / _TEXEL_M
        cv2.fillConvexPoly(canvas.pixels, np.round(outline).astype(np.int32), color.tolist())
    for kind in range(len(_BARK_COLORS)):
        _bark(canvas, kind, rng)
    return canvas.image()


def _exposure(y_m: Array) -> Array:
    """How much light leaves at a height of the texture get."""
    result: Array = 0.5 + 0.72 * np.clip(y_m / _SIZE_M[1], 0, 1)
    return result


def _species_at(x_m: Array) -> NDArray[np.int64]:
    first_m = len(_BARK_COLORS) * _BARK_SHARE * _SIZE_M[0]
    share = np.clip((x_m - first_m) / (_SIZE_M[0] - first_m), 0, 0.999)
    return np.asarray(share * len(SPECIES), np.int64)


def _leaf_colors(x_m: Array, y_m: Array, light: Array) -> Array:
    greens = np.array(list(_GREENS.values()), float)[_species_at(x_m)]
    result: Array = greens * ((0.62 + 0.62 * light) * _exposure(y_m))[:, None]
    return result


def _ground_of_columns(canvas: Canvas) -> None:
    """What is seen between the leaves: the same green, far darker."""
    x_m, y_m = ((np.arange(count, dtype=np.float64) + 0.5) * _TEXEL_M for count in canvas.shape[::-1])
    greens = np.array(list(_GREENS.values()), float)[_species_at(x_m)]
    canvas.pixels[:] = 0.38 * greens[None] * _exposure(y_m)[:, None, None]


def _bark(canvas: Canvas, kind: int, rng: np.random.Generator) -> None:
    left, right = (round((kind + end) * _BARK_SHARE * canvas.shape[1]) for end in (0, 1))
    shape = (canvas.shape[0], right - left)
    furrows = fractal(rng, shape, (canvas.cells(0.35)[0], canvas.cells(0.05)[1]), 4, 0.8)
    patches = fractal(rng, shape, canvas.cells(0.3), 4, 0.7)
    if kind == 0:
        tone = 1.0 + 0.3 * furrows + 0.2 * patches
    elif kind == 1:
        tone = 1.0 + 0.22 * np.sign(patches) * np.abs(patches) ** 0.3 + 0.08 * furrows
    else:  # dark bands lie across a birch
        bands = fractal(rng, shape, (canvas.cells(0.05)[0], canvas.cells(0.4)[1]), 3, 0.7)
        tone = 1.0 - 0.75 * (bands > 1.1) + 0.06 * patches
    canvas.pixels[:, left:right] = tone[..., None] * np.array(_BARK_COLORS[kind], np.float32)
