"""Bushes, hedges and tufts of grass."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from sim.paint.plants import leaves
from sim.shapes.foliage import foliage, leaf_sprays
from sim.shapes.mesh import Mesh, box, merged


def bush_mesh(radius_m: float, species: str, rng: np.random.Generator) -> Mesh:
    """A bush standing at the origin."""
    count = 6
    turn, out = 2.39996 * np.arange(count), np.sqrt((np.arange(count) + 0.3) / count)
    spread = 0.72 * radius_m * out * rng.uniform(0.75, 1.15, count)
    z = radius_m * (0.38 + 0.62 * (1 - out**2) * rng.uniform(0.6, 1.2, count))
    clusters = np.column_stack([spread * np.cos(turn), spread * np.sin(turn), z])
    middle = np.array([0.0, 0.0, 0.3 * radius_m])
    scale = max(1.0, radius_m)
    sizes = 0.46 * radius_m * rng.uniform(0.7, 1.2, count)
    return foliage(
        clusters, sizes, middle, species, round(110 + 130 * radius_m), (0.09 * scale, 0.18 * scale), rng
    )


def hedge_mesh(
    length_m: float, height_m: float, width_m: float, species: str, rng: np.random.Generator
) -> Mesh:
    """A clipped hedge along +y, centred on the origin: a leafy body with a coat of leaves and twigs."""
    u0, v0, u1, v1 = leaves(species)
    parts, count = [], max(1, round(length_m / 1.1))
    edges = np.linspace(-length_m / 2, length_m / 2, count + 1)
    for low, high in pairwise(edges):
        half = width_m / 2 * rng.uniform(0.86, 1.0)
        left = u0 + 0.15 * (u1 - u0) * rng.random()
        part = (left, v0 + 0.3, left + 0.8 * (u1 - u0), v0 + 0.3 + 0.2 * height_m)
        top = (left, v1 - 0.2, left + 0.8 * (u1 - u0), v1)
        parts.append(box((-half, low, 0), (half, high, height_m * rng.uniform(0.94, 1.0)), part, top))
    return merged([*parts, _coat(length_m, height_m, width_m, species, rng)])


def _coat(length: float, height: float, width: float, species: str, rng: np.random.Generator) -> Mesh:
    """Leaves on both faces and on top; the top stands in the light."""
    count = round(length * (2 * height + width) * 10)
    on_top = rng.random(count) < width / (2 * height + width)
    side = rng.choice([-1.0, 1.0], count)
    across = np.where(
        on_top, rng.uniform(-0.5, 0.5, count) * width, side * (width / 2 + rng.normal(0.0, 0.03, count))
    )
    z = np.where(on_top, height + rng.normal(0.0, 0.04, count), rng.uniform(0.06, height, count))
    spots = np.column_stack([across, rng.uniform(-length / 2, length / 2, count), z])
    out = np.column_stack(
        [np.where(on_top, 0.2 * side, side), rng.normal(0, 0.2, count), np.where(on_top, 1.0, 0.3)]
    )
    open_share = np.where(on_top, 0.85, 0.25 + 0.5 * z / height)
    return leaf_sprays(spots, out, open_share, leaves(species), rng.uniform(0.09, 0.19, count), rng)


def tuft_mesh(species: str, rng: np.random.Generator) -> Mesh:
    """Weeds and grass knee-high and lower, standing at the origin."""
    count = 15
    spots = np.column_stack([rng.normal(0, 0.13, (count, 2)), 0.05 + np.abs(rng.normal(0, 0.09, count))])
    out = np.column_stack([spots[:, :2] * 3.0, np.full(count, 0.6)])
    return leaf_sprays(
        spots, out, 0.3 + 2.5 * spots[:, 2], leaves(species), rng.uniform(0.07, 0.16, count), rng
    )
