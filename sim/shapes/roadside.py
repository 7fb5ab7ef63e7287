"""Guard rails, noise walls, gantries and marker posts along a motorway."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.roadside import BAY_M, BOARD_M, RAIL_M
from sim.shapes.mesh import Mesh, box, merged, quads
from sim.shapes.sweep import along_section, sweep

# Left of the line and above it, for a rail seen from the right: a beam with two ribs on posts.
_BEAM_M = np.array(
    [(0.0, 0.43), (-0.08, 0.5), (-0.08, 0.56), (0.0, 0.6), (-0.08, 0.64), (-0.08, 0.7), (0.0, 0.76)]
)
_POST_REACH_M = 0.14
GANTRY_CLEAR_M, GANTRY_POST_M = 5.4, 0.5


def guard_rail(line_m: Array, start_m: float, both_sides: bool) -> Mesh:
    """A steel beam on posts along a line.

    Args:
        line_m: (N, 3) points on the ground, evenly spaced.
        start_m: How far along the whole rail this piece begins, for its texture and its posts.
        both_sides: Whether it has a beam towards the left as well.
    """
    length = float(np.linalg.norm(np.diff(line_m[:, :2], axis=0), axis=1).sum())
    u = (start_m + np.linspace(0, length, len(line_m))) / RAIL_M
    v = 1.0 - along_section(_BEAM_M)
    mirrored = _BEAM_M[::-1] * [-1.0, 1.0] + [2 * _POST_REACH_M, 0.0]
    back = mirrored if both_sides else _BEAM_M[::-1] + np.array([0.01, 0.0])
    beams = [sweep(line_m, _BEAM_M, u, v), sweep(line_m, back, u, v[::-1])]
    posts = []
    for at in np.arange(-(start_m % BAY_M) + BAY_M / 2, length, BAY_M):
        index = min(int(at / length * (len(line_m) - 1)), len(line_m) - 2)
        ahead = line_m[index + 1, :2] - line_m[index, :2]
        yaw = float(np.arctan2(ahead[1], ahead[0]))
        post = box((-0.06, 0.02, -0.3), (0.06, _POST_REACH_M, 0.7), (0.0, 0.4, 0.005, 0.6))
        posts.append(post.moved(tuple(line_m[index]), yaw))
    return merged([*beams, *posts])


def noise_wall(line_m: Array, height_m: float) -> Mesh:
    """An upright wall along a line, seen from both sides, with its posts standing out."""
    u = np.linspace(0, 1, len(line_m))
    front = np.array([(0.0, -0.4), (0.0, height_m)])
    back = np.array([(0.14, height_m), (0.14, -0.4)])
    top = np.array([(0.0, height_m), (0.14, height_m)])
    parts = [
        sweep(line_m, front, u, np.array([1.0, 0.0])),
        sweep(line_m, back, u, np.array([0.0, 1.0])),
        sweep(line_m, top, u, np.array([0.0, 0.01])),
    ]
    length = float(np.linalg.norm(np.diff(line_m[:, :2], axis=0), axis=1).sum())
    for at in np.arange(0.0, length, BAY_M):
        index = min(int(at / length * (len(line_m) - 1)), len(line_m) - 2)
        ahead = line_m[index + 1, :2] - line_m[index, :2]
        share = at / length
        post = box(
            (-0.09, -0.09, -0.4), (0.09, 0.2, height_m + 0.06), (share, 0.2, share + 0.1 / length, 0.9)
        )
        posts = post.moved(tuple(line_m[index]), float(np.arctan2(ahead[1], ahead[0])))
        parts.append(posts)
    return merged(parts)


def gantry_frame(low_m: float, high_m: float, middles_m: Array) -> Mesh:
    """Two posts and a lattice beam across a road that carry boards; x ahead, y from one post to the other."""
    steel, top = (0.0, 0.05, 0.2, 0.3), GANTRY_CLEAR_M + BOARD_M[1]
    half = GANTRY_POST_M / 2
    parts = [box((-half, y - half, -0.4), (half, y + half, top), steel) for y in (low_m, high_m)]
    for z in (GANTRY_CLEAR_M + 0.6, top - 0.5):
        parts.append(box((0.12, low_m, z), (0.3, high_m, z + 0.16), steel))
    for y in np.arange(low_m, high_m, 1.6):
        parts.append(box((0.16, y, GANTRY_CLEAR_M + 0.6), (0.26, y + 0.1, top - 0.5), steel))
    for y in middles_m:  # the backs of the boards
        low, high = y - BOARD_M[0] / 2 + 0.06, y + BOARD_M[0] / 2 - 0.06
        parts.append(box((0.02, low, GANTRY_CLEAR_M), (0.08, high, top), steel))
    return merged(parts)


def gantry_boards(middles_m: Array) -> Mesh:
    """Boards that are read from -x, side by side across a road; their middles in metres left of its path."""
    count = len(middles_m)
    corners, uvs = [], []
    for k, y in enumerate(middles_m):
        low, high, z0, z1 = (
            y - BOARD_M[0] / 2 + 0.06,
            y + BOARD_M[0] / 2 - 0.06,
            GANTRY_CLEAR_M,
            GANTRY_CLEAR_M + BOARD_M[1],
        )
        corners.append([(0.0, high, z0), (0.0, low, z0), (0.0, low, z1), (0.0, high, z1)])
        uvs.append([(k / count, 1.0), ((k + 1) / count, 1.0), ((k + 1) / count, 0.0), (k / count, 0.0)])
    return quads(np.array(corners), np.array(uvs))


def marker_post() -> Mesh:
    """A post that shows its face, reflector and all, towards -x and +x."""
    return merged(
        [
            box((-0.06, -0.05, -0.2), (0.06, 0.05, 0.98), (0.0, 0.0, 1.0, 1.0)),
            box((-0.05, -0.04, 0.98), (0.05, 0.04, 1.02), (0.1, 0.0, 0.9, 0.02)),
        ]
    )
