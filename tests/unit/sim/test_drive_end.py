"""What begins after the drive's end is refused, and the end is known before anything is built."""

from __future__ import annotations

from typing import Any

import pytest

from estimator.errors import InputError
from scenarios.load import load_scenario
from sim.drive_end import check_times, duration_s
from sim.seeds import rng_for
from sim.streets.street import build_street
from sim.vehicle.car import CarConfig
from sim.vehicle.motion import Motion
from sim.vehicle.route import route_along
from sim.world import WorldConfig

DROPPED = {"kind": "dropped", "camera": "rear"}
KNOCK = {"kind": "knock", "camera": "rear", "rotation_deg": 1.0}


def world(faults: list[dict[str, Any]], events: list[dict[str, Any]], **more: Any) -> WorldConfig:
    drive = {"distance_m": 15.0, "speed_mps": 5.0}
    return WorldConfig.model_validate(
        {"drive": drive, "faults": faults, "miscalibration": {"events": events}} | more
    )


def test_a_fault_that_begins_after_the_drive_is_refused_with_path_and_range() -> None:
    with pytest.raises(
        InputError, match=r"^faults\[1\]\.at_s: got 3\.5, wanted 0 to 3\.\d\d, when the drive"
    ):
        check_times(world([DROPPED, DROPPED | {"at_s": 3.5}], []), 0)


def test_an_event_that_begins_after_the_drive_is_refused_with_path_and_range() -> None:
    with pytest.raises(
        InputError, match=r"^miscalibration\.events\[0\]\.at_s: got 99, wanted 0 to 3\.\d\d, "
    ):
        check_times(world([], [KNOCK | {"at_s": 99.0}]), 0)


def test_what_begins_within_the_drive_is_taken_without_drawing_a_road(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("sim.drive_end.draw_roads", None)
    check_times(world([DROPPED | {"at_s": 3.0}], [KNOCK | {"at_s": 2.0}]), 0)


def test_a_drive_that_stops_lasts_longer() -> None:
    slow = {"drive": {"distance_m": 15.0, "speed_mps": 5.0, "profile": "pull_away"}}
    check_times(world([DROPPED | {"at_s": 4.0}], [], **slow), 0)


@pytest.mark.parametrize("reverse", [False, True])
def test_the_end_is_that_of_the_drive_in_the_street_as_built(reverse: bool) -> None:
    bend = {"distance_m": 60.0, "speed_mps": 12.0, "reverse": reverse}
    config = world([], [], drive=bend)
    street = build_street(config.street, rng_for(3, "street"))
    route = route_along(street.centerline_m, street.network.route.closed)
    motion = Motion(config.drive, route, None, CarConfig())
    assert duration_s(config, 3) == motion.plan.duration_s > 5.0  # slower in the bend


def test_a_scenario_is_checked_when_its_seed_is_known() -> None:
    late = ["faults=[{kind: black, camera: rear, at_s: 3599}]"]
    assert load_scenario("first_drive", late)
    with pytest.raises(InputError, match=r"^--set: faults\[0\]\.at_s: got 3599, wanted 0 to \d"):
        load_scenario("first_drive", late, seed=0)
