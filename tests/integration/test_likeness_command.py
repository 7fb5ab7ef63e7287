"""``rigtrue likeness``: on a folder of frames and on a recording, and what may be wrong with them."""

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.integration.conftest import Command
from tests.unit.eval.test_likeness import passing_texture


@pytest.fixture
def frames(tmp_path: Path) -> Path:
    folder = tmp_path / "frames"
    folder.mkdir()
    for index, frame in enumerate(passing_texture()):
        cv2.imwrite(str(folder / f"{index:03}.png"), frame)
    return folder


def test_a_folder_of_frames_is_compared_with_the_real_drives(
    command: Command, frames: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command("likeness", frames, "--rows", "0:120") == 0
    out = capsys.readouterr().out
    assert "contrast_std" in out and "55 .. 72" in out and "outside" in out and "17 frames" in out


def test_json_holds_mean_spread_and_verdict(
    command: Command, frames: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command("likeness", frames, "--rows", "0:120", "--json") == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["frames"], result["size_px"]) == (17, [240, 120])
    slope = result["statistics"]["spectrum_slope"]
    assert slope["p10"] <= slope["mean"] <= slope["p90"] and slope["mean_inside"] is False


def test_a_recording_gives_its_frames_by_the_metre(
    command: Command, tiny: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command("record", tiny, "--out", "drive", "--set", "drive.distance_m=14") == 0
    capsys.readouterr()
    assert command("likeness", "drive", "--rows", "8:32", "--json") == 0
    assert json.loads(capsys.readouterr().out)["frames"] == 15  # at both ends and every metre between


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("none", "none: no such folder"),
        ("frames --rows 81:320", "frames: got frames of 120 rows, wanted rows 81:320"),
        ("frames --rows 81", "--rows: got '81', wanted A:B"),
        ("frames --rows 0:100 --step 2", "frames: got 9 frames, wanted at least 12"),
        ("empty", "empty: got an empty folder, wanted frames of one forward camera"),
        ("mixed --rows 0:120", "mixed: got frames of several sizes"),
    ],
)
def test_a_wrong_request_is_one_line(
    command: Command,
    frames: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: str,
    message: str,
) -> None:
    (tmp_path / "empty").mkdir()
    (tmp_path / "mixed").mkdir()
    for name, rows in (("a", 120), ("b", 60)):
        cv2.imwrite(str(tmp_path / "mixed" / f"{name}.png"), np.zeros((rows, 80), np.uint8))
    assert command("likeness", *arguments.split()) == 2
    out, err = capsys.readouterr()
    assert out == "" and message in err and err.count("\n") == 1
