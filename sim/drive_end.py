"""When a drive ends, known from its roads alone: what is to begin later is refused before they are built."""

from __future__ import annotations

from sim.faults.fault import PassingFault
from sim.seeds import rng_for
from sim.some_cameras import check_begins
from sim.streets.network import driven_line_m
from sim.streets.street import draw_roads
from sim.vehicle.motion import in_order_of_travel
from sim.vehicle.plan import plan_speed
from sim.vehicle.route import route_along
from sim.world import WorldConfig


def check_times(config: WorldConfig, seed: int) -> None:
    """Refuse what begins after the drive's end.

    Raises:
        InputError: A mounting's event or a fault does.
    """
    begins_s = {
        f"miscalibration.events[{i}]": each.at_s for i, each in enumerate(config.miscalibration.events)
    }
    begins_s |= {
        f"faults[{i}]": each.at_s for i, each in enumerate(config.faults) if isinstance(each, PassingFault)
    }
    fastest_s = config.drive.distance_m / config.drive.speed_mps
    if max(begins_s.values(), default=0.0) <= fastest_s:
        return  # no drive ends sooner, so its roads need not be drawn
    end_s = duration_s(config, seed)
    for key, at_s in begins_s.items():
        check_begins(key, at_s, end_s)


def duration_s(config: WorldConfig, seed: int) -> float:
    """Return how long the drive of a seed takes, as its driver plans it."""
    network, _ = draw_roads(config.street, rng_for(seed, "street"))
    route = route_along(driven_line_m(network.route, config.street.length_m), network.route.closed)
    return plan_speed(config.drive, in_order_of_travel(config.drive, route)).duration_s
