"""Networks, drives and outlines that the tests of traffic share."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from estimator.se3 import Array
from sim.streets.footprint import gap_m, rectangle_m
from sim.streets.kinds import Ground, draw_network
from sim.streets.network import driven_line_m
from sim.streets.scenery import NOTHING
from sim.traffic.config import TrafficConfig
from sim.traffic.planned import traffic_of
from sim.traffic.traffic import Traffic
from sim.vehicle.drive import DriveConfig
from sim.vehicle.plan import SpeedPlan, plan_speed
from sim.vehicle.route import Route, backwards_from, route_along

LENGTHS_M = {"loop": 200.0, "roundabout": 100.0, "motorway": 120.0, "car_park": 100.0}
ACROSS_M = {"cyclist": 0.56, "pedestrian": 0.5}  # handlebar, shoulders


@dataclass(frozen=True, eq=False)
class Drive:
    """A street with its traffic, and where the driven car means to be."""

    traffic: Traffic
    route: Route
    plan: SpeedPlan
    backwards: bool

    def ego_outline_m(self, time_s: float) -> Array:
        along = self.plan.distance_m(time_s)
        sign = -1.0 if self.backwards else 1.0
        ahead = sign * self.route.direction(along)
        middle = self.route.point_m(along) + 1.22 * ahead
        return rectangle_m(middle, float(np.arctan2(ahead[1], ahead[0])), 4.4, 1.68)

    def outlines_m(self, time_s: float) -> dict[str, Array]:
        found = {"ego": self.ego_outline_m(time_s)}
        for troupe in self.traffic.troupes:
            if not troupe.models:
                continue
            stance = troupe.stance(time_s)
            for k, model in enumerate(troupe.models):
                across = ACROSS_M.get(troupe.name, model.track_m + 0.27)
                at, yaw = stance.origins_m[k, :2], float(stance.yaws_rad[k])
                found[f"{troupe.name}_{k}"] = rectangle_m(at, yaw, model.length_m, across)
        return found


def drive_through(kind: str, traffic: TrafficConfig, drive: DriveConfig, seed: int = 0) -> Drive:
    """Draw a street of a kind and its traffic."""
    length_m = LENGTHS_M.get(kind, 80.0)
    plan_rng, relief_rng = np.random.default_rng(seed).spawn(2)
    network = draw_network(kind, length_m, Ground(), plan_rng, relief_rng)
    route = route_along(driven_line_m(network.route, length_m), network.route.closed)
    crowd = traffic_of(traffic, network, NOTHING, drive, route, seed)
    driven = backwards_from(route, drive.distance_m) if drive.reverse else route
    return Drive(crowd, driven, plan_speed(drive, driven), drive.reverse)


def overlapping(outlines_m: dict[str, Array]) -> list[tuple[str, str]]:
    """Pairs of outlines that overlap."""
    names, outlines = list(outlines_m), list(outlines_m.values())
    middles = np.array([outline.mean(axis=0) for outline in outlines])
    reach = np.array([np.linalg.norm(o - m, axis=1).max() for o, m in zip(outlines, middles, strict=True)])
    away = np.linalg.norm(middles[:, None] - middles[None], axis=2)
    near = np.argwhere(np.triu(away < reach[:, None] + reach[None], 1))
    return [(names[i], names[j]) for i, j in near if gap_m(outlines[i], outlines[j]) < 0]
