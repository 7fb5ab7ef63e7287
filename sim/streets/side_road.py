"""Side streets: a lane each way, no parking, their path in the middle."""

from __future__ import annotations

import numpy as np

from sim.streets.path import Path, straight_path
from sim.streets.road import Road, Strip

SIDE_DEPTH_M = 46.0


def side_road(
    name: str, main: Road, s_m: float, side: int, half_m: float, depth_m: float = SIDE_DEPTH_M
) -> Road:
    """A side street at right angles to a road, from that road's path outwards."""
    heading = float(main.path.heading_rad(s_m)) + side * np.pi / 2
    return minor_road(name, straight_path(main.path.point_m(s_m), heading, depth_m), half_m)


def minor_road(name: str, path: Path, half_m: float) -> Road:
    """A side street along a path, half as wide as ``half_m`` says on each side."""
    strips = (Strip(-half_m / 2, True, half_m), Strip(half_m / 2, False, half_m))
    return Road(name, "minor", path, half_m, -half_m, strips, (path.start_m, path.end_m), (2.4, 2.4))
