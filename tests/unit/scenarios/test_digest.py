"""The digest of a recording: what changes it, and what must not."""

import re
import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from scenarios.digest import recording_digest
from scenarios.load import load_scenario
from scenarios.source_digest import HOUSE, VOCABULARY, source_digest


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


@pytest.fixture
def house(tmp_path: Path) -> Path:
    """A copy of the sources that may be changed."""
    for room in ("sim", "estimator"):
        shutil.copytree(HOUSE / room, tmp_path / room, ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def test_the_code_that_makes_a_recording_changes_its_digest(monkeypatch: pytest.MonkeyPatch) -> None:
    scenario = load_scenario("first_drive")
    before = recording_digest(scenario, 0)
    monkeypatch.setattr("scenarios.digest._source", lambda: "other")
    assert recording_digest(scenario, 0) != before


@pytest.mark.parametrize(
    "name", ["sim/light/sky.py", "sim/rendering/classic.py", "estimator/distortion.py", "estimator/se3.py"]
)
def test_a_change_to_the_simulator_or_its_vocabulary_changes_the_source_digest(
    house: Path, name: str
) -> None:
    assert source_digest(house) == source_digest()
    with (house / name).open("a") as file:
        file.write("CHANGED = True\n")
    assert source_digest(house) != source_digest()


def test_a_new_file_of_the_simulator_changes_the_source_digest(house: Path) -> None:
    (house / "sim" / "snow.py").touch()
    assert source_digest(house) != source_digest()


@pytest.mark.parametrize("name", ["online", "window", "tracker"])
def test_a_change_to_the_estimator_renders_nothing_again(house: Path, name: str) -> None:
    with (house / "estimator" / f"{name}.py").open("a") as file:
        file.write("CHANGED = True\n")
    assert source_digest(house) == source_digest()


def test_the_vocabulary_is_all_that_the_simulator_imports_of_the_estimator() -> None:
    todo, found = [*(HOUSE / "sim").rglob("*.py")], set()
    while todo:
        for name in re.findall(r"^\s*(?:from|import) estimator\.(\w+)", todo.pop().read_text(), re.MULTILINE):
            if name not in found:
                found.add(name)
                todo.append(HOUSE / "estimator" / f"{name}.py")
    assert {f"estimator/{name}.py" for name in found} == set(VOCABULARY)
