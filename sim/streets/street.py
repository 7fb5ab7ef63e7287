"""A procedurally generated street: drawn by seed, laid out by rules, built from plain textured meshes."""

from __future__ import annotations

import copy
from dataclasses import dataclass
from typing import Literal

import mujoco
import numpy as np
from pydantic import Field

from estimator.config import Config
from estimator.se3 import Array
from sim.streets.furnishing import furnish
from sim.streets.ground import build_ground
from sim.streets.houses import build_houses, draw_lots
from sim.streets.kinds import Ground, draw_network
from sim.streets.layout import draw_layout
from sim.streets.network import Network, driven_line_m
from sim.streets.scenery import Scenery, write_scenery


class StreetConfig(Config):
    """Which street, and how long."""

    kind: Literal["straight", "bend", "crossroads"] = "bend"
    length_m: float = Field(70.0, ge=20.0, le=300.0)
    slope_percent: float = Field(0.0, ge=0.0, le=15.0)  # the steepest that is driven over
    roughness: float = Field(0.0, ge=0.0, le=5.0)  # 1 to 5: ISO 8608 classes A to E


@dataclass(frozen=True, eq=False)
class Street:
    """A street ready to be driven and drawn.

    Attributes:
        centerline_m: (N, 2) world xy of the driven lane, from the origin along +x, 0.25 m apart.
        network: Where roads, kerbs and lanes run, and how high.
        scenery: Everything in it.
    """

    centerline_m: Array
    network: Network
    scenery: Scenery

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add textures, materials, meshes and geoms; nothing of it collides."""
        write_scenery(spec, self.scenery)


def build_street(config: StreetConfig, rng: np.random.Generator) -> Street:
    """Draw and build a street; the same generator state gives the same street."""
    plan, ground, plots, houses, things, relief = rng.spawn(6)
    asked = Ground(config.slope_percent, 0.0, config.roughness)
    layout = draw_layout(config.length_m, copy.deepcopy(plan))
    network = draw_network(config.kind, config.length_m, asked, plan, relief)
    lots = draw_lots(layout, plots)
    scenery = (
        build_ground(network, ground) + build_houses(layout, lots, houses) + furnish(layout, lots, things)
    )
    return Street(driven_line_m(network.route, config.length_m), network, scenery)
