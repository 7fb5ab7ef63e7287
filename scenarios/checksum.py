"""A SHA-256 beside a recording: bags carry no checksum of their own, so a flipped byte would read as good."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

_FILE = "sha256.json"


def write_checksum(folder: Path) -> None:
    """Write the digests of every file below a folder into it."""
    (folder / _FILE).write_text(json.dumps(_digests(folder), indent=1, sort_keys=True))


def checksum_holds(folder: Path) -> bool:
    """Tell whether a folder holds exactly the files it was written with, byte for byte."""
    try:
        written = json.loads((folder / _FILE).read_text())
    except (OSError, ValueError):
        return False
    return bool(written == _digests(folder))


def folder_digest(folder: Path) -> str:
    """Return one SHA-256 over the names and bytes of all files below a folder, or over a single file."""
    return hashlib.sha256(json.dumps(_digests(folder), sort_keys=True).encode()).hexdigest()


def _digests(folder: Path) -> dict[str, str]:
    files = [folder] if folder.is_file() else sorted(path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): _sha256(path) for path in files if path.name != _FILE}


def _sha256(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
