"""Rendered recordings, kept under the user's cache folder so that the same digest renders once.

A recording lives in ``<digest>/`` with the SHA-256 of its files beside it, checked on every use. One lock
file a digest lets concurrent workers wait for each other; readers hold it shared, so that nobody evicts
under them. Rendering goes to a temporary name that is renamed when whole.
"""

from __future__ import annotations

import fcntl
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from estimator.errors import InputError
from scenarios.checksum import checksum_holds, write_checksum

_DEFAULT_CAP_GB = 20.0
_BAG = "bag"


@dataclass(frozen=True)
class RecordingCache:
    """A folder of recordings and the size it may reach."""

    folder: Path
    cap_bytes: int

    @staticmethod
    def of_user() -> RecordingCache:
        """Return the cache that the environment names, else ``~/.cache/rigtrue`` of at most 20 GB."""
        home = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
        folder = Path(os.environ.get("RIGTRUE_CACHE") or Path(home) / "rigtrue").expanduser()
        return RecordingCache(folder.absolute(), int(_cap_gb() * 1e9))

    @contextmanager
    def recording(self, digest: str, render: Callable[[Path], None]) -> Iterator[Path]:
        """Yield the bag of a digest, rendered now if it is not there whole; it stays while the block runs.

        Args:
            digest: Names the recording.
            render: Writes the bag to the path it is given.

        Raises:
            InputError: The cache folder cannot be written.
        """
        self._make_folder()
        entry = self.folder / digest
        with (self.folder / f"{digest}.lock").open("a") as lock:
            fcntl.flock(lock, fcntl.LOCK_SH)
            while not checksum_holds(entry):
                fcntl.flock(lock, fcntl.LOCK_EX)
                if not checksum_holds(entry):  # another process may have rendered it while this one waited
                    self._render_into(entry, render)
                    self._evict(keep=digest)
                fcntl.flock(lock, fcntl.LOCK_SH)  # not atomic, so look again
            os.utime(entry)
            yield entry / _BAG

    def newest(self, prefix: str) -> str | None:
        """Return the name of the last used recording whose name begins like this; None without one.

        Whether it is whole is seen when it is used.
        """
        entries = (path for path in self.folder.glob(f"{prefix}*") if path.is_dir() and not path.suffix)
        last = max(entries, key=lambda path: path.stat().st_mtime, default=None)
        return None if last is None else last.name

    def used_bytes(self) -> int:
        """Return the size of all recordings."""
        return sum(_size_bytes(path) for path in self._entries())

    def _entries(self) -> list[Path]:
        return [path for path in self.folder.iterdir() if path.is_dir() and not path.suffix]

    def _make_folder(self) -> None:
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
            writable = os.access(self.folder, os.W_OK)
        except OSError:
            writable = False
        if not writable:
            raise InputError(
                f"{self.folder}: cannot write the cache; set RIGTRUE_CACHE to a folder that can be"
            )

    def _render_into(self, entry: Path, render: Callable[[Path], None]) -> None:
        partial = entry.with_suffix(".partial")
        shutil.rmtree(partial, ignore_errors=True)  # left by a process that was killed
        shutil.rmtree(entry, ignore_errors=True)  # damaged
        try:
            partial.mkdir()
            render(partial / _BAG)
            write_checksum(partial)
            partial.rename(entry)
        finally:
            shutil.rmtree(partial, ignore_errors=True)

    def _evict(self, keep: str) -> None:
        """Delete least recently used recordings until the rest fits; those in use stay.

        What processes that were killed while rendering left behind goes first: it is in nobody's size.
        """
        for leftover in self.folder.glob("*.partial"):
            _remove_unused(leftover)
        sizes = {path: _size_bytes(path) for path in self._entries()}
        total = sum(sizes.values())
        for entry in sorted(sizes, key=lambda path: path.stat().st_mtime):
            if total <= self.cap_bytes:
                return
            if entry.name != keep and _remove_unused(entry):
                total -= sizes[entry]


def _remove_unused(entry: Path) -> bool:
    """Delete a recording, whole or partial, unless somebody holds its lock; tell whether it went."""
    with entry.with_suffix(".lock").open("a") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            return False
        shutil.rmtree(entry, ignore_errors=True)
        return True


def _size_bytes(folder: Path) -> int:
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def _cap_gb() -> float:
    text = os.environ.get("RIGTRUE_CACHE_GB", "")
    try:
        value = float(text or _DEFAULT_CAP_GB)
    except ValueError:
        value = -1.0
    if not value >= 0:
        raise InputError(f"RIGTRUE_CACHE_GB: got {text!r}, wanted a number of gigabytes")
    return value
