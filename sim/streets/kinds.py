"""Every kind of street there is, and the network of one."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sim.streets.network import Network, driven_line_m
from sim.streets.plan import Plan, network_of
from sim.streets.relief import Relief, draw_hills, draw_roughness
from sim.streets.town_streets import plan_bend, plan_crossroads, plan_straight

PLANS: dict[str, Callable[[float, np.random.Generator], Plan]] = {
    "straight": plan_straight,
    "bend": plan_bend,
    "crossroads": plan_crossroads,
}


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
    hills, rough = relief_rng.spawn(2)
    line = driven_line_m(plan.route, length_m)
    relief = Relief(draw_hills(ground.slope_percent, line, hills), draw_roughness(ground.roughness, rough))
    return network_of(plan, relief)
