"""The digest of a recording: what changes it, and what must not."""

from dataclasses import replace

import pytest

from scenarios.digest import recording_digest
from scenarios.load import load_scenario


def test_name_and_about_leave_the_digest_alone() -> None:
    scenario = load_scenario("first_drive")
    renamed = replace(scenario, name="other", about="Other words.")
    assert recording_digest(renamed, 3) == recording_digest(scenario, 3)


def test_an_int_and_a_float_of_one_value_are_one_recording() -> None:
    as_int, as_float = (load_scenario("first_drive", [f"drive.speed_mps={text}"]) for text in ("6", "6.0"))
    assert recording_digest(as_int, 0) == recording_digest(as_float, 0)


def test_the_seed_changes_the_digest() -> None:
    scenario = load_scenario("first_drive")
    assert recording_digest(scenario, 0) != recording_digest(scenario, 1)


@pytest.mark.parametrize(
    "setting",
    [
        "street.length_m=71",
        "drive.speed_mps=6",
        "drive.distance_m=49",
        "drive.rate_hz=11",
        "miscalibration.rotation_deg=2",
        "miscalibration.translation_mm=90",
        "weather.sun_elevation_deg=41",
        "weather.sun_azimuth_deg=61",
        "sensor.noise=0.9",
    ],
)
def test_every_knob_changes_the_digest(setting: str) -> None:
    plain, changed = load_scenario("first_drive"), load_scenario("first_drive", [setting])
    assert recording_digest(plain, 0) != recording_digest(changed, 0)


def test_the_rig_changes_the_digest() -> None:
    scenario = load_scenario("first_drive")
    fewer = {name: mounted for name, mounted in scenario.rig.cameras.items() if name != "rear"}
    smaller = replace(scenario, rig=replace(scenario.rig, cameras=fewer))
    assert recording_digest(smaller, 0) != recording_digest(scenario, 0)


def test_the_version_of_the_world_changes_the_digest(monkeypatch: pytest.MonkeyPatch) -> None:
    scenario = load_scenario("first_drive")
    before = recording_digest(scenario, 0)
    monkeypatch.setattr("scenarios.digest.WORLD_VERSION", -1)
    assert recording_digest(scenario, 0) != before
