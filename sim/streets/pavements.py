"""Raised pavements with kerbs along both streets; at the junction the kerb follows the corners."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.paving import pavement
from sim.shapes.mesh import Mesh, merged, quads
from sim.streets.layout import KERB_M, Junction, Layout
from sim.streets.path import Path
from sim.streets.scenery import Prop, Scenery, Skin

PAVING_TEXEL_M = (0.025, 0.016)


def build_pavements(layout: Layout, rng: np.random.Generator) -> Scenery:
    """Pavements along both streets."""
    scenery = Scenery((), {})
    path, junction = layout.path, layout.junction
    first, last = layout.mouth_m
    for side in (1, -1):
        kerb, front = layout.section.kerb_m(side), layout.section.front_m(side)
        if side != junction.side:
            spans = [_plain_span(path.start_m, path.end_m, kerb, front)]
        else:
            spans = [
                _corner_span(path.start_m, first, kerb, front, junction, 1),
                _corner_span(path.end_m, last, kerb, front, junction, -1),
            ]
        for k, (s_m, kerb_m, front_m) in enumerate(spans):
            scenery += _pavement_piece(
                f"pavement_{'left' if side > 0 else 'right'}_{k}", path, s_m, kerb_m, front_m, rng
            )
    start = abs(layout.section.kerb_m(junction.side)) + junction.corner_m
    for side in (1, -1):
        section = junction.section
        span = _plain_span(start, junction.path.end_m, section.kerb_m(side), section.front_m(side))
        scenery += _pavement_piece(
            f"side_pavement_{'left' if side > 0 else 'right'}", junction.path, *span, rng
        )
    return scenery


def _plain_span(start_m: float, end_m: float, kerb_m: float, front_m: float) -> tuple[Array, Array, Array]:
    s_m = np.linspace(start_m, end_m, max(2, round(end_m - start_m)))
    return s_m, np.full_like(s_m, kerb_m), np.full_like(s_m, front_m)


def _corner_span(
    far_m: float, mouth_m: float, kerb_m: float, front_m: float, junction: Junction, step: int
) -> tuple[Array, Array, Array]:
    """From a far end to the mouth and round the corner; ``step`` +1 where the mouth lies ahead in s."""
    radius, sign = junction.corner_m, np.sign(kerb_m)
    plain = np.linspace(far_m, mouth_m, max(2, round(abs(mouth_m - far_m))))
    angles = np.linspace(0, np.pi / 2, 9)[1:]
    s_m = np.concatenate([plain, mouth_m + step * radius * np.sin(angles)])
    kerbs = np.concatenate([np.full(len(plain), kerb_m), kerb_m + sign * radius * (1 - np.cos(angles))])
    outer = np.full(len(s_m), front_m)
    outer[len(plain) - 1 :] = kerb_m + sign * max(radius, abs(front_m - kerb_m))
    order = slice(None, None, step)
    return s_m[order], kerbs[order], outer[order]


def _pavement_piece(
    name: str, path: Path, s_m: Array, kerb_m: Array, front_m: Array, rng: np.random.Generator
) -> Scenery:
    """One pavement with the wall of its kerb."""
    width = float(np.max(np.abs(front_m - kerb_m)))
    left = bool(np.mean(front_m) > np.mean(kerb_m))
    canvas = pavement(float(s_m[-1] - s_m[0]), width, PAVING_TEXEL_M, not left, rng)
    u = (s_m - s_m[0]) / (s_m[-1] - s_m[0])
    share = np.abs(front_m - kerb_m) / width
    top, bottom = (front_m, kerb_m) if left else (kerb_m, front_m)
    v = np.stack([1 - share, np.ones_like(u)], 1) if left else np.stack([np.zeros_like(u), share], 1)
    flat = strip(path, s_m, top, bottom, KERB_M, u, (0.0, 1.0))
    flat.uvs[:, 1] = np.stack([v[:-1, 1], v[1:, 1], v[1:, 0], v[:-1, 0]], axis=1).ravel()
    wall = _kerb_wall(path, s_m, kerb_m, u, left)
    return Scenery((Prop(name, merged([flat, wall]), name),), {name: Skin(canvas.image())})


def _kerb_wall(path: Path, s_m: Array, kerb_m: Array, u: Array, left: bool) -> Mesh:
    """The upright face of the kerb stones, seen from the road."""
    line = path.point_m(s_m, kerb_m)
    a, b = (line[1:], line[:-1]) if left else (line[:-1], line[1:])
    ua, ub = (u[1:], u[:-1]) if left else (u[:-1], u[1:])
    low, high = np.zeros((len(a), 1)), np.full((len(a), 1), KERB_M)
    corners = np.stack(
        [np.hstack([b, low]), np.hstack([a, low]), np.hstack([a, high]), np.hstack([b, high])], axis=1
    )
    v_low, v_high = (0.995, 0.93) if left else (0.005, 0.07)
    lows, highs = np.full(len(a), v_low), np.full(len(a), v_high)
    return quads(
        corners,
        np.stack(
            [
                np.stack([ub, lows], 1),
                np.stack([ua, lows], 1),
                np.stack([ua, highs], 1),
                np.stack([ub, highs], 1),
            ],
            axis=1,
        ),
    )


def strip(
    path: Path, s_m: Array, d_top_m: Array, d_bottom_m: Array, z_m: float, u: Array, v: tuple[float, float]
) -> Mesh:
    """A band along a path that faces up; v runs from its left edge to its right one."""
    left, right = path.point_m(s_m, d_top_m), path.point_m(s_m, d_bottom_m)
    corners = np.stack([right[:-1], right[1:], left[1:], left[:-1]], axis=1)
    corners = np.concatenate([corners, np.full((*corners.shape[:2], 1), z_m)], axis=2)
    low, high = np.full(len(u), v[0]), np.full(len(u), v[1])
    uv_left, uv_right = np.stack([u, low], 1), np.stack([u, high], 1)
    return quads(corners, np.stack([uv_right[:-1], uv_right[1:], uv_left[1:], uv_left[:-1]], axis=1))
