"""Textured triangle meshes of the scenery: plain values, built from quads and tubes, known to no renderer.

Texture coordinates follow images: (0, 0) is the top left corner, v points down. Faces are counter-clockwise
seen from outside, since renderers cull back faces.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array

Rect = tuple[float, float, float, float]  # u0, v0, u1, v1 in texture coordinates
WHOLE: Rect = (0.0, 0.0, 1.0, 1.0)


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles with a normal and a texture coordinate at every vertex.

    Attributes:
        vertices_m: (N, 3).
        normals: (N, 3), unit.
        uvs: (N, 2).
        faces: (M, 3) indices into the vertices.
    """

    vertices_m: Array
    normals: Array
    uvs: Array
    faces: Array

    def moved(self, offset_m: Sequence[float] = (0.0, 0.0, 0.0), yaw_rad: float = 0.0) -> Mesh:
        """Turn about +z, then shift."""
        c, s = np.cos(yaw_rad), np.sin(yaw_rad)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        return Mesh(
            self.vertices_m @ turn.T + np.asarray(offset_m), self.normals @ turn.T, self.uvs, self.faces
        )

    def scaled(self, factor: float) -> Mesh:
        """Grow or shrink about the origin."""
        return Mesh(self.vertices_m * factor, self.normals, self.uvs, self.faces)


def merged(meshes: Iterable[Mesh]) -> Mesh:
    """Join meshes that share one texture."""
    parts = list(meshes)
    starts = np.cumsum([0] + [len(part.vertices_m) for part in parts[:-1]])
    return Mesh(
        np.vstack([part.vertices_m for part in parts]),
        np.vstack([part.normals for part in parts]),
        np.vstack([part.uvs for part in parts]),
        np.vstack([part.faces + start for part, start in zip(parts, starts, strict=True)]),
    )


def quads(corners_m: Array, uvs: Array) -> Mesh:
    """Flat-shaded quads; those without area are left out.

    Args:
        corners_m: (N, 4, 3) corners, counter-clockwise seen from outside.
        uvs: (N, 4, 2).
    """
    corners_m, uvs = np.asarray(corners_m, float), np.asarray(uvs, float)
    normals = np.cross(corners_m[:, 2] - corners_m[:, 0], corners_m[:, 3] - corners_m[:, 1])
    sizes = np.linalg.norm(normals, axis=1)
    kept = sizes > 1e-9
    normals = normals[kept] / sizes[kept, None]
    corners = 4 * np.arange(len(normals))[:, None]
    faces = (corners + np.array([0, 1, 2, 0, 2, 3])).reshape(-1, 3)
    return Mesh(
        corners_m[kept].reshape(-1, 3), np.repeat(normals, 4, axis=0), uvs[kept].reshape(-1, 2), faces
    )


def texture_part(
    part_m: tuple[float, float, float, float], size_m: tuple[float, float], inset_m: float
) -> Rect:
    """Return a part of a texture as texture coordinates, inside its edge so that no neighbour bleeds in.

    Args:
        part_m: Its left, top, width and height.
        size_m: Width and height of the whole texture.
        inset_m: How far inside.
    """
    x, y, w, h = part_m
    return (
        (x + inset_m) / size_m[0],
        (y + inset_m) / size_m[1],
        (x + w - inset_m) / size_m[0],
        (y + h - inset_m) / size_m[1],
    )


def rect_uvs(rect: Rect) -> Array:
    """Texture corners for a quad listed from bottom left, counter-clockwise; (4, 2)."""
    u0, v0, u1, v1 = rect
    return np.array([[u0, v1], [u1, v1], [u1, v0], [u0, v0]])


def box(low_m: Sequence[float], high_m: Sequence[float], rect: Rect = WHOLE, top: Rect | None = None) -> Mesh:
    """A box without underside; every wall shows the same part of the texture, read the right way round."""
    (x0, y0, z0), (x1, y1, z1) = low_m, high_m
    walls = [[(x0, y0), (x1, y0)], [(x1, y0), (x1, y1)], [(x1, y1), (x0, y1)], [(x0, y1), (x0, y0)]]
    corners = [[(*a, z0), (*b, z0), (*b, z1), (*a, z1)] for a, b in walls]
    corners.append([(x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1)])
    return quads(np.array(corners), np.array([rect_uvs(rect)] * 4 + [rect_uvs(top or rect)]))


def tube(axis_m: Array, radii_m: Array, sides: int, rect: Rect = WHOLE, turns: float = 1.0) -> Mesh:
    """A smooth open tube along a curve that mostly rises: trunks, branches, poles.

    Args:
        axis_m: (K, 3) points of the axis.
        radii_m: (K,) radii.
        sides: Corners around.
        rect: Part of the texture; u runs around, v along.
        turns: How often the part is repeated around.
    """
    axis_m = np.asarray(axis_m, float)
    tangents = np.gradient(axis_m, axis=0)
    tangents /= np.linalg.norm(tangents, axis=1, keepdims=True)
    # The reference direction is one no trunk, branch or lamp arm runs along.
    across = np.cross(tangents, np.array([0.34, 0.94, 0.02]))
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    other = np.cross(tangents, across)
    angles = np.linspace(0, 2 * np.pi, sides + 1)
    normals = across[:, None] * np.cos(angles)[None, :, None] + other[:, None] * np.sin(angles)[None, :, None]
    vertices = axis_m[:, None] + normals * np.asarray(radii_m, float)[:, None, None]
    u = rect[0] + (rect[2] - rect[0]) * turns * np.linspace(0, 1, sides + 1)
    v = np.linspace(rect[3], rect[1], len(axis_m))
    uvs = np.stack(np.broadcast_arrays(u[None, :], v[:, None]), axis=-1)
    k, j = np.meshgrid(np.arange(len(axis_m) - 1), np.arange(sides), indexing="ij")
    a = (k * (sides + 1) + j).ravel()
    b = a + sides + 1
    faces = np.vstack([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])
    return Mesh(vertices.reshape(-1, 3), normals.reshape(-1, 3), uvs.reshape(-1, 2), faces)


def disc(center_m: Sequence[float], radius_m: float, sides: int, rect: Rect = WHOLE) -> Mesh:
    """An upright disc that faces +x, its texture read from +x."""
    angles = np.linspace(0, 2 * np.pi, sides, endpoint=False)
    y, z = np.cos(angles), np.sin(angles)
    vertices = np.asarray(center_m) + radius_m * np.stack([np.zeros(sides), y, z], axis=1)
    uvs = np.stack([0.5 + 0.5 * y, 0.5 - 0.5 * z], axis=1)
    uvs = np.array(rect[:2]) + uvs * (np.array(rect[2:]) - np.array(rect[:2]))
    fan = np.array([[0, i, i + 1] for i in range(1, sides - 1)])
    return Mesh(vertices, np.tile([1.0, 0.0, 0.0], (sides, 1)), uvs, fan)
