"""Raised pavements with their kerbs, and verges, along every kerb line."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.paving import pavement, verge
from sim.shapes.mesh import Mesh, merged
from sim.streets.drape import band, grid_faces
from sim.streets.kerb import KerbLine
from sim.streets.relief import Relief
from sim.streets.scenery import NOTHING, Prop, Scenery, Skin

PAVING_TEXEL_M = (0.025, 0.016)
_VERGE_TEXEL_M = (0.05, 0.04)
_LAID_AT_ONCE_M = 60.0
_BURIED_M = 0.04  # how far kerb stones reach below the carriageway


def build_pavements(kerbs: tuple[KerbLine, ...], relief: Relief, rng: np.random.Generator) -> Scenery:
    """The ground from every kerb to where the lots begin."""
    scenery = NOTHING
    for k, (kerb, stream) in enumerate(zip(kerbs, rng.spawn(len(kerbs)), strict=True)):
        if kerb.lining == "wall" and kerb.pavement_m <= 0:
            continue
        count = max(1, round(kerb.path.length_m / _LAID_AT_ONCE_M))
        edges = np.linspace(kerb.path.start_m, kerb.path.end_m, count + 1)
        for j, one in enumerate(stream.spawn(count)):
            scenery += _piece(f"pavement_{k}_{j}", kerb, float(edges[j]), float(edges[j + 1]), relief, one)
    return scenery


def _piece(
    name: str, kerb: KerbLine, start_m: float, end_m: float, relief: Relief, rng: np.random.Generator
) -> Scenery:
    """One stretch of pavement with the wall of its kerb."""
    width = kerb.pavement_m
    if kerb.height_m > 0:
        canvas = pavement(end_m - start_m, width, PAVING_TEXEL_M, rng, kerb.wear)
    else:
        canvas = verge(end_m - start_m, width, _VERGE_TEXEL_M, rng)
    s_m = _samples(kerb, start_m, end_m)
    u = (s_m - start_m) / (end_m - start_m)
    across = np.linspace(0.0, 1.0, 2 if relief.is_flat else int(width) + 2)
    uvs = np.stack(np.broadcast_arrays(u[:, None], across), axis=-1)

    def top_of(xy: Array) -> Array:
        return relief.height_m(xy) + kerb.height_m

    meshes = [band(kerb.path.point_m, s_m, width * (1 - across), top_of, uvs)]
    if kerb.height_m > 0:
        meshes.append(_kerb_wall(kerb, s_m, relief, u))
    return Scenery((Prop(name, merged(meshes), name),), {name: Skin(canvas.image())})


def _samples(kerb: KerbLine, start_m: float, end_m: float) -> Array:
    """Every metre, and densely where the kerb is curved."""
    coarse = np.linspace(start_m, end_m, max(2, round(end_m - start_m) + 1))
    fine = np.linspace(start_m, end_m, max(2, round(4 * (end_m - start_m)) + 1))
    return np.union1d(coarse, fine[np.abs(kerb.path.curvature_1pm(fine, 2.0)) > 0.02])


def _kerb_wall(kerb: KerbLine, s_m: Array, relief: Relief, u: Array) -> Mesh:
    """The upright face of the kerb stones, seen from the carriageway."""
    line = kerb.path.point_m(s_m)
    ground, heading = relief.height_m(line), kerb.path.heading_rad(s_m)
    low, high = ground - (0.0 if relief.is_flat else _BURIED_M), ground + kerb.height_m
    vertices = np.stack([np.column_stack([line, high]), np.column_stack([line, low])], axis=1)
    outward = np.stack([np.sin(heading), -np.cos(heading), np.zeros(len(s_m))], axis=1)
    uvs = np.stack([np.column_stack([u, 0 * u + 0.93]), np.column_stack([u, 0 * u + 0.995])], axis=1)
    return Mesh(
        vertices.reshape(-1, 3),
        np.repeat(outward, 2, axis=0),
        uvs.reshape(-1, 2),
        grid_faces(len(s_m), 2),
    )
