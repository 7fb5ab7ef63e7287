"""The paint of a bicycle: coloured tubes, black rubber, bright metal and a red lamp in one small texture."""

from __future__ import annotations

import numpy as np

from sim.paint.canvas import Canvas, RgbImage
from sim.paint.noise import fractal
from sim.shapes.mesh import Rect, texture_part

_SIZE_M = (1.28, 0.64)
_TEXEL_M = 0.01
_PARTS = {  # left, top, width, height
    "frame": (0.0, 0.0, 1.28, 0.3),
    "black": (0.0, 0.32, 0.6, 0.3),
    "steel": (0.64, 0.32, 0.4, 0.3),
    "lamp": (1.08, 0.32, 0.18, 0.3),
}
_COLORS = ((180, 36, 34), (30, 32, 36), (40, 90, 150), (214, 214, 208), (46, 110, 74), (226, 160, 40))


def part(name: str) -> Rect:
    """Part of the texture as texture coordinates."""
    return texture_part(_PARTS[name], _SIZE_M, _TEXEL_M)


def paint_bicycle(rng: np.random.Generator) -> RgbImage:
    """Paint one bicycle."""
    color = np.array(_COLORS[rng.integers(len(_COLORS))], float)
    canvas = Canvas(*_SIZE_M, (_TEXEL_M, _TEXEL_M), color)
    canvas.rect(0.0, 0.1, 1.28, 0.14, 255.0 - 0.8 * color)
    for name, fill in (("black", (24, 24, 25)), ("steel", (186, 188, 190)), ("lamp", (200, 24, 20))):
        x, y, w, h = _PARTS[name]
        canvas.rect(x, y, x + w, y + h, fill)
    x, y, w, h = _PARTS["steel"]
    canvas.rect(x, y + 0.1, x + w, y + 0.16, (112, 114, 118))
    canvas.shade(0.08 * fractal(rng, canvas.shape, canvas.cells(0.1), 3, 0.7))
    return canvas.image()
