"""The traffic that belongs to a drive: it knows where the driven car means to be in its lane."""

from __future__ import annotations

from sim.streets.network import Network
from sim.streets.scenery import Scenery
from sim.traffic.casting import build_traffic
from sim.traffic.config import TrafficConfig
from sim.traffic.traffic import NOBODY, Traffic
from sim.vehicle.drive import DriveConfig
from sim.vehicle.plan import plan_speed
from sim.vehicle.route import Route, backwards_from


def traffic_of(
    config: TrafficConfig,
    network: Network,
    standing: Scenery,
    drive: DriveConfig,
    route: Route,
    seed: int,
) -> Traffic:
    """Draw the traffic around a drive.

    Args:
        config: How much of it.
        network: Of the street.
        standing: What stands in it.
        drive: What is asked of the drive.
        route: What the car drives, in the direction of its lane.
        seed: Everything random follows from it.
    """
    if config.is_empty:
        return NOBODY
    plan = plan_speed(drive, backwards_from(route, drive.distance_m) if drive.reverse else route)
    # Laps are counted in lengths of the lane's own path, which differs from the route's by its sampling.
    stretch = network.route.length_m / route.length_m if route.closed else 1.0

    def progress_m(time_s: float) -> float:
        driven_m = plan.distance_m(time_s)
        return stretch * (drive.distance_m - driven_m if drive.reverse else driven_m)

    outlines_m = [prop.footprint_m for prop in standing.props if prop.footprint_m is not None]
    return build_traffic(config, network, outlines_m, progress_m, drive.speed_mps, seed)
