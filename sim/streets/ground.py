"""The ground of a street: carriageways at z = 0, raised pavements with kerbs, yards behind, land around."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from estimator.se3 import Array
from sim.paint.canvas import Canvas, RgbImage
from sim.paint.markings import paint_main_road, paint_side_road
from sim.paint.noise import fractal
from sim.paint.road import RoadCanvas, asphalt
from sim.shapes.mesh import merged, quads
from sim.streets.layout import KERB_M, Layout
from sim.streets.path import Path
from sim.streets.pavements import build_pavements, strip
from sim.streets.scenery import Prop, Scenery, Skin

_PIECE_TEXELS = 2000
_OVERLAP_TEXELS = 48  # keeps the wrap-around of filtering out of sight


def build_ground(layout: Layout, rng: np.random.Generator) -> Scenery:
    """Everything one can stand or drive on."""
    streams = rng.spawn(4)
    return (
        _carriageways(layout, streams[0]) + build_pavements(layout, streams[1]) + _yards(layout, streams[2])
    )


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
        mesh = strip(
            path, s_m, np.full_like(s_m, road.top_m), np.full_like(s_m, bottom_m), 0.0, u, (0.001, 0.999)
        )
        skin = f"{name}_{k}"
        scenery += Scenery((Prop(skin, mesh, skin),), {skin: Skin(image[:, low:high].copy())})
    return scenery


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
                strip(
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
