"""A box truck and a bus, without their wheels; centred on the origin, nose to +x, standing at z = 0."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from typing import Literal

import numpy as np

from estimator.se3 import Array
from sim.paint.heavy import TALL_M, paint_bus, paint_truck, region
from sim.shapes.mesh import Mesh, box, merged, quads, rect_uvs
from sim.streets.scenery import Skin

_SILL_M = 0.42
_TEXTURE_M = 9.4  # of side that the texture holds
Outline = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class HeavyKind:
    """Measures of a large vehicle.

    Attributes:
        name: What it is.
        length_m: Bumper to bumper.
        width_m: Without mirrors.
        height_m: Of the roof.
        cab_m: Length of a separate cab; 0 for a bus.
        axles_m: x of rear and front axle from the tail.
    """

    name: Literal["truck", "bus"]
    length_m: float
    width_m: float
    height_m: float
    cab_m: float
    axles_m: tuple[float, float]


TRUCK = HeavyKind("truck", 6.4, 1.98, 2.95, 1.75, (1.35, 5.45))
BUS = HeavyKind("bus", 9.2, 2.0, 3.0, 0.0, (2.3, 7.2))


def heavy_body(kind: HeavyKind, rng: np.random.Generator) -> tuple[Mesh, Skin]:
    """Mesh and skin of one truck or bus."""
    is_bus = kind.name == "bus"
    painted = paint_bus(kind.length_m, rng) if is_bus else paint_truck(kind.length_m, kind.cab_m, rng)
    return _mesh(kind).moved((-kind.length_m / 2, 0.0, 0.0)), Skin(painted, specular=0.3)


def _mesh(kind: HeavyKind) -> Mesh:
    length, half = kind.length_m, kind.width_m / 2
    parts = []
    if kind.name == "bus":
        top = kind.height_m
        whole = (
            (0.0, _SILL_M),
            (0.0, 2.85),
            (0.15, top),
            (length - 0.25, top),
            (length, 2.4),
            (length, _SILL_M),
        )
        parts.append(_shell(whole, half, length))
    else:
        rear = length - kind.cab_m
        top, start = kind.height_m, rear + 0.1
        load = ((0.0, 0.75), (0.0, top), (rear, top), (rear, 0.75))
        cab = (
            (start, _SILL_M),
            (start, 2.4),
            (length - 0.55, 2.45),
            (length - 0.05, 1.45),
            (length, _SILL_M),
        )
        parts += [_shell(load, half, length), _shell(cab, half * 0.97, length)]
        parts.append(box((0.1, -half * 0.7, 0.45), (length - 0.3, half * 0.7, 0.8), region("black")))
    parts.append(box((0.3, -half + 0.28, 0.2), (length - 0.3, half - 0.28, 0.6), region("black")))
    for side in (-1, 1):
        y = sorted((side * half, side * (half + 0.16)))
        parts.append(box((length - 0.35, y[0], 1.7), (length - 0.25, y[1], 2.1), region("black")))
    return merged(parts)


def _shell(outline: Outline, half_m: float, length_m: float) -> Mesh:
    """A prism across the car from an outline that runs from the tail's sill over the roof to the nose's."""
    points = np.array(outline)
    strips, uvs = [], []
    for (x0, z0), (x1, z1) in itertools.pairwise(points):
        strips.append([(x0, half_m, z0), (x0, -half_m, z0), (x1, -half_m, z1), (x1, half_m, z1)])
        uvs.append(_end_uvs(x0, z0, x1, z1, half_m))
    meshes = [quads(np.array(strips), np.array(uvs))]
    # A fan of quads about the middle; each leaves out no more than it needs to be convex.
    middle = points.mean(axis=0)
    ring = np.roll(points, -1, axis=0)
    for side in (1, -1):
        first, last = (points, ring) if side > 0 else (ring, points)
        flat = np.stack([np.broadcast_to(middle, points.shape), first, (first + last) / 2, last], axis=1)
        corners = np.stack([flat[..., 0], np.full(flat.shape[:2], side * half_m), flat[..., 1]], axis=-1)
        meshes.append(quads(corners, _side_uvs(corners, side, length_m)))
    return merged(meshes)


def _end_uvs(x0: float, z0: float, x1: float, z1: float, half_m: float) -> Array:
    """Front and rear are read as such; what lies flat is roof."""
    if abs(x1 - x0) > abs(z1 - z0):
        return rect_uvs(region("roof"))
    u0, v0, u1, v1 = region("rear" if z1 > z0 else "front")
    low, high = (v1 + (v0 - v1) * z / TALL_M for z in (z0, z1))
    if z1 > z0:
        return np.array([[u0, low], [u1, low], [u1, high], [u0, high]])
    return np.array([[u1, low], [u0, low], [u0, high], [u1, high]])


def _side_uvs(corners: Array, side: int, length_m: float) -> Array:
    u0, v0, u1, v1 = region("left" if side > 0 else "right")
    x, z = corners[..., 0], corners[..., 2]
    along = (length_m - x if side > 0 else x) / _TEXTURE_M
    return np.stack([u0 + (u1 - u0) * along, v1 + (v0 - v1) * z / TALL_M], axis=-1)
