"""Carriageways: no gap between what is driven on and the kerbs around it."""

import numpy as np
import pytest
from shapely import STRtree, points
from shapely.geometry import Polygon

from sim.streets.carriageways import build_carriageways
from sim.streets.kinds import Ground, draw_network


@pytest.mark.parametrize("kind", ("bend", "crossroads"))
def test_the_ground_reaches_under_every_kerb(kind: str) -> None:
    plan, relief = np.random.default_rng(3).spawn(2)
    network = draw_network(kind, 40.0, Ground(), plan, relief)
    ground = build_carriageways(network, np.random.default_rng(4))
    triangles = STRtree(
        [Polygon(xy) for prop in ground.props for xy in prop.mesh.vertices_m[:, :2][prop.mesh.faces]]
    )
    for kerb in network.kerbs:
        s_m = np.arange(kerb.path.start_m + 0.6, kerb.path.end_m - 0.6, 0.13)
        at = points(kerb.path.point_m(s_m, 0.006))
        covered = np.unique(triangles.query(at, predicate="intersects")[0])
        assert len(covered) == len(s_m), s_m[np.setdiff1d(np.arange(len(s_m)), covered)]
