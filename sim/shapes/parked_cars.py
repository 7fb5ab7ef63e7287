"""Parked cars: hulls lofted through a few cross-sections, with painted windows, doors, lamps and wheels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.paint.car_lamps import car_lamp_glow
from sim.paint.car_layout import (
    BLACK_AT_M,
    FRONT_AT_M,
    REAR_AT_M,
    SIDE_AT_M,
    SIZE_M,
    TALL_M,
    TOP_AT_M,
    WHEEL_AT_M,
    WHEEL_M,
    WIDE_M,
    rect,
)
from sim.paint.cars import paint_car
from sim.shapes.mesh import Mesh, box, disc, merged, quads
from sim.streets.scenery import Skin


@dataclass(frozen=True)
class CarKind:
    """Outline of a car, tail to nose: (x, height) pairs; the belt line; the axles."""

    profile_m: tuple[tuple[float, float], ...]
    belt_m: float
    axles_m: tuple[float, float]
    width_m: float


HATCH = CarKind(
    ((0, 0.55), (0.05, 0.95), (0.45, 1.38), (0.9, 1.47), (2.2, 1.45), (2.9, 0.98), (3.7, 0.85), (3.95, 0.5)),
    belt_m=0.93,
    axles_m=(0.75, 3.2),
    width_m=1.72,
)
SEDAN = CarKind(
    ((0, 0.55), (0.05, 0.98), (0.8, 1.02), (1.45, 1.42), (2.6, 1.44), (3.35, 0.98), (4.3, 0.82), (4.55, 0.5)),
    belt_m=0.95,
    axles_m=(0.95, 3.65),
    width_m=1.8,
)
VAN = CarKind(
    ((0, 0.5), (0.03, 1.2), (0.12, 1.85), (0.4, 1.95), (3.2, 1.93), (3.9, 1.2), (4.5, 1.0), (4.7, 0.5)),
    belt_m=1.15,
    axles_m=(0.9, 3.75),
    width_m=1.86,
)
ESTATE = CarKind(
    ((0, 0.55), (0.04, 1.0), (0.3, 1.4), (0.9, 1.5), (2.8, 1.47), (3.5, 1.0), (4.4, 0.84), (4.6, 0.5)),
    belt_m=0.97,
    axles_m=(0.9, 3.68),
    width_m=1.82,
)
OFF_ROADER = CarKind(
    ((0, 0.62), (0.04, 1.1), (0.25, 1.62), (0.8, 1.7), (2.5, 1.66), (3.1, 1.14), (4.15, 1.02), (4.35, 0.58)),
    belt_m=1.1,
    axles_m=(0.85, 3.45),
    width_m=1.85,
)
KINDS = (HATCH, HATCH, SEDAN, SEDAN, ESTATE, OFF_ROADER, VAN)


def car_mesh(kind: CarKind) -> Mesh:
    """A car of a kind, centred on the origin, nose to +x."""
    return _mesh(kind).moved((-kind.profile_m[-1][0] / 2, 0.0, 0.0))


def car_skin(kind: CarKind, rng: np.random.Generator) -> Skin:
    """What one car of a kind looks like."""
    return Skin(paint_car(np.array(kind.profile_m), kind.belt_m, kind.axles_m, rng), specular=0.5)


def body(kind: CarKind, rng: np.random.Generator) -> tuple[Mesh, Skin]:
    """Mesh and skin without wheels, for one that moves, with its lamps on at night."""
    profile = np.array(kind.profile_m)
    image = paint_car(profile, kind.belt_m, kind.axles_m, rng)
    skin = Skin(image, specular=0.5, glow=car_lamp_glow(image))
    whole = merged([_hull(kind), _underside(kind)])
    return whole.moved((-profile[-1, 0] / 2, 0.0, 0.0)), skin


def varied(kind: CarKind, rng: np.random.Generator) -> CarKind:
    """A make of a kind: a little longer or shorter, higher or lower than another."""
    long, high = rng.uniform(0.93, 1.02), rng.uniform(0.95, 1.06)
    return CarKind(
        tuple((x * long, z * high) for x, z in kind.profile_m),
        kind.belt_m * high,
        (kind.axles_m[0] * long, kind.axles_m[1] * long),
        kind.width_m,
    )


def outline_m(kind: CarKind) -> tuple[float, float]:
    """Length and width."""
    return kind.profile_m[-1][0], kind.width_m


def _mesh(kind: CarKind) -> Mesh:
    return merged([_hull(kind), *_wheels(kind), _underside(kind)])


def _hull(kind: CarKind) -> Mesh:
    rings = np.array([_ring(x, z, kind) for x, z in kind.profile_m])
    a, b = rings[:-1], rings[1:]
    corners = np.stack([a[:, :-1], b[:, :-1], b[:, 1:], a[:, 1:]], axis=2).reshape(-1, 4, 3)
    ends = []
    for ring, order in ((rings[0], slice(None)), (rings[-1], slice(None, None, -1))):
        for k in range(len(ring) // 2):
            quad = np.array([ring[k], ring[k + 1], ring[-2 - k], ring[-1 - k]])
            ends.append(quad[order])
    hull = np.concatenate([corners, np.array(ends)])
    return quads(hull, _project(hull))


def _ring(x: float, top: float, kind: CarKind) -> list[tuple[float, float, float]]:
    """Cross-section from the right sill over the roof to the left sill."""
    half = kind.width_m / 2
    taper = 1.0 - 0.10 * (abs(x / kind.profile_m[-1][0] - 0.5) * 2) ** 4
    belt = min(top, kind.belt_m)
    roof = half * (0.97 if top <= kind.belt_m else 0.97 - 0.34 * (top - kind.belt_m))
    right = [
        (half * 0.94, 0.2),
        (half, 0.55 * min(1.0, belt)),
        (half * 0.98, belt - 0.04),
        (roof * 0.98, top - 0.02),
        (roof * 0.85, top),
    ]
    right = [(y * taper, z) for y, z in right]
    left = [(-y, z) for y, z in reversed(right)]
    return [(x, -y, z) for y, z in right] + [(x, -y, z) for y, z in left]


def _project(hull: Array) -> Array:
    """Texture coordinates by the side that a quad faces most."""
    normals = np.cross(hull[:, 2] - hull[:, 0], hull[:, 3] - hull[:, 1])
    facing = np.argmax(np.abs(normals) * [0.8, 1.0, 1.0], axis=1)
    x, y, z = hull[..., 0], hull[..., 1], hull[..., 2]
    ahead = normals[:, :1] > 0
    side = np.stack([SIDE_AT_M[0] + x, SIDE_AT_M[1] + TALL_M - z], axis=-1)
    top = np.stack([TOP_AT_M[0] + x, TOP_AT_M[1] + WIDE_M / 2 - y], axis=-1)
    nose = np.stack([FRONT_AT_M[0] + WIDE_M / 2 + y, FRONT_AT_M[1] + TALL_M - z], axis=-1)
    tail = np.stack([REAR_AT_M[0] + WIDE_M / 2 - y, REAR_AT_M[1] + TALL_M - z], axis=-1)
    ends = np.where(ahead[..., None], nose, tail)
    chosen = np.where((facing == 0)[:, None, None], ends, np.where((facing == 1)[:, None, None], side, top))
    result: Array = chosen / np.array(SIZE_M)
    return result


def _wheels(kind: CarKind) -> list[Mesh]:
    parts = []
    rim, black = rect(WHEEL_AT_M, (2 * WHEEL_M, 2 * WHEEL_M)), rect(BLACK_AT_M, (0.5, 0.8))
    half = kind.width_m / 2
    for axle in kind.axles_m:
        for side in (-1, 1):
            flat = disc((0, 0, 0), WHEEL_M, 14, rim).moved(yaw_rad=side * np.pi / 2)
            parts.append(flat.moved((axle, side * (half + 0.005), WHEEL_M)))
            y0, y1 = sorted((side * (half - 0.01), side * (half - 0.22)))
            parts.append(box((axle - 0.15, y0, 0.0), (axle + 0.15, y1, 0.5), black))
    return parts


def _underside(kind: CarKind) -> Mesh:
    black, half = rect(BLACK_AT_M, (0.5, 0.8)), kind.width_m / 2
    return box((0.3, -half + 0.25, 0.15), (kind.profile_m[-1][0] - 0.3, half - 0.25, 0.4), black)
