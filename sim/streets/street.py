"""A procedurally generated street: drawn by seed, laid out by rules, built from plain textured meshes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import mujoco
import numpy as np
from pydantic import Field, ValidationInfo, field_validator

from estimator.config import Config
from estimator.se3 import Array
from sim.streets.furnishing import furnish
from sim.streets.ground import build_ground
from sim.streets.houses import build_houses
from sim.streets.kinds import CLOSED_KINDS, Ground, check_length, draw_network
from sim.streets.lamps import Lamp
from sim.streets.lot import Facades
from sim.streets.lots import draw_lots
from sim.streets.network import Network, driven_line_m
from sim.streets.scenery import Scenery, write_scenery
from sim.traffic.config import TrafficConfig

TALL_KINDS = ("canyon",)


class StreetConfig(Config):
    """Which street, and how long."""

    kind: Literal[
        "straight",
        "bend",
        "t_junction",
        "crossroads",
        "roundabout",
        "loop",
        "motorway",
        "tunnel",
        "car_park",
        "suburb",
        "canyon",
    ] = "bend"
    length_m: float = Field(
        70.0, ge=20.0, le=1500.0, validate_default=True
    )  # that can be driven; once round, of a closed kind
    facades: Facades = "varied"
    parking: float = Field(0.6, ge=0.0, le=1.0)  # share of the bays that are taken
    vegetation: float = Field(1.0, ge=0.0, le=1.0)  # share of the plants that grow
    slope_percent: float = Field(0.0, ge=0.0, le=15.0)  # the steepest that is driven over
    speed_bumps: float = Field(0.0, ge=0.0, le=10.0)  # per 100 m
    roughness: float = Field(0.0, ge=0.0, le=5.0)  # 1 to 5: ISO 8608 classes A to E
    traffic: TrafficConfig = TrafficConfig()

    @field_validator("length_m")
    @classmethod
    def _has_room_for_its_kind(cls, length_m: float, info: ValidationInfo) -> float:
        if "kind" in info.data:  # else that is refused
            check_length(info.data["kind"], length_m)
        return length_m

    @property
    def is_closed(self) -> bool:
        """Whether the car may drive round for ever."""
        return self.kind in CLOSED_KINDS


@dataclass(frozen=True, eq=False)
class Street:
    """A street ready to be driven and drawn.

    Attributes:
        centerline_m: (N, 2) world xy of the driven lane, from the origin along +x, 0.25 m apart.
        network: Where roads, kerbs and lanes run, and how high.
        scenery: Everything in it.
        lamps: What of it shines at night.
    """

    centerline_m: Array
    network: Network
    scenery: Scenery
    lamps: tuple[Lamp, ...]

    def write_into(self, spec: mujoco.MjSpec) -> None:
        """Add textures, materials, meshes and geoms; nothing of it collides."""
        write_scenery(spec, self.scenery)


def draw_roads(
    config: StreetConfig, rng: np.random.Generator
) -> tuple[Network, Sequence[np.random.Generator]]:
    """Draw the roads of a street; also return the four generators of what else there is to it."""
    plan, ground, plots, houses, things, relief = rng.spawn(6)
    asked = Ground(config.slope_percent, config.speed_bumps, config.roughness)
    network = draw_network(config.kind, config.length_m, asked, plan, relief)
    return network, (ground, plots, houses, things)


def build_street(config: StreetConfig, rng: np.random.Generator) -> Street:
    """Draw and build a street; the same generator state gives the same street."""
    network, (ground, plots, houses, things) = draw_roads(config, rng)
    driven_m = driven_line_m(network.route, config.length_m)
    lots = draw_lots(network, config.facades, plots)
    built = build_houses(lots, config.facades, config.kind in TALL_KINDS, network.relief, driven_m, houses)
    furniture, lamps = furnish(network, lots, driven_m, config.parking, config.vegetation, things)
    return Street(driven_m, network, build_ground(network, ground) + built + furniture, lamps)
