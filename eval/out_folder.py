"""Put a result where the user wants it: checked before the work, and there only when it is whole."""

from __future__ import annotations

import errno
import glob
import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import psutil

from estimator.errors import InputError

RUNS = Path("reports/runs")


@contextmanager
def replacing_run_folder(out: Path) -> Iterator[Path]:
    """Yield a name to write a run folder to; it takes the place of ``out`` if the block ends well.

    Raises:
        InputError: ``out`` is something else than a run folder, or cannot be written.
    """
    if out.exists() and not _is_replaceable(out):
        raise InputError(f"{out}: exists and is no run folder (it has no scores.json); it is left as it is")
    with _publishing(out) as temporary:
        yield temporary


@contextmanager
def creating(out: Path) -> Iterator[Path]:
    """Yield a name to write to; it becomes ``out``, which must not exist, if the block ends well.

    Raises:
        InputError: ``out`` exists, or cannot be written.
    """
    if out.exists():
        raise InputError(f"{out}: exists; wanted a name that is free")
    with _publishing(out) as temporary:
        yield temporary


def make_folder(folder: Path) -> None:
    """Make a folder and its parents.

    Raises:
        InputError: It cannot be made or written.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        raise InputError(f"{folder}: cannot write this folder: {error.strerror}") from None


def _is_replaceable(out: Path) -> bool:
    return out.is_dir() and ((out / "scores.json").is_file() or not any(out.iterdir()))


@contextmanager
def _publishing(out: Path) -> Iterator[Path]:
    out = out.absolute()
    make_folder(out.parent)
    _remove_leftovers(out)
    workshop = out.with_name(f".{out.name}.partial-{os.getpid()}")
    workshop.mkdir()
    try:
        yield workshop / "new"
        if out.exists():
            out.rename(workshop / "old")
        (workshop / "new").rename(out)
    except OSError as error:
        if error.errno in (errno.ENOSPC, errno.EDQUOT) and error.filename is None:  # writing names no file
            raise InputError(f"{out}: cannot be written: {error.strerror}") from error
        raise
    finally:
        shutil.rmtree(workshop, ignore_errors=True)


def _remove_leftovers(out: Path) -> None:
    """Delete what processes that were killed left of earlier tries."""
    for leftover in out.parent.glob(f".{glob.escape(out.name)}.partial-*"):
        process = leftover.name.rpartition("-")[2]
        if process.isdigit() and (int(process) == os.getpid() or not psutil.pid_exists(int(process))):
            shutil.rmtree(leftover, ignore_errors=True)
