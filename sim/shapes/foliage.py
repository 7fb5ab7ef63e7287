"""Foliage: clusters of leaves before a dark ragged core, for crowns, bushes and hedges.

A leaf is one small kite that looks out of its cluster and is textured with leaves. Normals point out of the
whole plant rather than out of the leaf, so that a crown is shaded as one body and not as confetti; where the
leaf sits decides its tone, so that depth shows: outside bright, inside and below dark.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.plants import leaves
from sim.shapes.mesh import Mesh, Rect, merged

_CORE_ROWS, _CORE_COLUMNS = 2, 5


def foliage(
    clusters: Array,
    radii_m: Array,
    middle: Array,
    species: str,
    count: int,
    leaf_m: tuple[float, float],
    rng: np.random.Generator,
) -> Mesh:
    """Leaves around the centres of clusters, and a core inside each.

    Args:
        clusters: (N, 3) centres in the plant's frame.
        radii_m: (N,) radius of each.
        middle: (3,) middle of the plant, away from which it is shaded.
        species: Whose leaves.
        count: Leaves in all.
        leaf_m: Shortest and longest half length of a leaf.
        rng: Source of randomness.
    """
    reach = np.linalg.norm(clusters - middle, axis=1) + radii_m
    rect = leaves(species)
    cores = [_core(c, 0.56 * r, middle, rect, rng) for c, r in zip(clusters, radii_m, strict=True)]
    return merged([*cores, _leaves(clusters, radii_m, middle, float(reach.max()), rect, count, leaf_m, rng)])


def leaf_kites(
    spots: Array, out: Array, open_share: Array, rect: Rect, leaf_m: Array, rng: np.random.Generator
) -> Mesh:
    """Kites at the spots that look roughly along ``out``.

    Args:
        spots: (N, 3) their middles.
        out: (N, 3) shading normals, of any length.
        open_share: (N,) 0 in deep shade, 1 in the open.
        rect: Column of leaves in the texture.
        leaf_m: (N,) half lengths.
        rng: Source of randomness.
    """
    count = len(spots)
    normal = out / np.linalg.norm(out, axis=1, keepdims=True)
    facing = normal + 0.55 * rng.standard_normal((count, 3))
    facing /= np.linalg.norm(facing, axis=1, keepdims=True)
    a = np.cross(facing, rng.standard_normal((count, 3)))
    a /= np.linalg.norm(a, axis=1, keepdims=True)
    b = np.cross(facing, a)
    long, wide = leaf_m[:, None], 0.56 * leaf_m[:, None]
    corners = np.stack(
        [
            spots - a * long,
            spots - b * wide - 0.2 * a * long,
            spots + a * long,
            spots + b * wide - 0.2 * a * long,
        ],
        axis=1,
    )
    u_span, v_span = 0.2 * (rect[2] - rect[0]), 0.06
    u = rng.uniform(rect[0], rect[2] - u_span, count)[:, None] + u_span * np.array([0.0, 0.5, 1.0, 0.5])
    v_low = rect[1] + np.clip(open_share + rng.normal(0, 0.12, count), 0, 1) * (rect[3] - rect[1] - v_span)
    v = v_low[:, None] + v_span * np.array([0.5, 0.0, 0.5, 1.0])
    first = 4 * np.arange(count)[:, None]
    faces = (first + np.array([0, 1, 2, 0, 2, 3])).reshape(-1, 3)
    return Mesh(
        corners.reshape(-1, 3), np.repeat(normal, 4, axis=0), np.stack([u, v], -1).reshape(-1, 2), faces
    )


def _leaves(
    clusters: Array,
    radii_m: Array,
    middle: Array,
    reach_m: float,
    rect: Rect,
    count: int,
    leaf_m: tuple[float, float],
    rng: np.random.Generator,
) -> Mesh:
    """Leaves on the skins of the clusters, more on the larger ones."""
    chosen = rng.choice(len(clusters), count, p=radii_m**2 / np.sum(radii_m**2))
    direction = rng.standard_normal((count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    depth = rng.triangular(0.4, 0.95, 1.2, (count, 1)) * [1.0, 1.0, 0.85]
    spots = clusters[chosen] + direction * depth * radii_m[chosen, None]
    spots[:, 2] = np.maximum(spots[:, 2], 0.06)
    outward = spots - middle
    open_share = np.linalg.norm(outward, axis=1) / reach_m * 0.8 + 0.25 * direction[:, 2] + 0.12
    return leaf_kites(
        spots, outward / reach_m + 0.5 * direction, open_share, rect, rng.uniform(*leaf_m, count), rng
    )


def _core(center: Array, radius_m: float, middle: Array, rect: Rect, rng: np.random.Generator) -> Mesh:
    """A dented low body with the darkest leaves, which closes a cluster without hundreds of leaves."""
    up, around = np.meshgrid(
        np.linspace(-1.3, 1.3, _CORE_ROWS + 1), np.linspace(0, 2 * np.pi, _CORE_COLUMNS + 1), indexing="ij"
    )
    ball = np.stack([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), 0.8 * np.sin(up)], axis=-1)
    dents = rng.uniform(0.6, 1.25, (_CORE_ROWS + 1, _CORE_COLUMNS + 1, 1))
    dents[:, -1] = dents[:, 0]
    vertices = (center + radius_m * dents * ball).reshape(-1, 3)
    vertices[:, 2] = np.maximum(vertices[:, 2], 0.02)
    out = vertices - (middle + 2.0 * center) / 3.0
    u_span, v_span = 0.8 * (rect[2] - rect[0]), 0.2
    u = rng.uniform(rect[0], rect[2] - u_span) + u_span * around / (2 * np.pi)
    v = rng.uniform(rect[1] + 0.15, rect[1] + 0.3) + v_span * (1.3 + up) / 2.6
    i, j = (g.ravel() for g in np.meshgrid(np.arange(_CORE_ROWS), np.arange(_CORE_COLUMNS), indexing="ij"))
    a = i * (_CORE_COLUMNS + 1) + j
    b = a + _CORE_COLUMNS + 1
    faces = np.vstack([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])
    normals = out / np.maximum(np.linalg.norm(out, axis=1, keepdims=True), 1e-6)
    return Mesh(vertices, normals, np.stack([u, v], -1).reshape(-1, 2), faces)
