"""Convex outlines on the ground, and whether two of them overlap."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array


def rectangle_m(center_m: Array, yaw_rad: float, length_m: float, width_m: float) -> Array:
    """(4, 2) corners, counter-clockwise, of a rectangle whose length lies along its yaw."""
    c, s = np.cos(yaw_rad), np.sin(yaw_rad)
    half = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * [length_m / 2, width_m / 2]
    result: Array = half @ np.array([[c, s], [-s, c]]) + np.asarray(center_m)
    return result


def gap_m(one_m: Array, other_m: Array) -> float:
    """Widest separation over the edge directions of two convex outlines; negative means they overlap.

    Reference:
        Separating axis theorem; Ericson 2005, Real-Time Collision Detection, sec. 5.2.
    """
    edges = np.vstack([np.roll(p, -1, axis=0) - p for p in (one_m, other_m)])
    normals = np.stack([edges[:, 1], -edges[:, 0]], axis=1)
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-9)
    a, b = one_m @ normals.T, other_m @ normals.T
    return float(np.max(np.maximum(b.min(axis=0) - a.max(axis=0), a.min(axis=0) - b.max(axis=0))))


class Ground:
    """Remembers what stands where while a street is furnished."""

    def __init__(self, taken_m: list[Array]) -> None:
        self._taken = [(p, p.mean(axis=0), np.linalg.norm(p - p.mean(axis=0), axis=1).max()) for p in taken_m]

    @property
    def taken_m(self) -> list[Array]:
        """Every outline that stands there or is kept free."""
        return [outline for outline, _, _ in self._taken]

    def claim(self, outline_m: Array, clearance_m: float) -> bool:
        """Take the ground under an outline unless something stands there already."""
        center = outline_m.mean(axis=0)
        radius = np.linalg.norm(outline_m - center, axis=1).max()
        for other, middle, reach in self._taken:
            near = np.linalg.norm(center - middle) < radius + reach + clearance_m
            if near and gap_m(outline_m, other) < clearance_m:
                return False
        self._taken.append((outline_m, center, radius))
        return True
