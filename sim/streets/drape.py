"""Meshes that lie on the relief: bands along a path, and areas of any outline."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

import numpy as np
from scipy.spatial import Delaunay
from shapely import contains_xy, distance, get_parts, points
from shapely.geometry import LinearRing, MultiPolygon, Polygon

from estimator.se3 import Array
from sim.shapes.mesh import Mesh

HeightOf = Callable[[Array], Array]  # world xy (..., 2) -> (...)


def band(
    line_m: Callable[[Array, Array], Array],
    s_m: Array,
    d_m: Array,
    height_of: HeightOf,
    uvs: Array,
) -> Mesh:
    """A band that faces up, with smooth normals.

    Args:
        line_m: World xy of (s, d), such as ``Path.point_m``.
        s_m: (N,) rising.
        d_m: (M,) falling: from the left edge to the right one; or (N, M).
        height_of: What it lies on.
        uvs: (N, M, 2).
    """
    s, d = np.broadcast_arrays(s_m[:, None], d_m)
    xy = line_m(s, d)
    grid = np.concatenate([xy, height_of(xy)[..., None]], axis=2)
    normals = np.cross(np.gradient(grid, axis=0), -np.gradient(grid, axis=1))
    normals = normals / np.maximum(np.linalg.norm(normals, axis=2, keepdims=True), 1e-12)
    return Mesh(grid.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2), grid_faces(*s.shape))


def grid_faces(rows: int, columns: int) -> Array:
    """Triangles of a grid of vertices, row by row; they face the side from which columns go to the right."""
    first = (np.arange(rows - 1)[:, None] * columns + np.arange(columns - 1)).ravel()
    a, b, c, d = first + 1, first + columns + 1, first + columns, first
    return np.vstack([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def area(
    outline: Polygon, step_m: float, height_of: HeightOf, uv_of: Callable[[Array], Array], edge_m: float = 0.3
) -> Mesh:
    """A polygon, holes and all, as triangles about ``step_m`` wide that face up and follow its edge closely.

    Args:
        outline: World xy.
        step_m: Distance of the vertices inside.
        height_of: What it lies on.
        uv_of: Texture coordinates of (N, 2) world points.
        edge_m: Distance of the vertices along the edge.
    """
    x0, y0, x1, y1 = outline.bounds
    x, y = np.meshgrid(np.arange(x0, x1, step_m), np.arange(y0, y1, step_m))
    inner = np.stack([x.ravel(), y.ravel()], axis=1)
    return triangulated(outline, inner, height_of, uv_of, edge_m, 0.4 * step_m)


def triangulated(
    outline: Polygon,
    inner_m: Array,
    height_of: HeightOf,
    uv_of: Callable[[Array], Array],
    edge_m: float,
    margin_m: float,
) -> Mesh:
    """As ``area``, on vertices of one's own; those outside or within a margin of the edge are left out."""
    edge = np.vstack([_ring_points(ring.coords, edge_m) for ring in _rings(outline)])
    kept = contains_xy(outline, inner_m[:, 0], inner_m[:, 1])
    inner = inner_m[kept]
    inner = inner[distance(points(inner), outline.boundary) > margin_m] if len(inner) else inner
    xy = np.unique(np.vstack([edge, inner]).round(6), axis=0)
    faces = np.asarray(Delaunay(xy).simplices)
    a, b, c = (xy[faces[:, k]] for k in range(3))
    turns = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    faces[turns < 0] = faces[turns < 0][:, ::-1]
    middles = (a + b + c) / 3
    inside = contains_xy(outline, middles[:, 0], middles[:, 1]) & (np.abs(turns) > 1e-7)
    return _on(xy, faces[inside], height_of, uv_of)


def _on(xy: Array, faces: Array, height_of: HeightOf, uv_of: Callable[[Array], Array]) -> Mesh:
    step = 0.05
    slopes = [
        (height_of(xy + shift) - height_of(xy - shift)) / (2 * step)
        for shift in (np.array([step, 0.0]), np.array([0.0, step]))
    ]
    normals = np.stack([-slopes[0], -slopes[1], np.ones(len(xy))], axis=1)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Mesh(np.column_stack([xy, height_of(xy)]), normals, uv_of(xy), faces)


def _rings(outline: Polygon | MultiPolygon) -> Iterator[LinearRing]:
    for part in get_parts(outline):
        yield part.exterior
        yield from part.interiors


def _ring_points(coords: Array, edge_m: float) -> Array:
    """The corners of a ring, and points between where they are far apart."""
    corners = np.asarray(coords)[:, :2]
    pieces = []
    for a, b in pairwise(corners):
        count = max(1, int(np.ceil(np.linalg.norm(b - a) / edge_m)))
        pieces.append(a + (b - a) * (np.arange(count) / count)[:, None])
    return np.vstack(pieces)
