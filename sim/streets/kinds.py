"""Every kind of street there is, and the network of one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sim.streets.car_park import plan_car_park
from sim.streets.motorway import plan_motorway
from sim.streets.network import Network, driven_line_m
from sim.streets.plan import Plan, network_of
from sim.streets.relief import draw_hills, draw_roughness
from sim.streets.roundabout import plan_roundabout
from sim.streets.town_streets import (
    plan_bend,
    plan_canyon,
    plan_crossroads,
    plan_straight,
    plan_suburb,
    plan_tunnel,
)
from sim.streets.turning_streets import plan_loop, plan_t_junction

PLANS: dict[str, Callable[[float, np.random.Generator], Plan]] = {
    "straight": plan_straight,
    "bend": plan_bend,
    "crossroads": plan_crossroads,
    "t_junction": plan_t_junction,
    "roundabout": plan_roundabout,
    "loop": plan_loop,
    "motorway": plan_motorway,
    "tunnel": plan_tunnel,
    "car_park": plan_car_park,
    "suburb": plan_suburb,
    "canyon": plan_canyon,
}


CLOSED_KINDS = ("loop", "car_park")  # whose route comes back to where it began
SHORTEST_M = {
    "straight": (20.0, "the drive"),
    "bend": (20.0, "the drive"),
    "crossroads": (35.0, "the first crossing"),
    "t_junction": (50.0, "the way to the junction and round the turn"),
    "roundabout": (70.0, "the way to the roundabout and round it"),
    "loop": (200.0, "once round a block with houses inside"),
    "motorway": (50.0, "the drive"),
    "tunnel": (50.0, "daylight, the tunnel, and daylight again"),
    "car_park": (90.0, "once round the bays of two aisles"),
    "suburb": (20.0, "the drive"),
    "canyon": (20.0, "the drive"),
}
LONGEST_M = {"motorway": 1500.0, "car_park": 300.0}  # what is painted of them fits into memory
LONGEST_TOWN_M = 800.0


def check_length(kind: str, length_m: float) -> None:
    """Refuse a length in which a kind cannot be built.

    Raises:
        ValueError: What was got, what was wanted and why.
    """
    shortest, why = SHORTEST_M[kind]
    longest = LONGEST_M.get(kind, LONGEST_TOWN_M)
    reason = f"below it has no room for {why}" if length_m < shortest else "beyond it takes too much memory"
    if not shortest <= length_m <= longest:
        raise ValueError(
            f"got {length_m:g}, wanted {shortest:g} to {longest:g} for a street of kind {kind}; {reason}"
        )


@dataclass(frozen=True)
class Ground:
    """What is asked of the ground; see ``StreetConfig``."""

    slope_percent: float = 0.0
    speed_bumps: float = 0.0
    roughness: float = 0.0


def draw_network(
    kind: str,
    length_m: float,
    ground: Ground,
    plan_rng: np.random.Generator,
    relief_rng: np.random.Generator,
) -> Network:
    """Draw the network of a street.

    Args:
        kind: One of ``PLANS``.
        length_m: How far one can drive, or round a closed route once.
        ground: What the ground is like; changes nothing but heights, and marks at speed bumps.
        plan_rng: Decides where roads run.
        relief_rng: Decides where hills, bumps and unevenness are.
    """
    plan = PLANS[kind](length_m, plan_rng)
    hills_rng, rough_rng, bumps_rng = relief_rng.spawn(3)
    hills = draw_hills(ground.slope_percent, driven_line_m(plan.route, length_m), hills_rng)
    rough = draw_roughness(ground.roughness, rough_rng)
    return network_of(plan, length_m, hills, rough, ground.speed_bumps, bumps_rng)
