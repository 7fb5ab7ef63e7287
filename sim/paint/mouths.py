"""What is painted where roads meet: give-way lines, and gutters that follow the kerb round a corner."""

from __future__ import annotations

import numpy as np

from estimator.se3 import Array
from sim.paint.markings import GUTTER_M
from sim.paint.road import PAINT, RoadCanvas


def paint_teeth(road: RoadCanvas, teeth_m: Array) -> None:
    """Triangles of a give-way line; (N, 3, 2) in the canvas's street coordinates."""
    for tooth in teeth_m:
        road.canvas.fill(np.array([road.at(*corner) for corner in tooth]), PAINT, 0.92, road.worn)


def pave_edge(road: RoadCanvas, line_m: Array) -> None:
    """A gutter of setts along a kerb that is not straight; (N, 2) in the canvas's street coordinates."""
    points = np.array([road.at(*point) for point in line_m])
    road.canvas.stroke(points, 2 * GUTTER_M, (140, 138, 133), 0.9)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    for s in np.arange(0.0, along[-1], 0.19):
        at = np.array([np.interp(s, along, points[:, axis]) for axis in (0, 1)])
        ahead = np.array([np.interp(s + 0.1, along, points[:, axis]) for axis in (0, 1)]) - at
        across = np.array([-ahead[1], ahead[0]]) / max(float(np.linalg.norm(ahead)), 1e-6)
        joint = np.array([at - GUTTER_M * across, at + GUTTER_M * across])
        road.canvas.stroke(joint, 0.025, (92, 90, 88), 0.8)
