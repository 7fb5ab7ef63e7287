"""A procedurally generated street: drawn by seed, laid out by rules, built from plain textured meshes."""

from __future__ import annotations

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
from sim.streets.layout import Layout, draw_layout, lane_centerline_m
from sim.streets.scenery import Scenery, write_scenery


class StreetConfig(Config):
    """Which street, and how long."""

    kind: Literal["bend"] = "bend"
    length_m: float = Field(70.0, ge=20.0, le=300.0)


@dataclass(frozen=True, eq=False)
class Street:
    """A street ready to be driven and drawn.

    Attributes:
        centerline_m: (N, 2) world xy of the driven lane, from the origin along +x, 0.25 m apart.
        layout: The plan it was built from.
        scenery: Everything in it.
    """

    centerline_m: Array
    layout: Layout
    scenery: Scenery

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add textures, materials, meshes and geoms; nothing of it collides."""
        write_scenery(spec, self.scenery)


def build_street(config: StreetConfig, rng: np.random.Generator) -> Street:
    """Draw and build a street; the same generator state gives the same street."""
    plan, ground, plots, houses, things = rng.spawn(5)
    layout = draw_layout(config.length_m, plan)
    lots = draw_lots(layout, plots)
    scenery = (
        build_ground(layout, ground) + build_houses(layout, lots, houses) + furnish(layout, lots, things)
    )
    return Street(lane_centerline_m(layout), layout, scenery)
