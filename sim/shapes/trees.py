"""Trees of several species: a skeleton of trunk, boughs and twigs with clusters of leaves at its ends."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.paint.plants import bark
from sim.shapes.foliage import foliage
from sim.shapes.mesh import Mesh, merged, tube


@dataclass(frozen=True)
class Species:
    """Habit of a species.

    Attributes:
        leaf: Whose leaves it bears.
        bark: Kind of bark.
        height_m: Shortest and tallest.
        spread: Crown radius as a share of the height.
        clear: Share of the height below which the trunk is bare.
        rise_rad: How steeply boughs leave the trunk.
        clusters: Number of leaf clusters.
        fullness: Radius of a cluster as a share of the crown's radius.
        taper: 0 for a crown as wide above as below, 1 for a cone.
    """

    leaf: str
    bark: int
    height_m: tuple[float, float]
    spread: float
    clear: float
    rise_rad: float
    clusters: int
    fullness: float
    taper: float


SPECIES = (
    Species("lime", 0, (6.0, 8.5), 0.27, 0.33, 0.75, 34, 0.34, 0.35),
    Species("plane", 1, (6.5, 9.0), 0.31, 0.36, 0.5, 42, 0.28, 0.0),
    Species("hornbeam", 0, (5.5, 7.5), 0.17, 0.3, 1.2, 26, 0.48, 0.3),
    Species("birch", 2, (6.0, 9.0), 0.2, 0.26, 0.95, 30, 0.32, 0.5),
    Species("copper", 0, (5.0, 7.0), 0.3, 0.34, 0.6, 30, 0.34, 0.2),
)
SPRUCE = Species("spruce", 0, (4.5, 8.0), 0.22, 0.06, -0.12, 38, 0.3, 1.0)
FINE_TWIGS, COARSE_TWIGS = 1900, 350
_FINE_LEAF_M, _COARSE_LEAF_M = (0.11, 0.2), (0.24, 0.44)


def tree_mesh(species: Species, fine: bool, rng: np.random.Generator) -> Mesh:
    """A tree standing at the origin.

    Args:
        species: Its habit.
        fine: With leaves as small as a plane's, for trees that a camera passes closely; else fewer, larger.
        rng: Source of randomness.
    """
    height = float(rng.uniform(*species.height_m))
    trunk = _trunk(height, rng)
    ends, starts = _skeleton(species, height, trunk, rng)
    radius = 0.05 + 0.011 * height
    low = species.clear * height
    parts = [tube(trunk, radius * np.linspace(1.25, 0.22, len(trunk)), 7, bark(species.bark))]
    for start, end in list(zip(starts, ends, strict=True))[:: 2 if fine else 5]:
        parts.append(_bough(start, end, 0.36 * radius, species.bark, rng))
    middle = np.array([*trunk[-1, :2] * 0.6, (low + height) / 2])
    if not fine:  # fewer clusters, as full together
        ends = ends[::2]
    sizes = (
        species.fullness
        * species.spread
        * height
        * rng.uniform(0.7, 1.25, len(ends))
        * (1.0 if fine else 1.3)
    )
    count = FINE_TWIGS if fine else COARSE_TWIGS
    leaf_m = _FINE_LEAF_M if fine else _COARSE_LEAF_M
    parts.append(foliage(ends, sizes, middle, species.leaf, count, leaf_m, rng))
    return merged(parts)


def _trunk(height_m: float, rng: np.random.Generator) -> Array:
    """(8, 3) axis from below the ground to near the top, a little crooked."""
    z = np.linspace(-0.1, 0.93 * height_m, 8)
    lean = np.outer(z / height_m, rng.normal(0, 0.16, 2))
    sway = np.cumsum(rng.normal(0, 0.035, (8, 2)), axis=0)
    sway -= sway[0]
    return np.column_stack([lean + sway, z])


def _skeleton(species: Species, height: float, trunk: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Ends of the boughs, where leaves are, and where on the trunk each begins."""
    count = species.clusters
    # The golden angle spreads boughs around the trunk as plants do.
    turn = 2.39996 * np.arange(count) + rng.normal(0, 0.25, count)
    share = (np.arange(count) + rng.uniform(0.2, 0.8, count)) / count
    base = species.clear + (0.94 - species.clear) * share
    widest = species.spread * height
    round_top = np.sqrt(np.clip(1.0 - np.maximum(0.0, 2.0 * share - 1.0) ** 2, 0.12, 1.0))
    profile = (1 - species.taper) * round_top + species.taper * (1.05 - share)
    reach = widest * profile * rng.uniform(0.45, 1.0, count)
    rise = np.sin(species.rise_rad) * reach * rng.uniform(0.3, 1.0, count)
    z = np.minimum(base * height + rise, height - 0.15)
    axis = np.stack([np.interp(z, trunk[:, 2], trunk[:, k]) for k in (0, 1)], axis=1)
    ends = np.column_stack([axis + reach[:, None] * np.stack([np.cos(turn), np.sin(turn)], 1), z])
    foot = np.clip(
        z - np.tan(min(species.rise_rad, 1.25)) * reach, 0.8 * species.clear * height, 0.9 * height
    )
    starts = np.column_stack([np.interp(foot, trunk[:, 2], trunk[:, k]) for k in (0, 1)] + [foot])
    return ends, starts


def _bough(start: Array, end: Array, radius_m: float, kind: int, rng: np.random.Generator) -> Mesh:
    share = np.linspace(0, 1, 4)[:, None]
    axis = start + (end - start) * share + np.array([0, 0, 0.3]) * share * (1 - share)
    axis[1:3] += rng.normal(0, 0.05, (2, 3))
    return tube(axis, radius_m * np.array([1.0, 0.7, 0.45, 0.15]), 3, bark(kind))
