"""What a kind of street draws, and the network that follows from it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from sim.streets.bumps import place_bumps
from sim.streets.junctions import Joint, join
from sim.streets.kerb import kerb_lines, walled
from sim.streets.lane_rules import bike_lanes, foot_lanes, road_bays
from sim.streets.network import Bay, Lane, Network, Tunnel
from sim.streets.path import Path
from sim.streets.relief import Relief, Waves
from sim.streets.road import Road

CORNER_M = 5.2  # radius of kerbs at junctions: wider than any pavement, so that facade lines do not fold


@dataclass(frozen=True, eq=False)
class Plan:
    """The drawn part of a network.

    Attributes:
        roads: With their paths and cross-sections; mouths, spans and zebras of joints are added later.
        joints: How they meet.
        route: The driven lane's centre; through the origin along +x at s = 0.
        lanes: Car lanes; those for bicycles and people follow from roads and kerbs.
        corner_m: Radius of kerbs at junctions; 0 for none.
        bays: Parking places besides those along kerbs.
        tunnels: Covered stretches.
    """

    roads: tuple[Road, ...]
    joints: tuple[Joint, ...]
    route: Path
    lanes: tuple[Lane, ...]
    corner_m: float = CORNER_M
    bays: tuple[Bay, ...] = ()
    tunnels: tuple[Tunnel, ...] = ()


def network_of(
    plan: Plan, length_m: float, hills: Waves, rough: Waves, bumps_per_100_m: float, rng: np.random.Generator
) -> Network:
    """Derive surfaces, kerbs, lanes and bays; ``rng`` decides where speed bumps are."""
    roads, junctions, carriageway = join(plan.roads, plan.joints, plan.corner_m)
    roads, bumps = place_bumps(roads, plan.route, length_m, bumps_per_100_m, rng)
    relief = Relief(hills, rough, bumps)
    kerbs = kerb_lines(carriageway, roads, plan.corner_m)
    for tunnel in plan.tunnels:
        kerbs = walled(kerbs, next(road for road in roads if road.name == tunnel.road), tunnel.span_m)
    ridden = [road for road in roads if road.style in ("street", "minor")]
    begun = {joint.arm for joint in plan.joints}
    arms = [road for road in ridden if road.name in begun]
    bikes = bike_lanes([road for road in ridden if road.name not in begun], arms, plan.lanes)
    lanes = (*plan.lanes, *bikes, *foot_lanes(kerbs))
    bays = (*plan.bays, *(bay for road in roads for bay in road_bays(road)))
    return Network(roads, junctions, kerbs, lanes, bays, plan.route, carriageway, relief, plan.tunnels)
