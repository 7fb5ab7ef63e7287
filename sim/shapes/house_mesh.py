"""A whole house: relief on the walls that are seen, plain walls elsewhere, a foundation, and the roof."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.shapes.facade import FLANK_M, Facade
from sim.shapes.mesh import Mesh, merged, quads
from sim.shapes.relief import wall_mesh
from sim.shapes.roof import roof_mesh

ROOF_M = 5.0  # width of the texture's part with roof tiles, plain wall and dormers
FOUNDATION_M = 2.0  # how far walls go down, so that a house can stand on a slope


def atlas_width_m(facade: Facade) -> float:
    """Width of the texture: front, flanks, roof side by side."""
    return facade.walls_m + ROOF_M


def house_mesh(
    facade: Facade, front_m: Array, back_m: Array, relief_m: float, seen: tuple[bool, bool] = (False, False)
) -> Mesh:
    """Build a house around its front.

    Args:
        facade: Plan of the house.
        front_m: (2, 2) world xy of the left and right front corner, seen from the street.
        back_m: (2, 2) the corners behind them.
        relief_m: Panels nearer to the wall than this stay in it.
        seen: Whether the left and the right side wall face a street, and so have relief as well.
    """
    (left, right), (left_back, right_back) = np.asarray(front_m, float), np.asarray(back_m, float)
    total = atlas_width_m(facade)
    front_u = (0.0, facade.width_m / total)
    walls_u = facade.walls_m / total
    size = (facade.width_m, facade.height_m)
    walls = [wall_mesh(facade.panels, size, left, right, relief_m, front_u)]
    plain = 10.0  # no panel stands out as far: the wall stays flat
    sides = ((left_back, left, seen[0]), (right, right_back, seen[1]), (right_back, left_back, False))
    for k, (a, b, is_seen) in enumerate(sides):
        relief, start_m = relief_m if is_seen else plain, facade.flank_m(k)
        u = (start_m / total + 0.002, (start_m + FLANK_M) / total - 0.002)
        plan = facade.flanks[k % len(facade.flanks)]
        walls.append(wall_mesh(plan, (FLANK_M, facade.height_m), a, b, relief, u))
    outline = np.array([left, right, right_back, left_back])
    return merged(
        [
            *walls,
            _foundation(outline, (front_u[0], walls_u - 0.002)),
            _backing(facade, outline, front_u[1] * 0.5),
            roof_mesh(facade, outline, (walls_u + 0.002, 0.999)),
        ]
    )


def _foundation(outline: Array, u: tuple[float, float]) -> Mesh:
    """Walls below the ground floor, with the texture's lowest rows."""
    corners = [
        [(*a, -FOUNDATION_M), (*b, -FOUNDATION_M), (*b, 0.0), (*a, 0.0)]
        for a, b in zip(outline, np.roll(outline, -1, axis=0), strict=True)
    ]
    part = np.array([[u[0], 0.999], [u[1], 0.999], [u[1], 0.95], [u[0], 0.95]])
    return quads(np.array(corners), np.repeat(part[None], len(corners), axis=0))


def _backing(facade: Facade, outline: Array, u: float) -> Mesh:
    """A dark wall just behind the front, which closes hairline gaps of the relief."""
    left, right, right_back, left_back = outline
    a, b = left + 0.09 * (left_back - left), right + 0.09 * (right_back - right)
    corners = [[(*a, 0.0), (*b, 0.0), (*b, facade.height_m), (*a, facade.height_m)]]
    return quads(np.array(corners), np.full((1, 4, 2), [u, 0.02]))
