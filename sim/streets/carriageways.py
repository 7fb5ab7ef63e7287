"""The surfaces that are driven on: plain strips painted along their roads, and what lies between them."""

from __future__ import annotations

import numpy as np
from shapely import contains_xy

from estimator.se3 import Array
from sim.paint.markings import paint_road
from sim.paint.mouths import paint_teeth, pave_edge
from sim.paint.road import RoadCanvas, asphalt
from sim.streets.drape import area, band
from sim.streets.network import Junction, Network
from sim.streets.relief import BUMP_FLANK_M, BUMP_LENGTH_M, Relief
from sim.streets.road import Road
from sim.streets.scenery import NOTHING, Prop, Scenery, Skin

_PIECE_TEXELS = 2000
_OVERLAP_TEXELS = 48  # keeps the wrap-around of filtering out of sight
_PAVED_AT_ONCE_M = 200.0  # a longer road is paved in sections, which bounds the memory that painting takes
_UNDER_M = 0.06  # how far the surface of a junction reaches under the strips around it
_SUNK_M = 0.002
_UNDER_KERB_M = 0.1  # else hairlines open where the kerb and what it bounds are curved differently


def build_carriageways(network: Network, rng: np.random.Generator) -> Scenery:
    """Everything that is driven on, draped over the relief."""
    scenery = NOTHING
    of_roads, of_junctions = rng.spawn(2)
    for road, stream in zip(network.roads, of_roads.spawn(len(network.roads)), strict=True):
        scenery += _road(road, network.relief, stream)
    for k, (junction, stream) in enumerate(
        zip(network.junctions, of_junctions.spawn(len(network.junctions)), strict=True)
    ):
        scenery += _junction(f"junction_{k}", junction, network, stream)
    return scenery


def _road(road: Road, relief: Relief, rng: np.random.Generator) -> Scenery:
    start, end = road.span_m
    sections = max(1, int(np.ceil((end - start) / _PAVED_AT_ONCE_M)))
    edges = np.linspace(start, end, sections + 1)
    scenery = NOTHING
    for k, stream in enumerate(rng.spawn(sections)):
        ground, marks = stream.spawn(2)
        canvas = asphalt(
            float(edges[k]), float(edges[k + 1]), road.right_m, road.left_m, ground, road.texel_m, road.wear
        )
        paint_road(canvas, road, marks)
        scenery += _pieces(f"road_{road.name}_{k}", canvas, road, relief)
    return scenery


def _pieces(name: str, canvas: RoadCanvas, road: Road, relief: Relief) -> Scenery:
    """Cut a long painting into textures of moderate size, each with a margin around what is shown."""
    image, scenery = canvas.canvas.image(), NOTHING
    texel, width = canvas.canvas.texel_m[0], image.shape[1]
    bottom_m = canvas.top_m - image.shape[0] * canvas.canvas.texel_m[1]
    for k, start in enumerate(range(0, width, _PIECE_TEXELS)):
        stop = min(start + _PIECE_TEXELS, width)
        low, high = max(0, start - _OVERLAP_TEXELS), min(width, stop + _OVERLAP_TEXELS)
        s_m = _samples(canvas.start_m + texel * start, canvas.start_m + texel * stop, road, relief)
        d_m = _columns(canvas.top_m, bottom_m, road, relief)
        across = np.clip((canvas.top_m - d_m) / (canvas.top_m - bottom_m), 0.0, 1.0)
        u = ((s_m - canvas.start_m) / texel - low) / (high - low)
        uvs = np.stack(np.broadcast_arrays(u[:, None], 0.001 + 0.998 * across), axis=-1)
        skin = f"{name}_{k}"
        mesh = band(road.path.point_m, s_m, d_m, relief.road_height_m, uvs)
        scenery += Scenery((Prop(skin, mesh, skin),), {skin: Skin(image[:, low:high].copy())})
    return scenery


def _samples(start_m: float, end_m: float, road: Road, relief: Relief) -> Array:
    """Where a strip has vertices along it: dense on speed bumps."""
    s_m = np.linspace(start_m, end_m, max(2, round((end_m - start_m) / _step(relief)) + 1))
    for bump in road.bumps_m:
        fine = bump + np.linspace(-0.5, 0.5, 33) * BUMP_LENGTH_M
        s_m = np.union1d(s_m, fine[(fine > start_m) & (fine < end_m)])
    return s_m


def _columns(left_m: float, right_m: float, road: Road, relief: Relief) -> Array:
    """Where a strip has vertices across, from left to right: also where the flanks of bumps begin and end."""
    count = 1 if relief.is_flat else int((left_m - right_m) / _step(relief)) + 1
    d_m = np.linspace(right_m, left_m, count + 1)
    if road.bumps_m:
        right, left = road.bump_edges_m
        d_m = np.union1d(d_m, [right, right + BUMP_FLANK_M, left - BUMP_FLANK_M, left])
    if road.kerb_m > 0:
        d_m = np.concatenate([[d_m[0] - _UNDER_KERB_M], d_m, [d_m[-1] + _UNDER_KERB_M]])
    return np.asarray(d_m[::-1])


def _step(relief: Relief) -> float:
    return 0.35 if relief.is_rough else 1.0


def _junction(name: str, junction: Junction, network: Network, rng: np.random.Generator) -> Scenery:
    c, s = np.cos(junction.yaw_rad), np.sin(junction.yaw_rad)
    turn = np.array([[c, -s], [s, c]])  # world xy @ turn: along the road, left of it
    kerbed = any(road.kerb_m > 0 for road in network.roads)
    limit = network.carriageway.buffer(_UNDER_KERB_M if kerbed else 0.0)
    outline = junction.outline.buffer(_UNDER_M, join_style="mitre").intersection(limit)
    local = np.asarray(junction.outline.exterior.coords) @ turn
    (x0, y0), (x1, y1) = local.min(axis=0) - 0.5, local.max(axis=0) + 0.5
    canvas = asphalt(float(x0), float(x1), float(y0), float(y1), rng, wear=junction.wear)
    paint_teeth(canvas, junction.teeth_m @ turn)
    for kerb in network.kerbs:
        near = kerb.path.points_m[contains_xy(junction.outline.buffer(0.2), *kerb.path.points_m.T)]
        if len(near) > 2:
            pave_edge(canvas, near @ turn)

    def uv_of(xy: Array) -> Array:
        return np.asarray((xy @ turn - [x0, y1]) / [x1 - x0, y0 - y1])

    def height_of(xy: Array) -> Array:
        return network.relief.road_height_m(xy) - _SUNK_M

    mesh = area(outline, _step(network.relief), height_of, uv_of)
    return Scenery((Prop(name, mesh, name),), {name: Skin(canvas.canvas.image())})
