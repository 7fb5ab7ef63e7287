"""Covered stretches of roads: lining, portals, the ground above, and the lamps under the ceiling."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from estimator.se3 import Array
from sim.paint.tunnel import LAMP_EVERY_M, lamp_rows_m, paint_lining, paint_portal
from sim.shapes.mesh import Mesh, quads
from sim.shapes.sweep import along_section, sweep
from sim.streets.kerb import TUNNEL_WALK_M
from sim.streets.lamps import Lamp
from sim.streets.network import Network, Tunnel
from sim.streets.road import Road
from sim.streets.scenery import NOTHING, Prop, Scenery, Skin

_PIECE_M = 12.0
_WING_M, _OVER_M = 8.0, 2.6  # of the portal's wall, beside and above the opening
_FOOT_M = -0.3  # walls go this far into the ground


def build_tunnels(network: Network, rng: np.random.Generator) -> tuple[Scenery, list[Lamp]]:
    """Build all covered stretches of a network."""
    scenery, lamps = NOTHING, []
    for k, (tunnel, stream) in enumerate(zip(network.tunnels, rng.spawn(len(network.tunnels)), strict=True)):
        road = network.road(tunnel.road)
        scenery += _lining(f"tunnel_{k}", tunnel, road, network, stream)
        scenery += _portals(f"portal_{k}", tunnel, road, network, stream)
        lamps += _lamps(tunnel, road, network)
    return scenery, lamps


def _section(tunnel: Tunnel, road: Road) -> Array:
    """(4, 2) from the foot of the left wall over the ceiling to the foot of the right one."""
    left, right = road.left_m + TUNNEL_WALK_M, road.right_m - TUNNEL_WALK_M
    return np.array([(left, _FOOT_M), (left, tunnel.height_m), (right, tunnel.height_m), (right, _FOOT_M)])


def _lining(name: str, tunnel: Tunnel, road: Road, network: Network, rng: np.random.Generator) -> Scenery:
    section = _section(tunnel, road)
    start, end = tunnel.span_m
    edges = np.linspace(start, end, max(1, round((end - start) / _PIECE_M)) + 1)
    scenery = NOTHING
    for k, (low, high) in enumerate(pairwise(edges)):
        line = _line(road, low, high, network)
        mesh = sweep(line, section, np.linspace(0, 1, len(line)), along_section(section))
        wall, width = tunnel.height_m - _FOOT_M, section[1, 0] - section[2, 0]
        image = paint_lining(high - low, wall, width, low - start, rng)
        scenery += Scenery((Prop(f"{name}_{k}", mesh, f"{name}_{k}"),), {f"{name}_{k}": Skin(image)})
    return scenery


def _line(road: Road, low: float, high: float, network: Network) -> Array:
    """(N, 3) points of the road's path on the ground."""
    xy = road.path.point_m(np.linspace(low, high, max(2, round((high - low) / 2.0) + 1)))
    return np.column_stack([xy, network.relief.height_m(xy)])


def _portals(name: str, tunnel: Tunnel, road: Road, network: Network, rng: np.random.Generator) -> Scenery:
    """A wall with an opening at each end, and a roof between them that keeps the sun out."""
    section, high = _section(tunnel, road), tunnel.height_m + _OVER_M
    left, right = section[0, 0], section[-1, 0]
    outer = (left + _WING_M, right - _WING_M)
    width = outer[0] - outer[1]
    image = paint_portal(width, _OVER_M, tunnel.height_m - 0.3, rng)
    props = []
    for k, (s, ahead) in enumerate(zip(tunnel.span_m, (-1, 1), strict=True)):
        spots = [(outer[0], left, _FOOT_M), (left, right, tunnel.height_m), (right, outer[1], _FOOT_M)]
        corners, uvs = [], []
        for a, b, foot in spots:
            a, b = (a, b) if ahead < 0 else (b, a)
            ground = float(network.relief.height_m(road.path.point_m(s)))
            xy = road.path.point_m(s + 0.02 * ahead, np.array([a, b]))
            corners.append(
                [
                    (*xy[0], ground + foot),
                    (*xy[1], ground + foot),
                    (*xy[1], ground + high),
                    (*xy[0], ground + high),
                ]
            )
            u = [(outer[0] - d) / width if ahead < 0 else (d - outer[1]) / width for d in (a, b)]
            v = min((high - foot) / _OVER_M, 3.0)
            uvs.append([(u[0], v), (u[1], v), (u[1], 0.0), (u[0], 0.0)])
        props.append(Prop(f"{name}_{k}", quads(np.array(corners), np.array(uvs)), name))
    return Scenery(
        (*props, Prop(f"{name}_roof", _roof(road, tunnel, outer, high, network), name)), {name: Skin(image)}
    )


def _roof(road: Road, tunnel: Tunnel, outer: tuple[float, float], high: float, network: Network) -> Mesh:
    line = _line(road, *tunnel.span_m, network)
    section = np.array([(outer[1], _FOOT_M), (outer[1], high), (outer[0], high), (outer[0], _FOOT_M)])
    return sweep(line, section, np.linspace(0, 4, len(line)), np.array([0.0, 0.05, 0.9, 1.0]))


def _lamps(tunnel: Tunnel, road: Road, network: Network) -> list[Lamp]:
    section = _section(tunnel, road)
    width = section[1, 0] - section[2, 0]
    found = []
    for s in np.arange(tunnel.span_m[0] + LAMP_EVERY_M / 2, tunnel.span_m[1], LAMP_EVERY_M):
        for row in lamp_rows_m(width):
            x, y = road.path.point_m(s, section[1, 0] - row)
            z = float(network.relief.height_m(road.path.point_m(s))) + tunnel.height_m - 0.05
            found.append(Lamp((float(x), float(y), z), (0.0, 0.0, -1.0), "tunnel"))
    return found
