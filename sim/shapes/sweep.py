"""Long things that follow a line over the ground: walls, rails, tunnels; a section drawn along a line."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.mesh import Mesh, quads


def sweep(line_m: Array, section_m: Array, u: Array, v: Array) -> Mesh:
    """Draw a cross-section along a line.

    A section listed upwards is seen from the right of the line; one that goes up on the left, across and
    down on the right is seen from inside.

    Args:
        line_m: (N, 3) points in world coordinates.
        section_m: (K, 2) metres left of the line and above it.
        u: (N,) texture coordinate of each point of the line.
        v: (K,) texture coordinate of each point of the section.
    """
    line_m, section_m = np.asarray(line_m, float), np.asarray(section_m, float)
    ahead = np.gradient(line_m[:, :2], axis=0)
    ahead /= np.linalg.norm(ahead, axis=1, keepdims=True)
    left = np.stack([-ahead[:, 1], ahead[:, 0]], axis=1)
    points = np.empty((len(line_m), len(section_m), 3))
    points[..., :2] = line_m[:, None, :2] + left[:, None] * section_m[None, :, :1]
    points[..., 2] = line_m[:, None, 2] + section_m[None, :, 1]
    uvs = np.stack(np.broadcast_arrays(np.asarray(u)[:, None], np.asarray(v)[None, :]), axis=-1)
    return quads(_cells(points), _cells(uvs))


def _cells(grid: Array) -> Array:
    """Corners of every cell of a (N, K, ...) grid: here, ahead, ahead and further in the section, further."""
    corners = np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2)
    return corners.reshape(-1, 4, grid.shape[-1])


def along_section(section_m: Array) -> Array:
    """(K,) share of the section's length at each of its points, 0 to 1."""
    steps = np.linalg.norm(np.diff(np.asarray(section_m, float), axis=0), axis=1)
    length = np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray(length / length[-1])
