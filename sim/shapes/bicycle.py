"""A bicycle in parts: frame with handlebar, saddle and mudguards; a wheel; cranks with pedals. x is ahead.

The frame's origin lies on the ground under the rear axle; wheel and cranks turn about their own origins.
"""

from __future__ import annotations

import itertools

import numpy as np

from estimator.se3 import Array
from sim.paint.bicycle import part
from sim.shapes.loft import Section, loft, rounded
from sim.shapes.mesh import Mesh, Rect, box, merged, tube

WHEEL_M = 0.34
WHEELBASE_M = 1.05
BOTTOM_BRACKET_M = (0.44, 0.0, 0.28)
CRANK_M = 0.17
SADDLE_M = (0.24, 0.0, 0.96)
GRIP_M = (0.78, 0.28, 1.04)  # the left one

_HEAD_LOW, _HEAD_TOP, _FORK = (0.83, 0.0, 0.62), (0.77, 0.0, 0.86), (WHEELBASE_M, 0.0, WHEEL_M)


def frame_mesh() -> Mesh:
    """Everything that neither turns nor pedals."""
    paint, black, steel = part("frame"), part("black"), part("steel")
    bracket, seat = BOTTOM_BRACKET_M, (0.29, 0.0, 0.80)
    parts = [
        _bar(bracket, _HEAD_LOW, 0.02, paint),
        _bar(seat, _HEAD_TOP, 0.017, paint),
        _bar(bracket, seat, 0.017, paint),
        _bar(_HEAD_LOW, (0.75, 0.0, 0.97), 0.02, paint),
        _bar(seat, (0.25, 0.0, 0.94), 0.013, steel),
        _bar((0.75, 0.0, 0.97), (0.74, 0.0, 1.03), 0.013, steel),
        *_stays(paint),
        *_handlebar(steel, black),
        _saddle(black),
        *_mudguards(black),
    ]
    return merged(parts)


def _stays(paint: Rect) -> list[Mesh]:
    parts = []
    for y in (-0.06, 0.06):
        axle, fork = (0.0, y, WHEEL_M), (_FORK[0], y, _FORK[2])
        parts += [
            _bar(axle, (0.44, y / 2, 0.28), 0.010, paint),
            _bar(axle, (0.29, y / 3, 0.80), 0.009, paint),
        ]
        parts.append(_bar(fork, (0.83, y * 0.8, 0.64), 0.012, paint))
    return parts


def _handlebar(steel: Rect, black: Rect) -> list[Mesh]:
    x, y, z = GRIP_M
    parts = []
    for side in (-1, 1):
        parts.append(_bar((0.80, 0.0, 1.03), (x + 0.02, side * 0.2, z), 0.012, steel))
        parts.append(_bar((x + 0.02, side * 0.2, z), (x - 0.05, side * (y + 0.03), z), 0.017, black))
    return parts


def _saddle(black: Rect) -> Mesh:
    x, _, z = SADDLE_M
    rows: list[Section] = [
        (x - 0.13, 0.0, z - 0.02, 0.08, 0.028),
        (x - 0.04, 0.0, z - 0.02, 0.07, 0.03),
        (x + 0.13, 0.0, z - 0.02, 0.022, 0.022),
    ]
    return loft(rounded(rows, 0.02), 10, black, axis="x")


def _mudguards(black: Rect) -> list[Mesh]:
    rear_light = box((-0.315, -0.03, 0.545), (-0.275, 0.03, 0.61), part("lamp"))
    front_light = box((0.84, -0.03, 0.86), (0.89, 0.03, 0.92), part("steel"))
    parts = [rear_light, front_light]
    for x, first, last in ((0.0, 1.2, 3.3), (WHEELBASE_M, 0.9, 2.6)):
        angles = np.linspace(last, first, 9)
        radius = WHEEL_M + 0.02
        curve = np.column_stack([x + radius * np.cos(angles), 0 * angles, WHEEL_M + radius * np.sin(angles)])
        for a, b in itertools.pairwise(curve):
            parts.append(_bar(a, b, 0.018, black, sides=5))
    return parts


def wheel_mesh() -> Mesh:
    """Tyre, rim and spokes, turning about y."""
    angles = np.linspace(0, 2 * np.pi, 25)
    parts = [
        _ring(angles, WHEEL_M - 0.018, 0.018, part("black"), 6),
        _ring(angles, WHEEL_M - 0.04, 0.01, part("steel"), 4),
    ]
    for k in range(14):
        angle = 2 * np.pi * k / 14
        rim = (0.305 * np.cos(angle), 0.0, 0.305 * np.sin(angle))
        hub = (0.02 * np.cos(angle + 1.2), 0.025 * (-1) ** k, 0.02 * np.sin(angle + 1.2))
        parts.append(_bar(hub, rim, 0.0022, part("steel"), sides=3))
    parts.append(_bar((0.0, -0.05, 0.0), (0.0, 0.05, 0.001), 0.022, part("steel"), sides=8))
    return merged(parts)


def cranks_mesh() -> Mesh:
    """Chain ring, cranks and pedals, turning about y; the left crank points ahead."""
    steel, black = part("steel"), part("black")
    angles = np.linspace(0, 2 * np.pi, 21)
    parts = [_ring(angles, 0.085, 0.012, steel, 4).moved((0.0, -0.055, 0.0))]
    for side in (1, -1):
        x = side * CRANK_M
        parts.append(_bar((0.0, side * 0.065, 0.0), (x, side * 0.075, 0.001), 0.012, steel))
        parts.append(
            box((x - 0.04, side * 0.13 - 0.045, -0.012), (x + 0.04, side * 0.13 + 0.045, 0.012), black)
        )
    return merged(parts)


def _ring(angles: Array, radius: float, thick: float, rect: Rect, sides: int) -> Mesh:
    around = np.linspace(0, 2 * np.pi, sides + 1)
    out = np.stack([np.cos(angles), 0 * angles, np.sin(angles)], axis=1)
    across = np.array([0.0, 1.0, 0.0])
    normals = np.cos(around)[None, :, None] * out[:, None] + np.sin(around)[None, :, None] * across
    vertices = radius * out[:, None] + thick * normals
    share = np.linspace(0, 1, len(angles))
    u = np.broadcast_to(rect[0] + (rect[2] - rect[0]) * (8 * share[:, None] % 1), vertices.shape[:2])
    v = np.broadcast_to(rect[1] + (rect[3] - rect[1]) * around[None] / 2 / np.pi, vertices.shape[:2])
    rows, columns = vertices.shape[:2]
    i, j = (g.ravel() for g in np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij"))
    a = i * columns + j
    b = a + columns
    faces = np.vstack([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])
    return Mesh(vertices.reshape(-1, 3), normals.reshape(-1, 3), np.stack([u, v], -1).reshape(-1, 2), faces)


def _bar(
    start: tuple[float, ...] | Array,
    end: tuple[float, ...] | Array,
    radius: float,
    rect: Rect,
    sides: int = 7,
) -> Mesh:
    return tube(np.array([start, end], float), np.array([radius, radius]), sides, rect)
