"""Trees, bushes and hedges: trunks and boughs as tubes, foliage as leaf cards before lumpy leafy cores.

Normals of cards point out of the crown rather than out of the card, so that a crown is shaded as one lumpy
body and not as confetti.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.plants import BARK, LEAVES
from sim.shapes.mesh import Mesh, box, merged, tube


def tree_mesh(height_m: float, crown_m: float, rng: np.random.Generator) -> Mesh:
    """A street tree standing at the origin.

    Args:
        height_m: Height of the crown's top.
        crown_m: Radius of the crown.
        rng: Source of randomness.
    """
    fork = 2.1 + 0.12 * height_m
    middle = np.array([0.0, 0.0, (fork + height_m) / 2])
    half = np.array([crown_m, crown_m, (height_m - fork) / 2 + 0.5])
    lean = rng.normal(0, 0.09, 2)
    heights = np.linspace(-0.1, fork + 0.6, 6)
    wave = np.cumsum(rng.normal(0, 0.025, (6, 2)), axis=0) + np.outer(heights / fork, lean)
    radius = 0.10 + 0.011 * height_m
    trunk = tube(
        np.column_stack([wave, heights]), radius * np.array([1.35, 1.0, 0.92, 0.88, 0.8, 0.6]), 8, BARK
    )
    lumps = _lumps(middle, half, 13, rng)
    start = np.array([*wave[-2], heights[-2]])
    boughs = [_bough(start, lump, 0.45 * radius, rng) for lump in lumps[:6]]
    return merged(
        [
            trunk,
            *boughs,
            *_cores(lumps[:9], 0.54 * crown_m, middle, rng),
            _foliage(lumps, 0.36 * crown_m, 190, (0.17, 0.34), middle, rng),
        ]
    )


def bush_mesh(radius_m: float, rng: np.random.Generator) -> Mesh:
    """A bush standing at the origin."""
    middle = np.array([0.0, 0.0, 0.6 * radius_m])
    lumps = _lumps(middle, np.array([0.7, 0.7, 0.6]) * radius_m, 6, rng)
    leaves = _foliage(lumps, 0.36 * radius_m, 70, (0.1, 0.22), middle * 0.5, rng)
    return merged([*_cores(lumps[:3], 0.55 * radius_m, middle * 0.5, rng), leaves])


def hedge_mesh(length_m: float, height_m: float, width_m: float, rng: np.random.Generator) -> Mesh:
    """A clipped hedge along +x from the origin, with twigs that stick out."""
    u0, v0 = rng.uniform(LEAVES[0], 0.3), rng.uniform(0, 0.4)
    part = (u0, v0, u0 + min(length_m / 5.0, 0.68), v0 + height_m / 4.0)
    core = box((0, -width_m / 2, 0), (length_m, width_m / 2, height_m), part)
    count = round(40 * length_m)
    spots = np.column_stack(
        [
            rng.uniform(0, length_m, count),
            rng.choice([-0.5, 0.5], count) * width_m,
            rng.uniform(0.1, height_m, count),
        ]
    )
    spots[::3, 1], spots[::3, 2] = rng.uniform(-0.5, 0.5, len(spots[::3])) * width_m, height_m
    out = np.column_stack([np.zeros(count), np.sign(spots[:, 1]), 0.4 * np.ones(count)])
    return merged([core, _cards(spots, out, (0.1, 0.2), rng)])


def _lumps(middle: Array, half: Array, count: int, rng: np.random.Generator) -> Array:
    """Centres of leaf clusters, spread over an ellipsoid, denser near its skin; (count, 3)."""
    direction = rng.standard_normal((count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    result: Array = middle + direction * half * rng.uniform(0.35, 0.8, (count, 1))
    return result


def _cores(lumps: Array, radius_m: float, middle: Array, rng: np.random.Generator) -> list[Mesh]:
    """Lumpy leafy bodies inside the clusters, which make a crown dense without thousands of cards."""
    rows, columns = 3, 6
    up, around = np.meshgrid(
        np.linspace(-1.4, 1.4, rows + 1), np.linspace(0, 2 * np.pi, columns + 1), indexing="ij"
    )
    ball = np.stack([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)], axis=-1)
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(rows), np.arange(columns), indexing="ij"))
    a = i * (columns + 1) + j
    b = a + columns + 1
    faces = np.vstack([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])
    cores = []
    for lump in lumps:
        dents = rng.uniform(0.75, 1.15, (rows + 1, columns + 1, 1))
        dents[:, -1] = dents[:, 0]
        vertices = (lump + radius_m * dents * ball * [1.0, 1.0, 0.8]).reshape(-1, 3)
        vertices[:, 2] = np.maximum(vertices[:, 2], 0.02)
        out = vertices - (middle + 2.0 * lump) / 3.0
        u0, v0 = rng.uniform(LEAVES[0], 0.75), rng.uniform(0.0, 0.7)
        uvs = np.stack([u0 + around / (2 * np.pi) * 0.24, v0 + (1.4 - up) / 2.8 * 0.28], axis=-1).reshape(
            -1, 2
        )
        cores.append(Mesh(vertices, out / np.linalg.norm(out, axis=1, keepdims=True), uvs, faces))
    return cores


def _bough(start: Array, end: Array, radius_m: float, rng: np.random.Generator) -> Mesh:
    share = np.linspace(0, 1, 4)[:, None]
    axis = start + (end - start) * share + np.array([0, 0, 0.25]) * share * (1 - share)
    axis[1:] += rng.normal(0, 0.06, (3, 3))
    return tube(axis, radius_m * np.array([1.0, 0.7, 0.45, 0.2]), 4, BARK)


def _foliage(
    lumps: Array,
    spread_m: float,
    count: int,
    size_m: tuple[float, float],
    middle: Array,
    rng: np.random.Generator,
) -> Mesh:
    """Cards scattered around the clusters."""
    offsets = rng.standard_normal((count, 3))
    offsets *= (
        np.minimum(1.0, 1.45 / np.linalg.norm(offsets, axis=1, keepdims=True)) * spread_m * [1.0, 1.0, 0.75]
    )
    spots = lumps[rng.integers(len(lumps), size=count)] + offsets
    spots[:, 2] = np.maximum(spots[:, 2], 0.05)
    out = (spots - middle) + 1.2 * offsets
    return _cards(spots, out, size_m, rng)


def _cards(spots: Array, out: Array, size_m: tuple[float, float], rng: np.random.Generator) -> Mesh:
    """Kites at the spots that look roughly along ``out``, (N, 3), which gives their normals."""
    count = len(spots)
    normal = out / np.linalg.norm(out, axis=1, keepdims=True)
    facing = normal + 0.5 * rng.standard_normal((count, 3))
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    a = np.cross(facing, rng.standard_normal((count, 3)))
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b = np.cross(facing, a)
    size = rng.uniform(*size_m, (count, 1))
    corners = np.stack(
        [spots - a * size, spots - b * size * 0.6, spots + a * size, spots + b * size * 0.6], axis=1
    )
    u = rng.uniform(LEAVES[0] + 0.01, 0.9, count)[:, None] + np.array([0.0, 0.04, 0.08, 0.04])
    v = rng.uniform(0.0, 0.88, count)[:, None] + np.array([0.05, 0.0, 0.05, 0.1])
    first = 4 * np.arange(count)[:, None]
    front = (first + np.array([0, 1, 2, 0, 2, 3])).reshape(-1, 3)
    return Mesh(
        corners.reshape(-1, 3),
        np.repeat(normal, 4, axis=0),
        np.stack([u, v], axis=-1).reshape(-1, 2),
        front,
    )
