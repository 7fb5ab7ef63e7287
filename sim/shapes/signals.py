"""Traffic lights on posts, read from +x."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture_parts import region
from sim.shapes.furniture import pole
from sim.shapes.mesh import Mesh, box, merged, quads, rect_uvs

HEAD_M = (0.32, 0.96)


def signal_post(green: bool) -> Mesh:
    """A post with the lamps for cars above and those for people on foot, across, at half height."""
    face = "signal_green" if green else "signal_red"
    walk = signal_head("signal_walk", 0.64).moved(yaw_rad=np.pi / 2).moved((0.0, 0.0, 1.95))
    return merged([pole(3.5, (0.06, 0.05)), signal_head(face, HEAD_M[1]).moved((0.0, 0.0, 2.5)), walk])


def signal_head(face: str, height_m: float) -> Mesh:
    """A housing with hoods over its lamps, before the z axis, its foot at z = 0."""
    half, x = HEAD_M[0] / 2, 0.26
    case = box((0.06, -half, 0.0), (x, half, height_m), region("green"))
    front = np.array([[(x, -half, 0), (x, half, 0), (x, half, height_m), (x, -half, height_m)]])
    parts = [case, quads(front + np.array([0.004, 0, 0]), rect_uvs(region(face))[None])]
    count = round(height_m / 0.32)
    for k in range(count):
        top = (k + 1) * height_m / count - 0.035
        parts.append(box((x, -0.12, top), (x + 0.16, 0.12, top + 0.02), region("green")))
    return merged(parts)
