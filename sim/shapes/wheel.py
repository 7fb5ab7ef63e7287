"""A wheel with its tyre, turning about y; it wears the skin of the vehicle it belongs to."""

from __future__ import annotations

import numpy as np

from sim.shapes.loft import Section, loft
from sim.shapes.mesh import Mesh, Rect, disc, merged


def wheel_mesh(radius_m: float, width_m: float, face: Rect, rubber: Rect) -> Mesh:
    """Tread and both faces.

    Args:
        radius_m: Of the tyre.
        width_m: Of the tyre.
        face: Part of the texture with the rim and the side of the tyre.
        rubber: Part of the texture for the tread.
    """
    half, edge = width_m / 2, 0.94 * radius_m
    sections: list[Section] = [
        (-half, 0.0, 0.0, edge, edge),
        (-0.7 * half, 0.0, 0.0, radius_m, radius_m),
        (0.7 * half, 0.0, 0.0, radius_m, radius_m),
        (half, 0.0, 0.0, edge, edge),
    ]
    tread = loft(sections, 20, rubber, axis="x")
    flat = disc((0.0, 0.0, 0.0), edge, 20, face)
    faces = [flat.moved((half, 0.0, 0.0)), flat.moved(yaw_rad=np.pi).moved((-half, 0.0, 0.0))]
    return merged([tread, *faces]).moved(yaw_rad=np.pi / 2)
