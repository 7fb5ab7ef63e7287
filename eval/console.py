"""Tell the user how far the work is: bars on a terminal, a plain line now and then elsewhere, or nothing.

Everything goes to standard error; results go to standard output.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

_PLAIN_EVERY_S = 5.0


class Console(Protocol):
    """What a command tells while it works."""

    def progress(self, stage: str, done: int, total: int) -> None:
        """Say that ``done`` of ``total`` steps of a stage are done."""

    def say(self, line: str) -> None:
        """Say something that everybody should read."""

    def detail(self, line: str) -> None:
        """Say something that only who asked for more should read."""


class QuietConsole:
    """Says nothing."""

    def progress(self, stage: str, done: int, total: int) -> None:
        pass

    def say(self, line: str) -> None:
        pass

    def detail(self, line: str) -> None:
        pass


class PlainConsole:
    """Lines for a log: the first and last step of a stage, and one every few seconds."""

    def __init__(self, verbose: bool) -> None:
        self._verbose = verbose
        self._stage = ""
        self._next_s = 0.0

    def progress(self, stage: str, done: int, total: int) -> None:
        now_s = time.monotonic()
        if stage != self._stage or done >= total or now_s >= self._next_s:
            self._stage, self._next_s = stage, now_s + _PLAIN_EVERY_S
            self.say(f"{stage} {done}/{total}")

    def say(self, line: str) -> None:
        print(line, file=sys.stderr, flush=True)

    def detail(self, line: str) -> None:
        if self._verbose:
            self.say(line)


@contextmanager
def open_console(*, quiet: bool, verbose: bool) -> Iterator[Console]:
    """Yield the console that fits where standard error goes."""
    if quiet:
        yield QuietConsole()
    elif sys.stderr.isatty():
        from eval.console_bars import BarConsole  # loads rich, which plain lines do not need

        with BarConsole(verbose) as bars:
            yield bars
    else:
        yield PlainConsole(verbose)
