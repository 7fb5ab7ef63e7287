"""Roofs: planes of tiles with eaves, gables or hips at the ends, chimneys and dormers; or a flat parapet."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.facade import Facade
from sim.shapes.mesh import Mesh, box, merged, quads

WALL_M, DORMER_M = 0.9, 1.5  # heights of the texture's rows of plain wall and of dormer fronts, at its foot
DORMER_WIDTH_M = 1.4
_EAVES_M, _VERGE_M, _TILE_RUN_M = 0.34, 0.12, 4.8


def roof_mesh(facade: Facade, outline_m: Array, u: tuple[float, float]) -> Mesh:
    """Cover a house.

    Args:
        facade: The house.
        outline_m: (4, 2) front left, front right, back right, back left.
        u: The part of the texture with tiles above, plain wall, and dormer fronts at its foot.
    """
    if facade.roof.kind == "flat":
        return _flat(facade, outline_m, u)
    parts = [_planes(facade, outline_m, u)]
    left, right, right_back, left_back = outline_m
    ends = ((left + left_back) / 2, (right + right_back) / 2)
    along = ends[1] - ends[0]
    yaw = float(np.arctan2(along[1], along[0]))
    peak = facade.height_m + facade.roof.ridge_m
    wall = _wall_rect(facade, u)
    for share in facade.roof.chimneys:
        stack = box(
            (-0.35, -0.28, -0.9),
            (0.35, 0.28, 0.75),
            (wall[0], wall[1], wall[0] + 0.3 * (u[1] - u[0]), wall[3]),
        )
        parts.append(stack.moved((*(ends[0] + share * along), peak), yaw))
    for share in facade.roof.dormers:
        parts.append(_dormer(facade, outline_m, share, yaw, u))
    return merged(parts)


def _wall_rect(facade: Facade, u: tuple[float, float]) -> tuple[float, float, float, float]:
    h = facade.height_m
    return (u[0], (h - DORMER_M - WALL_M + 0.02) / h, u[1], (h - DORMER_M - 0.02) / h)


def _planes(facade: Facade, outline: Array, u: tuple[float, float]) -> Mesh:
    """Two sloping planes, and what closes their ends."""
    left, right, right_back, left_back = outline
    height, ridge = facade.height_m, facade.roof.ridge_m
    depth = float(np.linalg.norm(left_back - left))
    slope = ridge / (depth / 2)
    along = (right - left) / np.linalg.norm(right - left)
    top = [(left + left_back) / 2, (right + right_back) / 2]
    hip = (
        min(0.42 * float(np.linalg.norm(top[1] - top[0])), 0.5 * depth)
        if facade.roof.kind == "hip"
        else -_VERGE_M
    )
    top = [top[0] + hip * along, top[1] - hip * along]
    out = (left - left_back) / depth * _EAVES_M
    verge = (_EAVES_M if hip > 0 else _VERGE_M) * along
    eaves_z = height - slope * _EAVES_M + 0.02
    peak = height + ridge + 0.02
    low = [left + out - verge, right + out + verge, right_back - out + verge, left_back - out - verge]
    corners: list[list[tuple[float, ...]]] = []
    uvs: list[Array] = []
    for a, b, c, d in ((low[0], low[1], top[1], top[0]), (low[2], low[3], top[0], top[1])):
        _tile_plane(facade, (a, b, c, d), (eaves_z, peak), u, corners, uvs)
    if hip > 0:
        for a, b, c in ((low[1], low[2], top[1]), (low[3], low[0], top[0])):
            _tile_plane(facade, (a, b, c, c), (eaves_z, peak), u, corners, uvs)
    else:
        _gables(facade, (left, right, right_back, left_back), u, corners, uvs)
    _fascia(facade, low, eaves_z, u, corners, uvs)
    return quads(np.array(corners), np.array(uvs))


def _tile_plane(
    facade: Facade,
    quad: tuple[Array, Array, Array, Array],
    heights: tuple[float, float],
    u: tuple[float, float],
    corners: list[list[tuple[float, ...]]],
    uvs: list[Array],
) -> None:
    """One plane, cut into strips no wider than the tiles in the texture."""
    a, b, c, d = quad
    eaves, peak = heights
    length = float(np.linalg.norm(b - a))
    rise = float(np.hypot(np.linalg.norm((a + b - c - d) / 2), peak - eaves))
    count = max(1, int(np.ceil(length / _TILE_RUN_M)))
    tiles = facade.height_m - DORMER_M - WALL_M
    v = 0.99 * min(rise, tiles) / facade.height_m
    for k in range(count):
        low, high = k / count, (k + 1) / count
        p, q, r, s = a + low * (b - a), a + high * (b - a), d + high * (c - d), d + low * (c - d)
        corners.append([(*p, eaves), (*q, eaves), (*r, peak), (*s, peak)])
        end = u[0] + (u[1] - u[0]) * min(1.0, length / count / _TILE_RUN_M)
        uvs.append(np.array([[u[0], v], [end, v], [end, 0.005], [u[0], 0.005]]))


def _gables(
    facade: Facade,
    outline: tuple[Array, ...],
    u: tuple[float, float],
    corners: list[list[tuple[float, ...]]],
    uvs: list[Array],
) -> None:
    """Upright triangles of plain wall under the ends of the ridge."""
    left, right, right_back, left_back = outline
    wall, height, peak = _wall_rect(facade, u), facade.height_m, facade.height_m + facade.roof.ridge_m
    middle = (wall[0] + wall[2]) / 2
    for a, b in ((left_back, left), (right, right_back)):
        c = (a + b) / 2
        corners.append([(*a, height), (*b, height), (*c, peak), (*c, peak)])
        uvs.append(np.array([[wall[0], wall[3]], [wall[2], wall[3]], [middle, wall[1]], [middle, wall[1]]]))


def _fascia(
    facade: Facade,
    low: list[Array],
    eaves_z: float,
    u: tuple[float, float],
    corners: list[list[tuple[float, ...]]],
    uvs: list[Array],
) -> None:
    """The board under the eaves, and the soffit between it and the wall."""
    wall, deep = _wall_rect(facade, u), 0.16
    part = np.array([[wall[0], wall[3]], [wall[2], wall[3]], [wall[2], wall[1]], [wall[0], wall[1]]])
    for a, b in ((low[0], low[1]), (low[1], low[2]), (low[2], low[3]), (low[3], low[0])):
        corners.append([(*a, eaves_z - deep), (*b, eaves_z - deep), (*b, eaves_z), (*a, eaves_z)])
        uvs.append(part)
    corners.append([(*p, eaves_z - deep) for p in (low[3], low[2], low[1], low[0])])
    uvs.append(part)


def _flat(facade: Facade, outline: Array, u: tuple[float, float]) -> Mesh:
    """A plain top a little below a parapet."""
    wall, top = _wall_rect(facade, u), facade.height_m + 0.02
    part = np.array([[wall[0], wall[3]], [wall[2], wall[3]], [wall[2], wall[1]], [wall[0], wall[1]]])
    return quads(np.array([[(*p, top) for p in outline]]), part[None])


def _dormer(facade: Facade, outline: Array, share: float, yaw: float, u: tuple[float, float]) -> Mesh:
    """A small house in the roof with one window."""
    left, right, _, left_back = outline
    at = left + share * (right - left) + 0.22 * (left_back - left)
    h, per_m = facade.height_m, (u[1] - u[0]) / 5.0
    front = (u[0], (h - DORMER_M + 0.02) / h, u[0] + DORMER_WIDTH_M * per_m, 0.998)
    wall = _wall_rect(facade, u)
    half, deep, tall = DORMER_WIDTH_M / 2, 1.6, 1.35
    sides = box((-half, 0, -0.6), (half, deep, tall), wall, (u[0], 0.01, u[1], 0.2))
    face = quads(
        np.array([[(-half, -0.01, -0.1), (half, -0.01, -0.1), (half, -0.01, tall), (-half, -0.01, tall)]]),
        np.array([[[front[0], front[3]], [front[2], front[3]], [front[2], front[1]], [front[0], front[1]]]]),
    )
    z = h + facade.roof.ridge_m * 0.3
    return merged([sides, face]).moved((*at, z), yaw)
