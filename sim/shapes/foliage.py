"""Foliage: clusters of leaves, dark and broad inside, bright and small outside, for whatever grows.

Leaves are pointed triangles, three to a twig that looks out of its cluster: edges are ragged without any
transparency. Normals point out of the whole plant rather than out of the leaf, so that a crown is shaded as
one body and not as confetti; where a leaf sits decides its tone, so that depth shows: outside bright, inside
and below dark.
"""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.plants import leaves
from sim.shapes.mesh import Mesh, Rect, merged

_INNER_SHARE, _INNER_LEAF = 0.25, 1.9  # of the twigs; how much longer their leaves are
_INNER_DEPTH, _OUTER_DEPTH = (0.0, 0.3, 0.7), (0.4, 0.85, 1.25)  # in radii of a cluster
_FAN_RAD = np.array([-0.85, 0.0, 0.85])  # how the leaves of a twig spread
_HALF_WIDTH = 0.3  # of a leaf, as a share of its length
_V_SPAN = 0.1  # of the texture, from foot to tip of a leaf


def foliage(
    clusters: Array,
    radii_m: Array,
    middle: Array,
    species: str,
    count: int,
    leaf_m: tuple[float, float],
    rng: np.random.Generator,
) -> Mesh:
    """Leaves around the centres of clusters, and broad dark ones inside that close them.

    Args:
        clusters: (N, 3) centres in the plant's frame.
        radii_m: (N,) radius of each.
        middle: (3,) middle of the plant, away from which it is shaded.
        species: Whose leaves.
        count: Twigs in all, of three leaves each.
        leaf_m: Shortest and longest leaf.
        rng: Source of randomness.
    """
    reach = np.linalg.norm(clusters - middle, axis=1) + radii_m
    rect = leaves(species)
    inner = round(_INNER_SHARE * count)
    return merged(
        _twigs(clusters, radii_m, middle, float(reach.max()), rect, number, depth, sizes, rng)
        for number, depth, sizes in (
            (inner, _INNER_DEPTH, (_INNER_LEAF * leaf_m[0], _INNER_LEAF * leaf_m[1])),
            (count - inner, _OUTER_DEPTH, leaf_m),
        )
    )


def leaf_sprays(
    spots: Array, out: Array, open_share: Array, rect: Rect, leaf_m: Array, rng: np.random.Generator
) -> Mesh:
    """Twigs of three pointed leaves at the spots that look roughly along ``out``.

    Args:
        spots: (N, 3) where the leaves of a twig meet.
        out: (N, 3) shading normals, of any length.
        open_share: (N,) 0 in deep shade, 1 in the open.
        rect: Column of leaves in the texture.
        leaf_m: (N,) lengths of the leaves.
        rng: Source of randomness.
    """
    count = len(spots)
    normal = _unit(out)
    facing = _unit(normal + 0.55 * rng.standard_normal((count, 3)))
    ahead = _unit(np.cross(facing, rng.standard_normal((count, 3))))
    aside = np.cross(facing, ahead)
    turn = _FAN_RAD + rng.normal(0, 0.2, (count, len(_FAN_RAD)))
    along = np.cos(turn)[..., None] * ahead[:, None] + np.sin(turn)[..., None] * aside[:, None]
    across = np.cross(facing[:, None], along)
    long = (leaf_m[:, None] * rng.uniform(0.75, 1.15, turn.shape))[..., None]
    foot = spots[:, None] + 0.12 * long * along
    tip = spots[:, None] + long * along - 0.15 * long * facing[:, None]
    corners = np.stack([foot + _HALF_WIDTH * long * across, foot - _HALF_WIDTH * long * across, tip], axis=2)
    u_span = 0.16 * (rect[2] - rect[0])
    u = rng.uniform(rect[0], rect[2] - u_span, turn.shape)[..., None] + u_span * np.array([0.0, 1.0, 0.5])
    # Feet of leaves lie deeper in the shade than their tips.
    v_low = rect[1] + np.clip(open_share[:, None] + rng.normal(0, 0.11, turn.shape), 0, 1) * (
        rect[3] - rect[1] - _V_SPAN
    )
    v = v_low[..., None] + _V_SPAN * np.array([0.0, 0.0, 1.0])
    shaded = _unit(normal + 0.18 * rng.standard_normal((count, 3)))
    first = 3 * np.arange(turn.size)[:, None]
    faces = (first + np.array([0, 1, 2])).reshape(-1, 3)
    return Mesh(
        corners.reshape(-1, 3),
        np.repeat(shaded, 3 * len(_FAN_RAD), axis=0),
        np.stack([u, v], -1).reshape(-1, 2),
        faces,
    )


def _unit(vectors: Array) -> Array:
    result: Array = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return result


def _twigs(
    clusters: Array,
    radii_m: Array,
    middle: Array,
    reach_m: float,
    rect: Rect,
    count: int,
    depth: tuple[float, float, float],
    leaf_m: tuple[float, float],
    rng: np.random.Generator,
) -> Mesh:
    """Twigs at depths (least, most often, most) of the clusters, more on the larger ones."""
    chosen = rng.choice(len(clusters), count, p=radii_m**2 / np.sum(radii_m**2))
    direction = rng.standard_normal((count, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    reached = rng.triangular(*depth, count)
    spots = clusters[chosen] + direction * [1.0, 1.0, 0.85] * (reached * radii_m[chosen])[:, None]
    spots[:, 2] = np.maximum(spots[:, 2], 0.06)
    outward = spots - middle
    open_share = np.linalg.norm(outward, axis=1) / reach_m * 0.7 + 0.25 * direction[:, 2]
    open_share += 0.4 * reached - 0.06
    shading = outward / reach_m + 0.5 * direction + np.array([0.0, 0.0, 0.25])
    return leaf_sprays(spots, shading, open_share, rect, rng.uniform(*leaf_m, count), rng)
