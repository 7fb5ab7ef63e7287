"""``rigtrue record --video``: a film that plays, or none at all."""

from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.integration.conftest import Command


def test_record_films_every_bundle_in_real_time(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert command("record", tiny, "--out", "drive", "--video", "drive.mp4") == 0
    assert "film: drive.mp4" in capsys.readouterr().out
    film = cv2.VideoCapture(str(tmp_path / "drive.mp4"))
    assert (film.get(cv2.CAP_PROP_FPS), film.get(cv2.CAP_PROP_FRAME_COUNT)) == (10.0, 3.0)
    assert int(film.get(cv2.CAP_PROP_FOURCC)).to_bytes(4, "little") in (b"avc1", b"h264")
    pictures = [film.read()[1] for _ in range(3)]
    assert all(picture.std() > 15 for picture in pictures)
    assert np.abs(pictures[0].astype(int) - pictures[2]).mean() > 0.5  # the car moves
    assert sorted(path.name for path in tmp_path.iterdir()) == ["drive", "drive.mp4", "drive.rig.yaml"]


@pytest.mark.parametrize(
    ("video", "message"),
    [
        ("drive.avi", "drive.avi: wanted a name that ends in .mp4"),
        ("taken.mp4", "taken.mp4: exists; wanted a name that is free"),
    ],
)
def test_a_wrong_name_is_refused_before_anything_is_rendered(
    command: Command, tiny: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], video: str, message: str
) -> None:
    (tmp_path / "taken.mp4").touch()
    assert command("record", tiny, "--out", "drive", "--video", video) == 2
    err = capsys.readouterr().err
    assert message in err and err.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["taken.mp4"]


def test_a_film_that_fails_leaves_neither_film_nor_bag(
    command: Command, tiny: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def break_off(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("eval.video.pictures", break_off)
    assert command("record", tiny, "--out", "drive", "--video", "drive.mp4") == 130
    assert list(tmp_path.iterdir()) == []
