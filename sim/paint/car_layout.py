"""Where on the texture of a car its side, top, ends and wheels are painted."""

from __future__ import annotations

from sim.shapes.mesh import Rect

SIZE_M = (8.0, 4.2)  # of the texture
SIDE_AT_M = (0.1, 0.05)  # where parts begin; x runs from tail to nose, y down from 2.2 m above the road
TOP_AT_M = (0.1, 2.3)
FRONT_AT_M, REAR_AT_M, WHEEL_AT_M, BLACK_AT_M = (5.3, 0.05), (5.3, 2.3), (7.25, 0.1), (7.25, 3.0)
TALL_M, WIDE_M, WHEEL_M = 2.2, 1.9, 0.33


def rect(at_m: tuple[float, float], size_m: tuple[float, float]) -> Rect:
    """Part of the texture as texture coordinates."""
    return (
        at_m[0] / SIZE_M[0],
        at_m[1] / SIZE_M[1],
        (at_m[0] + size_m[0]) / SIZE_M[0],
        (at_m[1] + size_m[1]) / SIZE_M[1],
    )
