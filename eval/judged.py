"""What ``run`` and ``replay`` do around their work: console, summary, exit code of a failed estimator."""

from __future__ import annotations

import sys
from collections.abc import Callable

import typer

from eval.console import Console, open_console
from eval.estimate import EstimatorError
from eval.judge import RunResult
from eval.summary import print_summary


def judged(work: Callable[[Console], RunResult], *, quiet: bool, verbose: bool) -> None:
    """Do the work and print its summary; a failed estimator is one line and exit code 1."""
    try:
        with open_console(quiet=quiet, verbose=verbose) as console:
            result = work(console)
    except EstimatorError as failure:
        print(f"error: the estimator {failure}", file=sys.stderr)
        raise typer.Exit(1) from None
    if not quiet:
        print_summary(result)
