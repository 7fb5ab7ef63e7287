"""Every command once, on a drive of three tiny bundles."""

import json
from pathlib import Path

import pytest

from estimator.rig_file import read_rig
from tests.integration.conftest import Command

NOMINAL = "tests.throwaway_estimators:Nominal"
RUN_FILES = {
    "scores.json",
    "extrinsics.csv",
    "rig.yaml",
    "trajectory.tum",
    "truth.tum",
    "report.html",
    "events.jsonl",
}


def test_run_writes_a_run_folder_and_says_how_far_off(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command("run", tiny, "--estimator", NOMINAL) == 0
    folder = tmp_path / "reports" / "runs" / "tiny-0-tests.throwaway_estimators.Nominal"
    assert {path.name for path in folder.iterdir()} >= RUN_FILES
    out, err = capsys.readouterr()
    assert "worst" in out and "3.000" in out and "100.0" in out  # what the miscalibration is
    assert "report: reports/runs/tiny-0-" in out
    assert "estimating 3/3" in err
    scores = json.loads((folder / "scores.json").read_text())
    assert (scores["schema"], scores["scenario"], scores["seed"]) == (1, "tiny", 0)
    assert scores["provenance"]["versions"]["mujoco"] is not None


def test_run_replaces_an_older_run_and_quiet_says_nothing(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments = ("run", tiny, "--estimator", NOMINAL, "--out", tmp_path / "out", "--quiet")
    assert command(*arguments) == command(*arguments) == 0
    assert capsys.readouterr() == ("", "")
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_run_with_set_changes_the_recording(command: Command, tiny: str, tmp_path: Path) -> None:
    setting = ("--set", "miscalibration.rotation_deg=1", "--set", "drive.distance_m=0.5")
    assert command("run", tiny, "--estimator", NOMINAL, "--out", tmp_path / "out", *setting) == 0
    scores = json.loads((tmp_path / "out" / "scores.json").read_text())
    metrics = scores["metrics"]
    assert scores["settings"] == {"miscalibration.rotation_deg": 1, "drive.distance_m": 0.5}
    page = (tmp_path / "out" / "report.html").read_text()
    assert "set: miscalibration.rotation_deg=1, drive.distance_m=0.5" in page
    assert metrics["extrinsics.worst.rotation_deg"]["value"] == pytest.approx(1.0, abs=1e-3)


def test_a_recorded_drive_replays_with_the_same_answers(command: Command, tiny: str, tmp_path: Path) -> None:
    bag, rig = tmp_path / "drive", tmp_path / "drive.rig.yaml"
    assert command("record", tiny, "--out", bag) == 0
    assert command("replay", bag, "--rig", rig, "--estimator", NOMINAL, "--out", tmp_path / "replayed") == 0
    assert command("run", tiny, "--estimator", NOMINAL, "--out", tmp_path / "ran") == 0
    for name in ("rig.yaml", "extrinsics.csv", "trajectory.tum", "truth.tum"):
        assert (tmp_path / "replayed" / name).read_bytes() == (tmp_path / "ran" / name).read_bytes()
    scores = json.loads((tmp_path / "replayed" / "scores.json").read_text())
    assert (scores["scenario"], scores["seed"]) == ("drive", None)


def test_two_recordings_called_bag_keep_their_own_results(
    command: Command, tiny: str, tmp_path: Path
) -> None:
    for folder in ("first", "second"):
        (tmp_path / folder).mkdir()
        bag = tmp_path / folder / "bag"
        assert command("record", tiny, "--out", bag) == 0
        assert command("replay", bag, "--rig", f"{bag}.rig.yaml", "--estimator", NOMINAL) == 0
    name = "bag-tests.throwaway_estimators.Nominal"
    runs = tmp_path / "reports" / "runs"
    assert {path.name for path in runs.iterdir()} == {f"first-{name}", f"second-{name}"}


def test_report_is_built_again(command: Command, tiny: str, tmp_path: Path) -> None:
    assert command("run", tiny, "--estimator", NOMINAL, "--out", tmp_path / "out") == 0
    report = tmp_path / "out" / "report.html"
    before = report.read_bytes()
    report.unlink()
    assert command("report", tmp_path / "out") == 0
    assert report.read_bytes() == before


@pytest.mark.parametrize(
    ("topic", "expected"),
    [
        ("scenarios", "first_drive"),
        ("sweeps", "five seeds"),
        ("rigs", "left_front, right_front"),
        ("estimators", "estimator.online:OnlineEstimator"),
        ("metrics", "extrinsics.worst.rotation_deg.at_10m"),
    ],
)
def test_list_tells_what_there_is(
    command: Command, capsys: pytest.CaptureFixture[str], topic: str, expected: str
) -> None:
    assert command("list", topic) == 0
    assert expected in capsys.readouterr().out


def test_doctor_finds_this_machine_well(command: Command, capsys: pytest.CaptureFixture[str]) -> None:
    assert command("doctor") == 0
    assert "all is well" in capsys.readouterr().out


def test_run_with_the_own_estimator_answers_for_every_camera(
    command: Command, tiny: str, house: Path, tmp_path: Path
) -> None:
    assert command("run", tiny, "--out", tmp_path / "out") == 0
    assert set(read_rig(tmp_path / "out" / "rig.yaml").cameras) == set(
        read_rig(house / "tiny_rig.yaml").cameras
    )


def test_help_lists_every_command(command: Command, capsys: pytest.CaptureFixture[str]) -> None:
    assert command("--help") == 0
    out = capsys.readouterr().out
    assert all(name in out for name in ("run", "record", "replay", "sweep", "report", "list", "doctor"))
