"""Who drives where: town buses stay in town, and what is heavy keeps out of the fast lanes."""

from __future__ import annotations

import pytest

from sim.shapes.heavy import BUS, TRUCK
from sim.traffic.config import TrafficConfig
from sim.traffic.fleet import CAR_KINDS, fit_for
from sim.vehicle.drive import DriveConfig
from tests.traffic_streets import drive_through


def test_all_kinds_drive_in_town() -> None:
    assert fit_for(13.0) == list(range(len(CAR_KINDS)))


@pytest.mark.parametrize(("speed_mps", "lorries"), [(24.0, True), (29.0, False), (34.0, False)])
def test_lorries_keep_right_and_town_buses_away(speed_mps: float, lorries: bool) -> None:
    kinds = [CAR_KINDS[k] for k in fit_for(speed_mps)]
    assert BUS not in kinds
    assert (TRUCK in kinds) == lorries


def test_no_town_bus_is_on_a_motorway() -> None:
    bus = CAR_KINDS.index(BUS)
    drive = drive_through("motorway", TrafficConfig(cars=5), DriveConfig(speed_mps=25.0, distance_m=100.0))
    cast = [model.name for troupe in drive.traffic.troupes for model in troupe.models]
    assert cast and f"vehicle_{bus}" not in cast
