"""``rigtrue list scenarios --contact-sheet``: a picture of real glimpses, or one line why not."""

from collections.abc import Iterator
from pathlib import Path

import cv2
import pytest

from estimator.errors import InputError
from eval.console import QuietConsole
from eval.contact_sheet import write_contact_sheet
from eval.glimpse import take_glimpse
from sim.world import Snapshot
from tests.integration.conftest import Command


def test_a_sheet_shows_rendered_images(tiny: str, tmp_path: Path) -> None:
    write_contact_sheet([tiny], tmp_path / "sheet.png", 1, QuietConsole())
    sheet = cv2.imread(str(tmp_path / "sheet.png"))
    assert sheet is not None and sheet[22:242, 22:374].std() > 15
    assert [path.name for path in tmp_path.iterdir()] == ["sheet.png"]


def test_what_this_machine_cannot_draw_is_an_empty_glimpse(
    tiny: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def lack_a_renderer(*_: object) -> Iterator[Snapshot]:
        raise InputError("no such renderer here")
        yield

    monkeypatch.setattr("sim.simulate.simulate", lack_a_renderer)
    glimpse = take_glimpse(tiny)
    assert glimpse.images == {} and glimpse.about.startswith("Three bundles")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ("scenarios --contact-sheet sheet.gif", "sheet.gif: wanted a name that ends in .png or .jpg"),
        ("scenarios --contact-sheet taken.png", "taken.png: exists; wanted a name that is free"),
        ("rigs --contact-sheet sheet.png", "--contact-sheet: got rigs to list, wanted scenarios"),
    ],
)
def test_a_wrong_request_is_one_line(
    command: Command, tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: str, message: str
) -> None:
    (tmp_path / "taken.png").touch()
    assert command("list", *arguments.split()) == 2
    out, err = capsys.readouterr()
    assert out == "" and message in err and err.count("\n") == 1
    assert [path.name for path in tmp_path.iterdir()] == ["taken.png"]
