"""Where on the skin of a person each part of the body and each piece of clothing is painted."""

from __future__ import annotations

from sim.paint.canvas import Canvas, Color
from sim.shapes.mesh import Rect, texture_part

SIZE_M = (1.92, 2.4)
TEXEL_M = 0.004
# Name: left, top, width, height in metres. The front of what goes round a body is at its middle.
REGIONS = {
    "torso": (0.0, 0.0, 1.12, 0.8),
    "head": (1.16, 0.0, 0.72, 0.36),
    "hair": (1.16, 0.4, 0.72, 0.36),
    "thigh": (0.0, 0.84, 0.56, 0.5),
    "shin": (0.6, 0.84, 0.5, 0.5),
    "shoe": (1.16, 0.84, 0.5, 0.3),
    "sleeve": (0.0, 1.38, 0.4, 0.4),
    "cuff": (0.44, 1.38, 0.4, 0.4),
    "hand": (0.88, 1.38, 0.2, 0.2),
    "bag": (1.16, 1.2, 0.6, 0.56),
    "coat": (0.0, 1.82, 1.2, 0.54),
    "hat": (1.24, 1.82, 0.64, 0.3),
}


def region(name: str) -> Rect:
    """Part of the texture as texture coordinates, a texel in from its borders."""
    return texture_part(REGIONS[name], SIZE_M, TEXEL_M)


def fill_region(canvas: Canvas, name: str, color: Color) -> None:
    """Paint a whole part in one color."""
    x, y, w, h = REGIONS[name]
    canvas.rect(x, y, x + w, y + h, color)
