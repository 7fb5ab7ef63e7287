"""What belongs in a car park: a shelter with shopping trolleys, a machine for tickets."""

from __future__ import annotations

import numpy as np

from sim.paint.furniture_parts import region
from sim.shapes.mesh import Mesh, box, merged, quads, rect_uvs


def shelter() -> Mesh:
    """A roof on four columns with glass along one long side; x along it."""
    steel = region("steel")
    columns = [
        box((x - 0.05, y - 0.05, 0.0), (x + 0.05, y + 0.05, 2.2), steel)
        for x in (-1.7, 1.7)
        for y in (-0.5, 0.5)
    ]
    roof = box((-1.85, -0.68, 2.2), (1.85, 0.68, 2.34), region("green"))
    below = np.array([[(-1.84, 0.67, 2.2), (1.84, 0.67, 2.2), (1.84, -0.67, 2.2), (-1.84, -0.67, 2.2)]])
    panes = [box((x, 0.46, 0.25), (x + 1.08, 0.5, 1.95), region("glass")) for x in (-1.65, -0.54, 0.57)]
    return merged([*columns, roof, quads(below, rect_uvs(steel)[None]), *panes])


def trolleys() -> Mesh:
    """A row of trolleys pushed into each other, along x."""
    wire = region("trolley")
    parts = []
    for x in np.arange(-1.4, 1.2, 0.28):
        parts.append(box((x, -0.24, 0.45), (x + 0.26, 0.24, 0.95 + 0.04 * (x % 0.5)), wire))
        parts.append(box((x, -0.22, 0.1), (x + 0.05, 0.22, 0.45), region("steel")))
    return merged(parts)


def ticket_machine() -> Mesh:
    """A machine on a plinth with a sign above it, its front towards +x."""
    return merged(
        [
            box((-0.3, -0.35, 0.0), (0.3, 0.35, 0.12), region("concrete")),
            box((-0.2, -0.3, 0.12), (0.2, 0.3, 1.6), region("ticket"), region("steel")),
            box((-0.03, -0.03, 1.6), (0.03, 0.03, 2.3), region("steel")),
            box((-0.04, -0.3, 2.3), (0.04, 0.3, 2.9), region("ticket")),
        ]
    )
