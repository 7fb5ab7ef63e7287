"""Meshes of what bounds a lot: fences of pickets and boards, walls of blocks. All share furniture's coats."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture_parts import region
from sim.shapes.mesh import Mesh, box, merged


def picket_fence(length_m: float) -> Mesh:
    """Pickets on two rails along +y from the origin."""
    wood = region("wood")
    u0, v0, u1, v1 = wood
    parts = []
    for k, y in enumerate(np.arange(0.0, length_m - 0.08, 0.16)):
        u = u0 + (u1 - u0) * ((k * 0.137) % 0.9)
        top = 1.0 + 0.05 * ((k * 7) % 3)
        parts.append(box((-0.015, y, 0.05), (0.015, y + 0.09, top), (u, v0, u + 0.1 * (u1 - u0), v1)))
    for z in (0.3, 0.8):
        parts.append(box((-0.04, 0, z), (0.04, length_m, z + 0.07), wood))
    return merged(parts)


def board_fence(length_m: float) -> Mesh:
    """A fence of upright boards, taller than a car, along y and centred on the origin."""
    u0, v0, u1, v1 = region("wood")
    parts = []
    for k, y in enumerate(np.arange(-length_m / 2, length_m / 2 - 0.2, 0.25)):
        u = u0 + (u1 - u0) * ((k * 0.37) % 0.85)
        top = 1.8 + 0.04 * ((k * 5) % 4)
        parts.append(box((-0.02, y, 0.0), (0.02, y + 0.235, top), (u, v0, u + 0.15 * (u1 - u0), v1)))
    return merged(parts)


def garden_wall(length_m: float, height_m: float = 0.8) -> Mesh:
    """A wall of concrete blocks along +y from the origin, every block its own piece of the texture."""
    u0, v0, u1, v1 = region("concrete")
    columns, rows = max(1, round(length_m / 1.1)), max(1, round(height_m / 0.6))
    y, z = np.linspace(0, length_m, columns + 1), np.linspace(0, height_m, rows + 1)
    parts = []
    for j in range(columns):
        for i in range(rows):
            left = u0 + 0.35 * (u1 - u0) * ((0.31 * j + 0.57 * i) % 1.0)
            part = (left, v0, left + 0.65 * (u1 - u0), v1)
            parts.append(box((-0.12, y[j], z[i]), (0.12, y[j + 1], z[i + 1]), part))
    return merged(parts)
