"""The ground of a street: everything one can stand or drive on, draped over its relief."""

from __future__ import annotations

import numpy as np

from sim.streets.carriageways import build_carriageways
from sim.streets.land import build_land
from sim.streets.network import Network
from sim.streets.pavements import build_pavements
from sim.streets.scenery import Scenery


def build_ground(network: Network, rng: np.random.Generator) -> Scenery:
    """Carriageways, raised pavements with kerbs, and the land around."""
    roads, paving, land = rng.spawn(3)
    return (
        build_carriageways(network, roads)
        + build_pavements(network.kerbs, network.relief, paving)
        + build_land(network, land)
    )
