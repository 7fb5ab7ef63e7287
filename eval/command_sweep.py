"""``rigtrue sweep``: many runs, resumable."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Annotated

import typer

from eval.options import Quiet, Verbose


def sweep_command(
    sweep: Annotated[str, typer.Argument(metavar="SWEEP", help="A bundled name or a YAML file.")],
    workers: Annotated[int, typer.Option(min=1, help="Runs at a time.")] = os.cpu_count() or 1,
    out: Annotated[
        Path | None, typer.Option(metavar="DIR", help="Sweep folder; default reports/sweeps/<name>.")
    ] = None,
    quiet: Quiet = False,
    verbose: Verbose = False,
) -> None:
    """Run every scenario with every seed and estimator; started again, it goes on where it stopped."""
    from eval import sweep as sweep_story
    from eval.console import open_console
    from eval.print_table import print_table
    from eval.sweep_results import summary_rows

    with open_console(quiet=quiet, verbose=verbose) as console:
        result = sweep_story.sweep(sweep, workers, out, console)
    if not quiet:
        columns = ("scenario", "estimator", "seed", "worst_rotation_deg", "worst_translation_mm", "")
        print_table(columns, summary_rows(result.rows), right=columns[2:5])
        print(f"results: {result.folder / 'results.parquet'}")
    if result.failure_count:
        print(f"error: {result.failure_count} runs failed; see the reasons above", file=sys.stderr)
        raise typer.Exit(1)
