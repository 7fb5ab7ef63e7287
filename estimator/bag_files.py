"""Which files make up a bag, and what is wrong with a path that is none."""

from __future__ import annotations

import re
from pathlib import Path

from estimator.errors import InputError

_MCAP_MAGIC = b"\x89MCAP0\r\n"
_SQLITE_MAGIC = b"SQLite format 3\x00"
_SUFFIXES = (".mcap", ".db3")


def storage_files(path: Path) -> list[Path]:
    """Return the storage files of a bag, in the order they were written.

    Raises:
        InputError: There is nothing, or nothing that could be a bag.
    """
    if not path.exists():
        raise InputError(f"{path}: no such recording")
    if path.is_file():
        return [path]
    files = [each for each in path.iterdir() if each.suffix in _SUFFIXES]
    if not files and not (path / "metadata.yaml").is_file():
        there = ", ".join(sorted(each.name for each in path.iterdir())[:5]) or "nothing"
        raise InputError(f"{path}: got a folder with {there}, wanted a ROS 2 bag: *.mcap, metadata.yaml")
    if not files:
        raise InputError(f"{path}: got metadata.yaml without a recording beside it, wanted *.mcap or *.db3")
    return sorted(files, key=lambda each: [int(part) for part in re.findall(r"\d+", each.stem)])


def begins_as_mcap(file: Path) -> bool:
    """Tell whether a file's first bytes are those of MCAP."""
    with file.open("rb") as stream:
        return stream.read(len(_MCAP_MAGIC)) == _MCAP_MAGIC


def ends_as_mcap(file: Path) -> bool:
    """Tell whether a file's last bytes are those of MCAP, and are not its first."""
    with file.open("rb") as stream:
        if stream.seek(0, 2) < 2 * len(_MCAP_MAGIC):
            return False
        stream.seek(-len(_MCAP_MAGIC), 2)
        return stream.read() == _MCAP_MAGIC


def explain_unreadable(file: Path, reason: str) -> str:
    """Say why a file is no recording, from its first bytes; ``reason`` is the reader's own word."""
    with file.open("rb") as stream:
        start = stream.read(16)
    if not start:
        return "got an empty file, wanted a ROS 2 bag (MCAP)"
    if start.startswith((_MCAP_MAGIC, _SQLITE_MAGIC)):
        return f"got a file that is no ROS 2 bag: {reason}"
    if start.startswith(b"#ROSBAG V"):
        return "got a ROS 1 bag, wanted a ROS 2 bag (MCAP); `rosbags-convert` turns one into the other"
    return "got a file of another type, wanted a ROS 2 bag (MCAP)"
