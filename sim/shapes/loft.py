"""Rounded bodies through a row of elliptical cross-sections: limbs, heads, clothes, tyres, bicycle tubes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from estimator.se3 import Array
from sim.shapes.mesh import WHOLE, Mesh, Rect

Section = tuple[float, float, float, float, float]  # along the axis, centre (2), half widths (2)


def loft(
    sections: Sequence[Section] | Array,
    sides: int,
    rect: Rect = WHOLE,
    axis: Literal["x", "z"] = "z",
    squareness: float = 2.0,
) -> Mesh:
    """Join cross-sections, listed along the axis in its direction, into one smooth closed body.

    Along z a section's centre and half widths are given in x and y, along x in y and z. In the texture u
    runs around from the back (-x) over the right to the front and on, the right way round seen from outside;
    v runs along, up or forward.

    Args:
        sections: (K, 5).
        sides: Corners around.
        rect: Part of the texture.
        axis: What the body extends along.
        squareness: Exponent of the section's superellipse: 2 is an ellipse, 4 nearly a rectangle.
    """
    along, c1, c2, r1, r2 = np.asarray(sections, float).T[:, :, None]
    angles = np.linspace(-np.pi, np.pi, sides + 1)[None]
    across, up = (_signed_power(f(angles), 2.0 / squareness) for f in (np.cos, np.sin))
    ring = [c1 + r1 * across, c2 + r2 * up]
    level = np.broadcast_to(along, ring[0].shape)
    vertices = np.stack([*ring, level] if axis == "z" else [level, *ring], axis=-1)
    share = (along - along[0]) / (along[-1] - along[0])
    u = np.broadcast_to(rect[0] + (rect[2] - rect[0]) * (angles + np.pi) / (2 * np.pi), level.shape)
    v = np.broadcast_to(rect[3] + (rect[1] - rect[3]) * share, level.shape)
    faces = _grid_faces(len(along), sides + 1)
    normals = _smooth_normals(vertices, faces)
    return Mesh(vertices.reshape(-1, 3), normals, np.stack([u, v], axis=-1).reshape(-1, 2), faces)


def rounded(sections: Sequence[Section], roundness_m: float) -> list[Section]:
    """Close both ends of a row of sections with a dome of about that height."""
    first, last = sections[0], sections[-1]
    steps = ((1.0, 0.02), (0.85, 0.5), (0.5, 0.85))
    low = [(first[0] - roundness_m * h, *first[1:3], first[3] * w, first[4] * w) for h, w in steps]
    high = [(last[0] + roundness_m * h, *last[1:3], last[3] * w, last[4] * w) for h, w in reversed(steps)]
    return [*low, *sections, *high]


def limb(length_m: float, radii_m: Sequence[float], rect: Rect, sides: int = 10, flat: float = 1.0) -> Mesh:
    """A limb that hangs from its joint at the origin: radii from the joint down, rounded at both ends.

    Args:
        length_m: Down to the next joint.
        radii_m: Evenly spaced, from the joint to the end.
        rect: Part of the texture.
        sides: Corners around.
        flat: Half width across (y) over half width ahead (x).
    """
    levels = np.linspace(-length_m, 0.0, len(radii_m))
    rows = [(z, 0.0, 0.0, r, r * flat) for z, r in zip(levels, reversed(radii_m), strict=True)]
    return loft(rounded([(float(z), a, b, c, d) for z, a, b, c, d in rows], min(radii_m)), sides, rect)


def _signed_power(value: Array, exponent: float) -> Array:
    result: Array = np.sign(value) * np.abs(value) ** exponent
    return result


def _grid_faces(rows: int, columns: int) -> Array:
    i, j = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    a = (i * columns + j).ravel()
    b = a + columns
    return np.vstack([np.stack([a, a + 1, b + 1], 1), np.stack([a, b + 1, b], 1)])


def _smooth_normals(grid: Array, faces: Array) -> Array:
    """Area-weighted normals of a (rows, columns, 3) grid whose first and last columns coincide."""
    points = grid.reshape(-1, 3)
    a, b, c = (points[faces[:, k]] for k in range(3))
    facing = np.cross(b - a, c - a)
    normals = np.zeros_like(points)
    for k in range(3):
        np.add.at(normals, np.asarray(faces[:, k], int), facing)
    seam = normals.reshape(grid.shape)
    seam[:, 0] = seam[:, -1] = seam[:, 0] + seam[:, -1]
    sizes = np.linalg.norm(normals, axis=1, keepdims=True)
    result: Array = normals / np.maximum(sizes, 1e-12)
    return result


def turned(mesh: Mesh, rotation: Array, offset_m: Sequence[float] | Array = (0.0, 0.0, 0.0)) -> Mesh:
    """Turn by a (3, 3) rotation, then shift."""
    return Mesh(
        mesh.vertices_m @ rotation.T + np.asarray(offset_m), mesh.normals @ rotation.T, mesh.uvs, mesh.faces
    )


def pitch_rotation(angle_rad: float) -> Array:
    """Rotation about +y: positive tips what points up forward."""
    c, s = np.cos(angle_rad), np.sin(angle_rad)
    return np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])


def hanging_along(direction: Array) -> Array:
    """A rotation that lets what hangs along -z point along a direction, its front staying ahead."""
    down = np.asarray(direction, float) / np.linalg.norm(direction)
    left = np.cross(-down, np.array([1.0, 0.0, 0.0]))
    left /= np.linalg.norm(left)
    return np.stack([np.cross(left, -down), left, -down], axis=1)
