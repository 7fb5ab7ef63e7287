"""What a kind of street draws, and the network that follows from it."""

from __future__ import annotations

from dataclasses import dataclass

from sim.streets.junctions import Joint, join
from sim.streets.kerb import Lining, kerb_lines
from sim.streets.network import Lane, Network, bike_lanes, foot_lanes, road_bays
from sim.streets.path import Path
from sim.streets.relief import Relief
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
        lining: What stands along kerbs.
        corner_m: Radius of kerbs at junctions; 0 for none.
        kerb_m: Height of kerbs.
    """

    roads: tuple[Road, ...]
    joints: tuple[Joint, ...]
    route: Path
    lanes: tuple[Lane, ...]
    lining: Lining = "houses"
    corner_m: float = CORNER_M
    kerb_m: float = 0.12


def network_of(plan: Plan, relief: Relief) -> Network:
    """Derive surfaces, kerbs, lanes and bays."""
    roads, junctions, carriageway = join(plan.roads, plan.joints, plan.corner_m)
    kerbs = kerb_lines(carriageway, roads, plan.corner_m, plan.lining, plan.kerb_m)
    bikes = [lane for road in roads if road.style in ("street", "minor") for lane in bike_lanes(road)]
    lanes = (*plan.lanes, *bikes, *foot_lanes(kerbs))
    bays = tuple(bay for road in roads for bay in road_bays(road))
    return Network(roads, junctions, kerbs, lanes, bays, plan.route, carriageway, relief)
