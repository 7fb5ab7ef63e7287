"""The ground of a street: carriageways at z = 0, raised pavements with kerbs, yards behind, land around."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from estimator.se3 import Array
from sim.scenery import Prop, Scenery, Skin
from sim.street_layout import LANE_M, Junction, Layout
from sim.street_mesh import Mesh, merged, quads
from sim.street_path import Path
from sim.textures_canvas import Canvas, RgbImage
from sim.textures_markings import paint_main_road, paint_side_road
from sim.textures_noise import fractal
from sim.textures_paving import pavement
from sim.textures_road import RoadCanvas, asphalt

KERB_M = 0.12
PAVING_TEXEL_M = (0.025, 0.016)
YARD_M = 16.0
_PIECE_TEXELS = 2000
_OVERLAP_TEXELS = 48  # keeps the wrap-around of filtering out of sight


def build_ground(layout: Layout, rng: np.random.Generator) -> Scenery:
    """Everything one can stand or drive on."""
    streams = rng.spawn(4)
    return _carriageways(layout, streams[0]) + _pavements(layout, streams[1]) + _yards(layout, streams[2])


def _carriageways(layout: Layout, rng: np.random.Generator) -> Scenery:
    path, section, junction = layout.path, layout.section, layout.junction
    main = asphalt(path.start_m, path.end_m, section.kerb_right_m, section.kerb_left_m, rng)
    paint_main_road(main, layout, rng)
    edge = abs(section.kerb_m(junction.side))
    half = junction.half_width_m + junction.corner_m
    side = asphalt(edge, junction.path.end_m, -half, half, rng)
    paint_side_road(side, layout, rng)
    return _road_pieces("road", main, path) + _road_pieces("side_road", side, junction.path)


def _road_pieces(name: str, road: RoadCanvas, path: Path) -> Scenery:
    """Cut the long painting into textures of moderate size, each with a margin around what is shown."""
    image, scenery = road.canvas.image(), Scenery((), {})
    texel, width = road.canvas.texel_m[0], image.shape[1]
    bottom_m = road.top_m - image.shape[0] * road.canvas.texel_m[1]
    for k, start in enumerate(range(0, width, _PIECE_TEXELS)):
        stop = min(start + _PIECE_TEXELS, width)
        low, high = max(0, start - _OVERLAP_TEXELS), min(width, stop + _OVERLAP_TEXELS)
        s_m = road.start_m + texel * np.linspace(start, stop, max(2, round((stop - start) * texel)))
        u = ((s_m - road.start_m) / texel - low) / (high - low)
        mesh = _strip(
            path, s_m, np.full_like(s_m, road.top_m), np.full_like(s_m, bottom_m), 0.0, u, (0.001, 0.999)
        )
        skin = f"{name}_{k}"
        scenery += Scenery((Prop(skin, mesh, skin),), {skin: Skin(image[:, low:high].copy())})
    return scenery


def _strip(
    path: Path, s_m: Array, d_top_m: Array, d_bottom_m: Array, z_m: float, u: Array, v: tuple[float, float]
) -> Mesh:
    """A band along a path that faces up; v runs from its left edge to its right one."""
    left, right = path.point_m(s_m, d_top_m), path.point_m(s_m, d_bottom_m)
    corners = np.stack([right[:-1], right[1:], left[1:], left[:-1]], axis=1)
    corners = np.concatenate([corners, np.full((*corners.shape[:2], 1), z_m)], axis=2)
    low, high = np.full(len(u), v[0]), np.full(len(u), v[1])
    uv_left, uv_right = np.stack([u, low], 1), np.stack([u, high], 1)
    return quads(corners, np.stack([uv_right[:-1], uv_right[1:], uv_left[1:], uv_left[:-1]], axis=1))


def _pavements(layout: Layout, rng: np.random.Generator) -> Scenery:
    """Pavements along both streets; the kerb follows the corners of the junction."""
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
    flat = _strip(path, s_m, top, bottom, KERB_M, u, (0.0, 1.0))
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


def _yards(layout: Layout, rng: np.random.Generator) -> Scenery:
    """Grass, earth and gravel behind the facade lines, and plain land to the horizon."""
    meshes, path = [], layout.path
    s_m = np.arange(path.start_m, path.end_m, 2.0)
    u = (s_m - path.start_m) / (path.end_m - path.start_m)
    first, last = layout.mouth_m
    for side in (1, -1):
        front = layout.section.front_m(side)
        for part in _outside(s_m, first, last) if side == layout.junction.side else [s_m]:
            edges = sorted((front, front + side * 3.5))
            inside = np.interp(part, s_m, u)
            meshes.append(
                _strip(
                    path,
                    part,
                    np.full_like(part, edges[1]),
                    np.full_like(part, edges[0]),
                    KERB_M - 0.01,
                    inside,
                    (0.02, 0.2),
                )
            )
    skin = Skin(_yard_image(rng))
    land = quads(
        np.array([[(-350, -350, -0.06), (350, -350, -0.06), (350, 350, -0.06), (-350, 350, -0.06)]]),
        np.array([[(0, 1), (1, 1), (1, 0.3), (0, 0.3)]]),
    )
    return Scenery((Prop("yards", merged(meshes), "yards"), Prop("land", land, "yards")), {"yards": skin})


def _outside(s_m: Array, first: float, last: float) -> Iterable[Array]:
    return s_m[s_m < first], s_m[s_m > last]


def _yard_image(rng: np.random.Generator) -> RgbImage:
    canvas = Canvas(120.0, 30.0, (0.06, 0.06), (92, 98, 62))
    mud = fractal(rng, canvas.shape, canvas.cells(3.0), 6, 0.8)
    canvas.shade(0.2 * fractal(rng, canvas.shape, canvas.cells(0.5), 4, 0.9))
    canvas.pixels += (mud > 0.4)[..., None] * np.array([38, 12, 18], np.float32)
    return canvas.image()


__all__ = ["KERB_M", "LANE_M", "build_ground"]
