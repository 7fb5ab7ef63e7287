"""Sweep files."""

from pathlib import Path

import pytest

from estimator.errors import InputError
from scenarios.sweep import SweepRun, load_sweep

GOOD = "about: A sweep.\nscenarios: [first_drive]\nseeds: [2, 0]\nestimators: [a, b]\n"


def write(folder: Path, text: str) -> str:
    path = folder / "some.yaml"
    path.write_text(text)
    return str(path)


def test_a_sweep_is_every_combination_in_order(tmp_path: Path) -> None:
    sweep = load_sweep(write(tmp_path, GOOD))
    assert sweep.runs[:3] == (
        SweepRun("first_drive", 2, "a"),
        SweepRun("first_drive", 2, "b"),
        SweepRun("first_drive", 0, "a"),
    )
    assert len(sweep.expanded()["runs"]) == 4


def test_a_run_named_twice_is_run_once(tmp_path: Path) -> None:
    assert len(load_sweep(write(tmp_path, GOOD.replace("[2, 0]", "[1, 1]"))).runs) == 2


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("seeds: [2, 0]", "seeds: []", "seeds: got 0 values, wanted 1"),
        ("seeds: [2, 0]", "seeds: [-1]", "seeds[0]: got -1, wanted greater than or equal to 0"),
        ("seeds: [2, 0]", "seeds: [1.5]", "seeds[0]: got 1.5, wanted an integer"),
        ("seeds: [2, 0]", "sedes: [1]", "sedes: unknown key; there are: about, estimators, scenarios, seeds"),
        ("[first_drive]", "[nope]", "scenarios: scenario 'nope' is not known"),
        ("[first_drive]", "[first_drive, ./first_drive.yaml]", "two are called 'first_drive'"),
    ],
)
def test_a_wrong_sweep_is_one_line(tmp_path: Path, old: str, new: str, message: str) -> None:
    (tmp_path / "first_drive.yaml").write_text("base: first_drive\nabout: A copy.\n")
    with pytest.raises(InputError) as error:
        load_sweep(write(tmp_path, GOOD.replace(old, new)))
    assert message in str(error.value)
