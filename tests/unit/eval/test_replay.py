"""The name that a replayed recording gives to its result."""

from __future__ import annotations

from pathlib import Path

import pytest

from eval.replay import recording_name


@pytest.mark.parametrize(
    ("bag", "name"),
    [
        ("drives/monday", "monday"),
        ("drives/monday/monday_0.mcap", "monday_0.mcap"),
        ("drives/monday/bag", "monday-bag"),
        ("drives/monday/bag.mcap", "monday-bag.mcap"),
        ("drives/monday/bag/bag.mcap", "monday-bag-bag.mcap"),
        ("drives/monday/bag_0/bag_0.mcap", "monday-bag_0-bag_0.mcap"),
        ("../bag", "own-bag"),
        ("/bag", "bag"),
    ],
)
def test_a_recording_called_bag_is_named_by_its_folder_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, bag: str, name: str
) -> None:
    (tmp_path / "own" / "here").mkdir(parents=True)
    monkeypatch.chdir(tmp_path / "own" / "here")
    assert recording_name(Path(bag)) == name
