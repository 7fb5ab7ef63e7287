"""The relief of one wall: panels at their depths, with reveals and ledges between them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from estimator.se3 import Array
from sim.shapes.facade import Panel
from sim.shapes.mesh import Mesh, quads


def wall_mesh(
    panels: Sequence[Panel],
    size_m: tuple[float, float],
    left_m: Array,
    right_m: Array,
    relief_m: float,
    u: tuple[float, float],
) -> Mesh:
    """Build one wall.

    Args:
        panels: What stands out of it.
        size_m: Width and height that the panels are drawn for; the wall is stretched to where it stands.
        left_m: (2,) world xy of the left corner, seen from outside.
        right_m: (2,) of the right one.
        relief_m: Panels nearer to the wall than this stay in it.
        u: Where in the texture the wall begins and ends; it fills the whole height.
    """
    along = (np.asarray(right_m, float) - left_m) / size_m[0]
    outward = np.array([along[1], -along[0]]) / np.linalg.norm(along)
    corners, uvs = _relief([p for p in panels if abs(p.depth_m) >= relief_m], size_m, u)
    flat = corners.reshape(-1, 3)  # x, z, depth
    xy = left_m + flat[:, :1] * along + flat[:, 2:] * outward
    return quads(np.hstack([xy, flat[:, 1:2]]).reshape(-1, 4, 3), uvs)


def _depths(panels: Sequence[Panel], size_m: tuple[float, float]) -> tuple[Array, Array, Array]:
    """Grid lines in x and z, and the depth of every cell between them."""
    width, height = size_m
    xs = [0.0, width] + [x for p in panels for x in (p.x0, p.x1)]
    zs = [0.0, height] + [z for p in panels for z in (p.z0, p.z1)]
    x = np.unique(np.round(np.clip(xs, 0, width), 3))
    z = np.unique(np.round(np.clip(zs, 0, height), 3))
    depth = np.zeros((len(z) - 1, len(x) - 1))
    middle_x, middle_z = (x[1:] + x[:-1]) / 2, (z[1:] + z[:-1]) / 2
    for p in panels:
        inside = np.ix_((middle_z > p.z0) & (middle_z < p.z1), (middle_x > p.x0) & (middle_x < p.x1))
        depth[inside] = p.depth_m
    return x, z, depth


def _relief(
    panels: Sequence[Panel], size_m: tuple[float, float], u_span: tuple[float, float]
) -> tuple[Array, Array]:
    """Quads in (x, z, depth) and their texture coordinates: fronts, reveals, ledges."""
    x, z, depth = _depths(panels, size_m)
    points = np.array([*_fronts(x, z, depth), *_reveals(x, z, np.pad(depth, 1))])
    u_per_m, v_per_m = (u_span[1] - u_span[0]) / size_m[0], 1.0 / size_m[1]
    u, v = u_span[0] + points[..., 0] * u_per_m, 1.0 - points[..., 1] * v_per_m
    # Reveals take the colour of the wall's edge a little way in, not a smear along one line of texels.
    sideways = np.ptp(points[..., 0], axis=1) == 0
    u[sideways] -= 0.3 * points[sideways][..., 2] * u_per_m
    level = np.ptp(points[..., 1], axis=1) == 0
    v[level] -= 0.3 * points[level][..., 2] * v_per_m
    return points, np.stack([np.clip(u, *u_span), np.clip(v, 0, 1)], axis=-1)


def _fronts(x: Array, z: Array, depth: Array) -> list[list[tuple[float, float, float]]]:
    """The cells themselves, joined along rows of equal depth."""
    found: list[list[tuple[float, float, float]]] = []
    for i, row in enumerate(depth):
        start = 0
        for j in range(1, len(row) + 1):
            if j == len(row) or row[j] != row[start]:
                d = row[start]
                a, b, low, high = x[start], x[j], z[i], z[i + 1]
                found.append([(a, low, d), (b, low, d), (b, high, d), (a, high, d)])
                start = j
    return found


def _reveals(x: Array, z: Array, padded: Array) -> list[list[tuple[float, float, float]]]:
    """Walls between cells of different depth; ``padded`` has a border of zero depth around the cells."""
    found: list[list[tuple[float, float, float]]] = []
    for j in range(len(x)):  # flanks: from the left cell's depth to the right one's
        for i, k, a, b in _runs(padded[1:-1, j], padded[1:-1, j + 1]):
            found.append([(x[j], z[i], a), (x[j], z[i], b), (x[j], z[k], b), (x[j], z[k], a)])
    for i in range(len(z)):  # ledges: from the lower cell's depth to the upper one's
        for j, k, a, b in _runs(padded[i, 1:-1], padded[i + 1, 1:-1]):
            found.append([(x[j], z[i], a), (x[k], z[i], a), (x[k], z[i], b), (x[j], z[i], b)])
    return found


def _runs(one: Array, other: Array) -> Iterator[tuple[int, int, float, float]]:
    """Longest stretches over which two lines of cells keep the same two, different, depths."""
    start = 0
    for k in range(1, len(one) + 1):
        if k == len(one) or one[k] != one[start] or other[k] != other[start]:
            if one[start] != other[start]:
                yield start, k, float(one[start]), float(other[start])
            start = k
