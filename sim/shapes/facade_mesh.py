"""The relief of a house: panels at their depths with reveals between them, gable walls and roof."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from estimator.se3 import Array
from sim.shapes.facade import Facade
from sim.shapes.mesh import Mesh, merged, quads

GABLE_M = 5.0  # width of the gable wall in the texture
ROOF_M = 3.0  # width of the roof tiles in the texture


def house_mesh(facade: Facade, front_m: Array, back_m: Array, ridge_m: float, relief_m: float) -> Mesh:
    """Build a house around its front.

    Args:
        facade: Plan of the front.
        front_m: (2, 2) world xy of the left and right front corner, seen from the street.
        back_m: (2, 2) the corners behind them.
        ridge_m: Height of the ridge above the eaves.
        relief_m: Panels nearer to the wall than this stay in it.
    """
    left, right = np.asarray(front_m, float)
    along = (right - left) / np.linalg.norm(right - left)
    outward = np.array([along[1], -along[0]])
    corners, uvs = _relief(facade, relief_m)
    flat = corners.reshape(-1, 3)  # x, z, depth
    xy = left + flat[:, :1] * along + flat[:, 2:] * outward
    world = np.hstack([xy, flat[:, 1:2]]).reshape(-1, 4, 3)
    return merged(
        [quads(world, uvs), _walls_and_roof(facade, np.asarray(front_m), np.asarray(back_m), ridge_m)]
    )


def atlas_width_m(facade: Facade) -> float:
    """Width of the texture: front, gable, roof side by side."""
    return facade.width_m + GABLE_M + ROOF_M


def _depths(facade: Facade, relief_m: float) -> tuple[Array, Array, Array]:
    """Grid lines in x and z, and the depth of every cell between them."""
    panels = [p for p in facade.panels if abs(p.depth_m) >= relief_m]
    xs = [0.0, facade.width_m] + [x for p in panels for x in (p.x0, p.x1)]
    zs = [0.0, facade.height_m] + [z for p in panels for z in (p.z0, p.z1)]
    x = np.unique(np.round(np.clip(xs, 0, facade.width_m), 3))
    z = np.unique(np.round(np.clip(zs, 0, facade.height_m), 3))
    depth = np.zeros((len(z) - 1, len(x) - 1))
    middle_x, middle_z = (x[1:] + x[:-1]) / 2, (z[1:] + z[:-1]) / 2
    for p in panels:
        inside = np.ix_((middle_z > p.z0) & (middle_z < p.z1), (middle_x > p.x0) & (middle_x < p.x1))
        depth[inside] = p.depth_m
    return x, z, depth


def _relief(facade: Facade, relief_m: float) -> tuple[Array, Array]:
    """Quads in (x, z, depth) and their texture coordinates: fronts, reveals, ledges."""
    x, z, depth = _depths(facade, relief_m)
    corners: list[list[tuple[float, float, float]]] = []
    for i, row in enumerate(depth):
        start = 0
        for j in range(1, len(row) + 1):
            if j == len(row) or row[j] != row[start]:
                d = row[start]
                a, b, low, high = x[start], x[j], z[i], z[i + 1]
                corners.append([(a, low, d), (b, low, d), (b, high, d), (a, high, d)])
                start = j
    corners += _reveals(x, z, np.pad(depth, 1))
    points = np.array(corners)
    # Reveals take the colour of the wall's edge a little way in, not a smear along one line of texels.
    u, v = points[..., 0] / atlas_width_m(facade), 1.0 - points[..., 1] / facade.height_m
    sideways = np.ptp(points[..., 0], axis=1) == 0
    u[sideways] -= 0.3 * points[sideways][..., 2] / atlas_width_m(facade)
    level = np.ptp(points[..., 1], axis=1) == 0
    v[level] -= 0.3 * points[level][..., 2] / facade.height_m
    limit = facade.width_m / atlas_width_m(facade)
    return points, np.stack([np.clip(u, 0, limit), np.clip(v, 0, 1)], axis=-1)


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


def _walls_and_roof(facade: Facade, front: Array, back: Array, ridge_m: float) -> Mesh:
    """Two gable walls, the back, both roof planes, and a backing that closes hairline gaps."""
    total, height = atlas_width_m(facade), facade.height_m
    g0, g1 = facade.width_m / total, (facade.width_m + GABLE_M) / total
    gable = np.array([[g0, 1.0], [g1, 1.0], [g1, 0.0], [g0, 0.0]])
    tiles = np.array([[g1 + 0.002, 1.0], [1.0, 1.0], [1.0, 0.5], [g1 + 0.002, 0.5]])

    def upright(a: Array, b: Array, low: float, high: float) -> list[Array]:
        return [np.append(a, low), np.append(b, low), np.append(b, high), np.append(a, high)]

    left, right = front
    left_back, right_back = back
    top_left, top_right = (left + left_back) / 2, (right + right_back) / 2
    peak = height + ridge_m
    corners = [upright(left_back, left, 0, height), upright(right, right_back, 0, height)]
    corners.append(upright(right_back, left_back, 0, height))
    uvs = [gable, gable, gable]
    inset = 0.5 * (left_back - left) / np.linalg.norm(left_back - left)
    corners.append(upright(left + inset, right + inset, 0, height))
    uvs.append(np.full((4, 2), [g0 * 0.5, 0.02]))
    for a, b, c, d in ((left, right, top_right, top_left), (right_back, left_back, top_left, top_right)):
        corners.append([np.append(a, height), np.append(b, height), np.append(c, peak), np.append(d, peak)])
        uvs.append(tiles)
    for a, b, c in ((left_back, left, top_left), (right, right_back, top_right)):
        corners.append([np.append(a, height), np.append(b, height), np.append(c, peak), np.append(c, peak)])
        uvs.append(gable)
    return quads(np.array(corners), np.array(uvs))
